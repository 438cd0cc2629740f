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

#ifndef STETRO_BRINGUP__SERIES_REPORT_HPP_
#define STETRO_BRINGUP__SERIES_REPORT_HPP_

#include <iosfwd>
#include <string>
#include <vector>

#include "stetro_bringup/summary.hpp"

namespace stetro_bringup
{

/// Sums up runs that differ in their seeds alone.
class SeriesReport
{
public:
  void add(const ClimbOutcome & outcome) { runs_.push_back(outcome); }

  /// No run falls short of anything, and there was one.
  [[nodiscard]] bool succeeded() const;

  /// The series as `series.json`: SI units in the key names, null for what is not known.
  [[nodiscard]] std::string json() const;

  /// The series for a reader, with every shortfall.
  void print(std::ostream & out) const;

private:
  std::vector<ClimbOutcome> runs_;
};

}  // namespace stetro_bringup

#endif  // STETRO_BRINGUP__SERIES_REPORT_HPP_
