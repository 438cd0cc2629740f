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
#include "mission_store.hpp"

#include <cmath>

namespace stetro_supervisor
{
namespace
{

constexpr double kRolledStep_m = 0.01;  // the top is found by the roll, so the roll is kept too

}  // namespace

std::optional<MissionRecord> MissionStore::load(const Journey & journey)
{
  if (path_.empty()) {
    return std::nullopt;
  }
  try {
    const auto record = load_mission(path_);
    if (!record || !record->active) {
      return std::nullopt;
    }
    trouble_ = journey.misfit(*record);
    if (trouble_.empty()) {
      return record;
    }
  } catch (const MissionFileError & error) {
    trouble_ = error.what();
  }
  return std::nullopt;
}

void MissionStore::keep(const Journey & journey)
{
  const MissionRecord record = journey.record();
  const double rolled = record.rolled_m;
  const bool changed =
    !journey.transition().empty() || std::abs(rolled - kept_rolled_m_) >= kRolledStep_m;
  if (path_.empty() || !changed) {
    return;
  }
  try {
    save(record, path_);
    kept_rolled_m_ = rolled;
    trouble_.clear();
  } catch (const MissionFileError & error) {
    trouble_ = error.what();
  }
}

}  // namespace stetro_supervisor
