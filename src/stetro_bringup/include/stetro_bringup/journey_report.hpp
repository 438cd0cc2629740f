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

#ifndef STETRO_BRINGUP__JOURNEY_REPORT_HPP_
#define STETRO_BRINGUP__JOURNEY_REPORT_HPP_

#include <chrono>
#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "stetro_bringup/trace.hpp"
#include "stetro_site/frame_transform.hpp"
#include "stetro_site/site.hpp"

namespace stetro_bringup
{

/// The frames of a building's floors and flights, by their ids.
class SegmentFrames
{
public:
  explicit SegmentFrames(const stetro_site::Site & site);

  /// A pose in `map`; nothing if its segment is none of the building or a number is unknown.
  [[nodiscard]] std::optional<stetro_site::Pose> in_map(const StairSample & sample) const;

private:
  std::map<std::string, stetro_site::FrameTransform> frames_;
};

/// The localizer's pose passes from one segment's frame to another's.
struct SegmentChange
{
  std::string from;
  std::string to;
  double time_s = 0.0;  ///< since the first row
  /// How far the estimate moved in `map` less how far the robot did, along the floor [m].
  double jump_m = 0.0;
  double turn_rad = 0.0;  ///< the same of the heading
};

/// The robot was carried elsewhere.
struct Kidnap
{
  std::string segment;  ///< it found itself on
  double time_s = 0.0;  ///< since the first row
  double distance_m = 0.0;
  double turned_rad = 0.0;
  stetro_site::Pose from{};  ///< in `map`, as `to`
  stetro_site::Pose to{};
  /// Time in which the robot moved until the profile was against the estimate, or it was LOST [s];
  /// nothing: it stayed trusted.
  std::optional<double> noticed_after_s;
  /// Time from then until it was OK again, and right [s]; nothing: it did not happen.
  std::optional<double> relocalised_after_s;
};

/// What happens to the pose on a way through a building, by the truth.
/**
 * A truth that is farther from the one before than a robot drives is a kidnap. Rows in order of
 * time; without truth there is nothing to report.
 */
class JourneyReport
{
public:
  explicit JourneyReport(SegmentFrames frames) : frames_(std::move(frames)) {}

  void add(const TraceRow & row);

  [[nodiscard]] const std::vector<SegmentChange> & hand_overs() const { return hand_overs_; }
  [[nodiscard]] const std::vector<Kidnap> & kidnaps() const { return kidnaps_; }
  [[nodiscard]] const SegmentFrames & frames() const { return frames_; }

private:
  struct Moment
  {
    TraceRow row;
    std::optional<stetro_site::Pose> estimate;
    stetro_site::Pose truth;
  };

  void look_for_hand_over(const Moment & now);
  void look_for_kidnap(const Moment & now);
  void follow_kidnap(const Moment & now);
  [[nodiscard]] double since_start_s(const Moment & now) const;

  SegmentFrames frames_;
  std::vector<SegmentChange> hand_overs_;
  std::vector<Kidnap> kidnaps_;
  std::chrono::nanoseconds started_{0};
  std::optional<Moment> last_;
  double moved_s_ = 0.0;                 // since the last kidnap
  std::chrono::nanoseconds noticed_{0};  // the last kidnap
};

}  // namespace stetro_bringup

#endif  // STETRO_BRINGUP__JOURNEY_REPORT_HPP_
