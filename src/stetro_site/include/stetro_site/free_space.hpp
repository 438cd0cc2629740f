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

#ifndef STETRO_SITE__FREE_SPACE_HPP_
#define STETRO_SITE__FREE_SPACE_HPP_

#include <Eigen/Core>
#include <memory>
#include <vector>

#include "stetro_site/distance_field.hpp"
#include "stetro_site/floor.hpp"
#include "stetro_site/profile_caster.hpp"

namespace stetro_site
{

/// Where on a floor nothing stands, and how far the next wall is. Points are in the floor's frame.
/** Implementations are immutable after construction: one may be shared between threads. */
class FreeSpace
{
public:
  virtual ~FreeSpace() = default;

  /// Whether a point is on the floor and in no wall.
  [[nodiscard]] virtual bool is_free(const Eigen::Vector2d & point_m) const = 0;

  /// How far the nearest wall is from a point: 0 where it is not free, never more than it is [m].
  [[nodiscard]] virtual double clearance_m(const Eigen::Vector2d & point_m) const = 0;

protected:
  FreeSpace() = default;
  FreeSpace(const FreeSpace &) = default;
  FreeSpace & operator=(const FreeSpace &) = default;
};

/// Inside the outline and outside every obstacle. Exact, and takes time for each wall.
class PolygonFreeSpace : public FreeSpace
{
public:
  explicit PolygonFreeSpace(PolygonWalls walls);

  [[nodiscard]] bool is_free(const Eigen::Vector2d & point_m) const override;
  [[nodiscard]] double clearance_m(const Eigen::Vector2d & point_m) const override;

private:
  PolygonWalls walls_;
  std::vector<Segment> segments_;
};

/// The cells that are no wall. As exact as `DistanceField`, and takes the same time for any map.
class GridFreeSpace : public FreeSpace
{
public:
  /// \throws std::invalid_argument if there is no grid
  explicit GridFreeSpace(
    std::shared_ptr<const OccupancyGrid> grid, Unknown unknown = Unknown::kWall);

  [[nodiscard]] const DistanceField & distances() const noexcept { return distances_; }

  [[nodiscard]] bool is_free(const Eigen::Vector2d & point_m) const override;
  [[nodiscard]] double clearance_m(const Eigen::Vector2d & point_m) const override;

private:
  DistanceField distances_;
};

/// The free space of a floor as it is drawn; null if nobody has drawn it.
/** On a grid map unknown cells are walls. */
[[nodiscard]] std::unique_ptr<FreeSpace> free_space_of(const FloorDrawing & drawing);

}  // namespace stetro_site

#endif  // STETRO_SITE__FREE_SPACE_HPP_
