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

#include <stdexcept>

#include "stetro_supervisor/floor/heading_tables.hpp"
#include "support/cell_room.hpp"

namespace stetro_supervisor
{

class HeadingTablesTest : public testing::Test
{
protected:
  std::shared_ptr<const stetro_site::OccupancyGrid> grid = CellRoom{}.grid();
  HeadingTables tables{*grid, 0.1};
};

TEST_F(HeadingTablesTest, AreBuiltNoFasterThanAsked)
{
  constexpr std::size_t kCells = 5000;
  constexpr std::size_t kOneBeam = 110;  // no beam of this room passes more cells
  int parts = 0;
  for (; !tables.is_built(1); ++parts) {
    EXPECT_THROW(static_cast<void>(tables.find({}, 1)), std::logic_error);
    const std::size_t passed = tables.build(1, kCells);
    ASSERT_GT(passed, 0u) << "gets nowhere";
    ASSERT_LE(passed, kCells + kOneBeam);
  }
  EXPECT_GT(parts, 5);
  EXPECT_EQ(tables.build(1, kCells), 0u) << "nothing is missing";
}

TEST_F(HeadingTablesTest, OneHeadingServesThoseAnEighthOfATurnOn)
{
  while (tables.build(1, 100000) > 0) {
  }
  const std::size_t eighth = tables.headings() / kScanBeams;
  EXPECT_TRUE(tables.is_built(1 + 3 * eighth));
  EXPECT_FALSE(tables.is_built(2));
}

}  // namespace stetro_supervisor
