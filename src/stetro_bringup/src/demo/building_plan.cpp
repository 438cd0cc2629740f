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

#include "building_plan.hpp"

#include <Eigen/Core>
#include <ostream>
#include <variant>
#include <vector>

namespace stetro_bringup
{
namespace
{

void write_line(
  std::ostream & out, const stetro_site::FrameTransform & T_map_frame,
  const std::vector<Eigen::Vector3d> & points)
{
  for (const Eigen::Vector3d & point : points) {
    const Eigen::Vector3d in_map = T_map_frame.to_map(point);
    out << in_map.x() << ',' << in_map.y() << ',' << in_map.z() << '\n';
  }
  out << '\n';
}

std::vector<Eigen::Vector3d> closed(const stetro_site::Polygon & polygon)
{
  std::vector<Eigen::Vector3d> points;
  for (const auto & corner : polygon) {
    points.emplace_back(corner.x(), corner.y(), 0.0);
  }
  points.push_back(points.front());
  return points;
}

void write_floor(std::ostream & out, const stetro_site::Floor & floor)
{
  const auto * walls = std::get_if<stetro_site::PolygonWalls>(&floor.drawing);
  if (walls == nullptr) {
    return;
  }
  const stetro_site::FrameTransform T_map_floor(floor.pose_in_map);
  write_line(out, T_map_floor, closed(walls->outline));
  for (const stetro_site::Polygon & obstacle : walls->obstacles) {
    write_line(out, T_map_floor, closed(obstacle));
  }
}

void write_flight(std::ostream & out, const stetro_site::Flight & flight)
{
  for (int i = 1; i <= flight.steps(); ++i) {
    const double x = flight.riser_x_m(i);
    const double width = flight.width_m(x);
    const double z = flight.tread_z_m(i);
    const double end = flight.tread_end_m(i);
    write_line(
      out, flight.T_map_flight(),
      {{x, 0.0, z}, {end, 0.0, z}, {end, width, z}, {x, width, z}, {x, 0.0, z}});
  }
}

void put_pose(std::ostream & out, const std::optional<stetro_site::Pose> & pose)
{
  if (!pose) {
    out << ",,,,";
    return;
  }
  for (const double value : {pose->x_m, pose->y_m, pose->z_m, pose->yaw_rad}) {
    put_field(out, value);
  }
}

}  // namespace

void write_walls(std::ostream & out, const stetro_site::Site & site)
{
  out << "x_m,y_m,z_m\n";
  for (const stetro_site::Floor & floor : site.floors()) {
    write_floor(out, floor);
  }
  for (const stetro_site::Flight & flight : site.flights()) {
    write_flight(out, flight);
  }
}

PathWriter::PathWriter(std::ostream & out) : out_(out)
{
  out_ << "stamp_ns,segment,x_m,y_m,z_m,heading_rad,true_x_m,true_y_m,true_z_m,true_heading_rad\n";
}

void PathWriter::write(
  const TraceRow & row, const std::optional<stetro_site::Pose> & estimate,
  const std::optional<stetro_site::Pose> & truth)
{
  out_ << row.estimate.stamp.count() << ',' << row.estimate.segment;
  put_pose(out_, estimate);
  put_pose(out_, truth);
  out_ << '\n';
}

}  // namespace stetro_bringup
