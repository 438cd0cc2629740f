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
#ifndef STETRO_BRINGUP__TRACE_HPP_
#define STETRO_BRINGUP__TRACE_HPP_

#include <array>
#include <chrono>
#include <cstdint>
#include <iosfwd>
#include <map>
#include <optional>
#include <string>

namespace stetro_bringup
{

/// Where the robot is on a flight, as estimated or as simulated.
struct StairSample
{
  std::chrono::nanoseconds stamp{0};  ///< time of validity
  std::string segment{};     ///< flight or floor, whose frame the rest is in; empty unknown
  int step = -1;             ///< tread block 2 stands on, 0 the floor below, -1 unknown
  double x_m = 0.0;          ///< flight frame, up the stairs
  double y_m = 0.0;          ///< flight frame, from the right wall
  double z_m = 0.0;          ///< flight frame, up
  double heading_rad = 0.0;  ///< counter-clockwise from straight up the stairs
  double tread_x_m = 0.0;    ///< from the nosing of the tread block 2 stands on
  double tread_y_m = 0.0;    ///< from the right wall as it is here
};

/// One standard deviation of an estimate.
struct StairSigma
{
  double x_m = 0.0;
  double y_m = 0.0;
  double z_m = 0.0;
  double heading_rad = 0.0;
};

/// What one range sensor said and what the estimator made of it.
struct SensorTrace
{
  double range_m = 0.0;  ///< REP 117: -inf too near, +inf nothing in range, NaN no reading
  std::string outcome;   ///< fused, gated, stale, not_visible; empty: no answer yet
};

/// The range sensors in the order of the trace's columns.
inline constexpr std::array<const char *, 8> kTraceSensors = {
  "side_left",   "side_right",  "front_left",  "front_right",
  "stair_front", "block1_down", "block2_down", "block3_front"};

/// One estimate beside the truth at its time.
struct TraceRow
{
  StairSample estimate;
  StairSigma sigma;
  std::string integrity;  ///< OK, DEGRADED, LOST or UNKNOWN
  std::uint32_t reasons = 0;
  std::optional<StairSample> truth;  ///< nothing: no ground truth is published
  std::map<std::string, SensorTrace> sensors;
};

/// Writes a comma and a number with six decimals; nothing after the comma if it is not known (NaN).
void put_field(std::ostream & out, double value);

/// Writes `trace.csv`: a header, then a row an estimate, SI units in the column names.
/**
 * Numbers are printed with six decimals (a micrometre, a microradian), stamps in nanoseconds, so two
 * runs that computed the same print the same bytes. What is unknown is an empty field.
 */
class TraceWriter
{
public:
  /// \param out stays the caller's and must outlive the writer
  explicit TraceWriter(std::ostream & out);
  void write(const TraceRow & row);

private:
  std::ostream & out_;
};

}  // namespace stetro_bringup

#endif  // STETRO_BRINGUP__TRACE_HPP_
