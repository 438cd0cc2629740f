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
#ifndef STETRO_BRINGUP__CLIMB_REPORT_HPP_
#define STETRO_BRINGUP__CLIMB_REPORT_HPP_

#include <iosfwd>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "stetro_bringup/error_statistics.hpp"
#include "stetro_bringup/trace.hpp"

namespace stetro_bringup
{

/// What the report needs to know of the staircase and the robot.
struct ReportFacts
{
  std::map<std::string, double> widths_m;  ///< W of each flight, between the walls, by the site [m]
  double contact_width_m = 0.0;            ///< R_w, bumper to bumper [m], D1-1
};

/// One tread, as a row of the papers' table 3, and beside it the error against the world.
struct StepRow
{
  std::string flight;
  int step = 0;
  double y_max_m = 0.0;          ///< largest estimate of y on this tread [m]
  double y_min_m = 0.0;          ///< smallest [m]
  double closure_error_m = 0.0;  ///< W - ((y_max - y_min) + R_w), S-B eq. (3) [m]
  std::size_t estimates = 0;
  ErrorStatistics y_error_m;          ///< tread-relative, over the whole tread
  ErrorStatistics x_error_m;          ///< tread-relative
  ErrorStatistics heading_error_rad;  ///< wrapped to (-pi, pi]
};

/// The errors of a whole climb.
struct ClimbErrors
{
  ErrorStatistics y_error_m;
  ErrorStatistics x_error_m;
  ErrorStatistics heading_error_rad;
  ErrorStatistics closure_error_m;  ///< one sample a tread
  std::size_t wrong_step = 0;       ///< estimates whose step was not the true one
};

/// Gathers a climb tread by tread.
/**
 * Eq. (3) says how well two contacts close and nothing about the error in between (D1-3), so both are
 * kept: the closure, and the error against the world while the tread is swept.
 */
class ClimbReport
{
public:
  explicit ClimbReport(const ReportFacts & facts);

  /// Takes an estimate made while `row.estimate.step` was being swept; a lost one says nothing.
  void add_sweeping(const TraceRow & row);

  /// Rows of the treads seen, in order.
  [[nodiscard]] const std::vector<StepRow> & steps() const { return steps_; }

  /// Sums up over the treads of steps(); truth is missing, so are the errors against it.
  [[nodiscard]] ClimbErrors errors() const;

private:
  StepRow & row_of(const std::string & flight, int step);

  ReportFacts facts_;
  std::vector<StepRow> steps_;
  ClimbErrors errors_;
};

/// Prints the table of steps for a reader: centimetres and degrees, as the papers do.
void print_table(std::ostream & out, const ClimbReport & report);

/// Writes `steps.csv`: a header, then a row a tread, SI units in the column names.
void write_steps_csv(std::ostream & out, const ClimbReport & report);

}  // namespace stetro_bringup

#endif  // STETRO_BRINGUP__CLIMB_REPORT_HPP_
