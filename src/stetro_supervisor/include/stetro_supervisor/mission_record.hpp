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
#ifndef STETRO_SUPERVISOR__MISSION_RECORD_HPP_
#define STETRO_SUPERVISOR__MISSION_RECORD_HPP_

#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

#include "stetro_supervisor/climb_state.hpp"

namespace stetro_supervisor
{

/// Which part of a tread base_link has passed over, as distances from the right wall [m].
struct Swept
{
  double y_min_m = 0.0;
  double y_max_m = 0.0;
  bool started = false;

  void pass(double y_m);

  /// Share of the width that the robot's contact width passed over, 0 to 1. A robot cannot sweep
  /// more than the tread, so what the pose's error adds beyond 1 is left out.
  double share(double width_m, double contact_width_m) const;
};

/// The mission as it survives a restart of the supervisor (D3-15).
struct MissionRecord
{
  bool active = false;     ///< a mission is under way
  std::string segment_id;  ///< the flight it cleans; on a journey the floor or flight it is on
  std::string request_id;  ///< the request that started it, and who asked
  std::string issuer;
  State state = State::kIdle;  ///< the last state in which the robot worked
  int step = 0;                ///< tread block 2 stands on
  Leg leg = Leg::kFirst;       ///< next part of this tread's sweep
  double rolled_m = 0.0;       ///< rolled on towards the next riser, for the top that has none [m]
  std::vector<Swept> swept;    ///< of tread 1..N
  std::string goal;            ///< the segment a journey goes to; empty: it cleans one flight
};

/// A file that is damaged or not a mission.
class MissionFileError : public std::runtime_error
{
public:
  using std::runtime_error::runtime_error;
};

/// The record as lines of text; exact for every double.
std::string encode(const MissionRecord & record);

/// \throws MissionFileError naming the first line not understood
MissionRecord decode(const std::string & text);

/// Replaces the file whole, as stetro_config::KeptFile does.
/// \throws MissionFileError with the path and the system's reason
void save(const MissionRecord & record, const std::string & path);

/// Nothing if there is no such file. \throws MissionFileError if it is damaged
std::optional<MissionRecord> load_mission(const std::string & path);

}  // namespace stetro_supervisor

#endif  // STETRO_SUPERVISOR__MISSION_RECORD_HPP_
