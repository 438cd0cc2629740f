// Copyright 2026 The sTetro Authors
//
// Licensed under the Apache License, Version 2.0 (the "License");
// you may not use this file except in compliance with the License.
// You may obtain a copy of the License at
//
//     http://www.apache.org/licenses/LICENSE-2.0
//
// Unless required by applicable law or agreed to in writing, software
// distributed under the License is distributed on an "AS IS" BASIS,
// WITHOUT WARRANTIES OR CONDITIONS OF ANY KIND, either express or implied.
// See the License for the specific language governing permissions and
// limitations under the License.

#ifndef ACCURACY__PLOT_TABLES_HPP_
#define ACCURACY__PLOT_TABLES_HPP_

#include <iosfwd>

#include "accuracy/estimator_totals.hpp"

namespace stetro_bringup
{

/// `<estimator>_treads.csv`: a header, then a row a tread, SI units in the column names.
void write_treads_csv(std::ostream & out, const EstimatorTotals & totals);

/// `<estimator>_histogram.csv`: a header, then a row a class of errors and the share of each.
void write_histogram_csv(std::ostream & out, const EstimatorTotals & totals);

}  // namespace stetro_bringup

#endif  // ACCURACY__PLOT_TABLES_HPP_
