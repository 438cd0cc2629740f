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

#include "stetro_supervisor/four_beams/azimuth.hpp"

#include "stetro_site/frame_transform.hpp"

namespace stetro_supervisor
{

namespace
{

constexpr double kPi = 3.14159265358979323846;

}  // namespace

double yaw_rad(double azimuth_rad)
{
  const double yaw = stetro_site::wrap_angle(kPi / 2.0 - azimuth_rad);
  return yaw == -kPi ? kPi : yaw;
}

double yaw_rad(Azimuth azimuth)
{
  return yaw_rad(static_cast<double>(position(azimuth)) * kPi / 2.0);
}

stetro_site::CellIndex from_paper(const stetro_site::OccupancyGrid & grid, PaperCell cell)
{
  return {cell.x, grid.rows() - 1 - cell.y};
}

PaperCell to_paper(const stetro_site::OccupancyGrid & grid, stetro_site::CellIndex cell)
{
  return {cell.column, grid.rows() - 1 - cell.row};
}

}  // namespace stetro_supervisor
