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

#ifndef ACCURACY__ERROR_ROWS_HPP_
#define ACCURACY__ERROR_ROWS_HPP_

#include <vector>

#include "accuracy/estimator_totals.hpp"

namespace stetro_bringup
{

/// One line of a table of errors for a reader.
struct ErrorRow
{
  const char * name;
  const ErrorDistribution & errors;
  double scale;  ///< from SI to `unit`
  const char * unit;
};

/// The main errors of an estimator, in the order of the tables. They refer to `totals`.
[[nodiscard]] std::vector<ErrorRow> error_rows(const EstimatorTotals & totals);

}  // namespace stetro_bringup

#endif  // ACCURACY__ERROR_ROWS_HPP_
