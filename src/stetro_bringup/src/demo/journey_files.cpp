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

#include "journey_files.hpp"

#include <Eigen/Core>
#include <cmath>
#include <optional>
#include <ostream>
#include <stdexcept>
#include <variant>

#include "stetro_site/frame_transform.hpp"

namespace stetro_bringup
{
namespace
{

using stetro_site::Pose;

/// A closed line in one plane of a segment's frame.
void write_line(
  std::ostream & out, const std::string & segment, const char * kind,
  const stetro_site::FrameTransform & T_map_frame, std::vector<Eigen::Vector3d> points)
{
  points.push_back(points.front());
  for (const Eigen::Vector3d & point : points) {
    const Eigen::Vector3d in_map = T_map_frame.to_map(point);
    out << segment << ',' << kind << ',' << in_map.x() << ',' << in_map.y() << ',' << in_map.z()
        << '\n';
  }
  out << '\n';
}

std::vector<Eigen::Vector3d> corners(const stetro_site::Polygon & polygon)
{
  std::vector<Eigen::Vector3d> points;
  for (const auto & corner : polygon) {
    points.emplace_back(corner.x(), corner.y(), 0.0);
  }
  return points;
}

void write_floor(std::ostream & out, const stetro_site::Floor & floor)
{
  const auto * walls = std::get_if<stetro_site::PolygonWalls>(&floor.drawing);
  if (walls == nullptr) {
    return;
  }
  const stetro_site::FrameTransform T_map_floor(floor.pose_in_map);
  write_line(out, floor.id, "wall", T_map_floor, corners(walls->outline));
  for (const stetro_site::Polygon & obstacle : walls->obstacles) {
    write_line(out, floor.id, "wall", T_map_floor, corners(obstacle));
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
      out, flight.id(), "tread", flight.T_map_flight(),
      {{x, 0.0, z}, {end, 0.0, z}, {end, width, z}, {x, width, z}});
  }
}

void put_pose(std::ostream & out, const std::optional<Pose> & pose)
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

std::ofstream opened(const std::string & path)
{
  std::ofstream file(path);
  if (!file) {
    throw std::runtime_error(path + ": cannot be written");
  }
  return file;
}

JourneyFiles::JourneyFiles(const std::string & folder, const stetro_site::Site & site)
: frames_(site),
  path_(opened(folder + "/path.csv")),
  checks_(opened(folder + "/checks.csv")),
  kidnaps_(opened(folder + "/kidnaps.csv"))
{
  auto walls = opened(folder + "/walls.csv");
  walls << "segment,kind,x_m,y_m,z_m\n";
  for (const stetro_site::Floor & floor : site.floors()) {
    write_floor(walls, floor);
  }
  for (const stetro_site::Flight & flight : site.flights()) {
    write_flight(walls, flight);
  }
  path_ << "stamp_ns,segment,x_m,y_m,z_m,heading_rad,true_x_m,true_y_m,true_z_m,true_heading_rad\n";
  checks_ << "stamp_ns,segment,verdict,x_m,y_m,z_m,heading_rad\n";
  kidnaps_ << "time_s,segment,from_x_m,from_y_m,from_z_m,from_heading_rad,to_x_m,to_y_m,to_z_m,"
              "to_heading_rad\n";
}

void JourneyFiles::add(const TraceRow & row)
{
  path_ << row.estimate.stamp.count() << ',' << row.estimate.segment;
  put_pose(path_, frames_.in_map(row.estimate));
  put_pose(path_, row.truth ? frames_.in_map(*row.truth) : std::nullopt);
  path_ << '\n';
}

void JourneyFiles::add(const CheckSample & check)
{
  checks_ << check.stamp.count() << ',' << check.segment << ',' << check.verdict;
  put_pose(checks_, std::isfinite(check.in_map.x_m) ? std::optional(check.in_map) : std::nullopt);
  checks_ << '\n';
}

void JourneyFiles::close(const std::vector<Kidnap> & kidnaps)
{
  for (const Kidnap & kidnap : kidnaps) {
    kidnaps_ << kidnap.time_s << ',' << kidnap.segment;
    put_pose(kidnaps_, kidnap.from);
    put_pose(kidnaps_, kidnap.to);
    kidnaps_ << '\n';
  }
  for (std::ofstream * file : {&path_, &checks_, &kidnaps_}) {
    file->close();
  }
}

}  // namespace stetro_bringup
