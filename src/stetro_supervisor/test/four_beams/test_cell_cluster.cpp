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

#include "stetro_supervisor/four_beams/cell_cluster.hpp"

namespace stetro_supervisor
{
namespace
{

using stetro_site::Cell;
using stetro_site::CellIndex;
using stetro_site::GridFrame;
using stetro_site::OccupancyGrid;

OccupancyGrid ten_by_ten(double yaw_rad)
{
  GridFrame frame;
  frame.columns = frame.rows = 10;
  frame.resolution_m = 0.5;
  frame.origin_m = {1.0, 2.0};
  frame.yaw_rad = yaw_rad;
  return OccupancyGrid(frame, std::vector<Cell>(100, Cell::kFree));
}

// Three cells in an angle and, apart from them, two that touch at a corner only.
const std::vector<CellIndex> kTwoClusters{{6, 5}, {1, 1}, {2, 1}, {7, 6}, {2, 2}};

TEST(CellCluster, MeasuresComponentsByHand)
{
  const auto found = clusters(ten_by_ten(0.0), kTwoClusters);
  ASSERT_EQ(found.size(), 2U);
  const CellCluster & angle = found[0];
  EXPECT_EQ(angle.cells, (std::vector<CellIndex>{{1, 1}, {2, 1}, {2, 2}}));
  EXPECT_EQ(angle.lowest, (CellIndex{1, 1}));
  EXPECT_EQ(angle.highest, (CellIndex{2, 2}));
  // Centres at 1.75 and 2.25 in x, 2.75 and 3.25 in y.
  EXPECT_NEAR(angle.centroid_m.x(), (1.75 + 2.25 + 2.25) / 3, 1e-12);
  EXPECT_NEAR(angle.centroid_m.y(), (2.75 + 2.75 + 3.25) / 3, 1e-12);
  EXPECT_TRUE(angle.extent_m.isApprox(Eigen::Vector2d(1.0, 1.0)));
  EXPECT_DOUBLE_EQ(angle.area_m2, 0.75);
  EXPECT_EQ(found[1].cells, (std::vector<CellIndex>{{6, 5}, {7, 6}}));
}

// A quarter turn about the origin (1, 2) takes (0.75, 0.75) + (1, 2) to (1, 2) + (-0.75, 0.75).
TEST(CellCluster, CentroidsLieInTheFloorsFrame)
{
  const auto found = clusters(ten_by_ten(1.5707963267948966), {{1, 1}});
  ASSERT_EQ(found.size(), 1U);
  EXPECT_TRUE(found[0].centroid_m.isApprox(Eigen::Vector2d(0.25, 2.75)));
}

TEST(CellCluster, CountsACellOnce)
{
  const auto found = clusters(ten_by_ten(0.0), {{3, 3}, {3, 3}});
  ASSERT_EQ(found.size(), 1U);
  EXPECT_EQ(found[0].cells.size(), 1U);
  EXPECT_TRUE(clusters(ten_by_ten(0.0), {}).empty());
  EXPECT_THROW(clusters(ten_by_ten(0.0), {{10, 0}}), std::invalid_argument);
}

}  // namespace
}  // namespace stetro_supervisor
