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

#include <gtest/gtest.h>

#include <set>
#include <string>

#include "stetro_supervisor/floor/drive_table.hpp"

namespace stetro_supervisor
{

TEST(DriveTable, HasARowForEveryStateInOrder)
{
  ASSERT_EQ(drive_table().size(), static_cast<std::size_t>(kDriveStateCount));
  std::set<std::string> names;
  for (int i = 0; i < kDriveStateCount; ++i) {
    EXPECT_EQ(drive_table()[static_cast<std::size_t>(i)].state, static_cast<DriveState>(i));
    names.insert(to_string(static_cast<DriveState>(i)));
  }
  EXPECT_EQ(names.size(), drive_table().size()) << "two states of one name";
}

TEST(DriveTable, EveryStateThatWorksHasATimeLimitThatEndsInAFault)
{
  for (const DriveRow & row : drive_table()) {
    const bool waits = row.state == DriveState::kHeld || row.state == DriveState::kPaused;
    EXPECT_EQ(row.limit_s != nullptr, row.works || waits) << to_string(row.state);
    EXPECT_EQ(row.on_limit != Fault::kNone, row.limit_s != nullptr) << to_string(row.state);
    EXPECT_NE(row.command, nullptr) << to_string(row.state);
  }
}

TEST(DriveTable, FaultsAreNamedOnTheWayToTheFaultStateAndNowhereElse)
{
  const auto judge = [](const DriveExit & exit) {
    EXPECT_EQ(exit.fault != Fault::kNone, exit.to == DriveState::kFault) << exit.when;
    EXPECT_NE(exit.guard, nullptr) << exit.when;
  };
  for (const DriveExit & exit : common_drive_exits()) {
    judge(exit);
  }
  for (const DriveRow & row : drive_table()) {
    for (const DriveExit & exit : row.exits) {
      judge(exit);
    }
  }
}

}  // namespace stetro_supervisor
