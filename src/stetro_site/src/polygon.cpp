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

#include "stetro_site/polygon.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace stetro_site
{
namespace
{

using Point = Eigen::Vector2d;

/// Twice the area of the triangle a, b, c: positive if c is left of the line from a to b.
double turn(const Point & a, const Point & b, const Point & c)
{
  return (b.x() - a.x()) * (c.y() - a.y()) - (b.y() - a.y()) * (c.x() - a.x());
}

/// True if c, known to be on the line through a and b, lies between them.
bool is_between(const Point & a, const Point & b, const Point & c)
{
  return std::min(a.x(), b.x()) <= c.x() && c.x() <= std::max(a.x(), b.x()) &&
         std::min(a.y(), b.y()) <= c.y() && c.y() <= std::max(a.y(), b.y());
}

int sign(double value) { return (value > 0.0) - (value < 0.0); }

bool do_meet(const Point & a, const Point & b, const Point & c, const Point & d)
{
  const int c_side = sign(turn(a, b, c));
  const int d_side = sign(turn(a, b, d));
  const int a_side = sign(turn(c, d, a));
  const int b_side = sign(turn(c, d, b));
  if (c_side != d_side && a_side != b_side) {
    return true;
  }
  return (c_side == 0 && is_between(a, b, c)) || (d_side == 0 && is_between(a, b, d)) ||
         (a_side == 0 && is_between(c, d, a)) || (b_side == 0 && is_between(c, d, b));
}

/// The edge after one with the corner b turns straight back along it.
bool does_fold(const Point & a, const Point & b, const Point & c)
{
  return turn(a, b, c) == 0.0 && (b - a).dot(c - b) <= 0.0;
}

std::string corner(std::size_t i) { return "the edge at corner " + std::to_string(i); }

}  // namespace

double signed_area_m2(const Polygon & polygon)
{
  double twice = 0.0;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const Point & a = polygon[i];
    const Point & b = polygon[(i + 1) % polygon.size()];
    twice += a.x() * b.y() - b.x() * a.y();
  }
  return 0.5 * twice;
}

bool encloses(const Polygon & polygon, const Eigen::Vector2d & point_m)
{
  // A ray along +x crosses the line an odd number of times; an edge holds its lower end only.
  bool is_inside = false;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const Point & a = polygon[i];
    const Point & b = polygon[(i + 1) % polygon.size()];
    if ((a.y() <= point_m.y()) != (b.y() <= point_m.y())) {
      const double left = turn(a, b, point_m);
      is_inside = is_inside != (b.y() > a.y() ? left > 0.0 : left < 0.0);
    }
  }
  return is_inside;
}

std::string flaw_of(const Polygon & polygon)
{
  const std::size_t n = polygon.size();
  if (n < 3) {
    return "fewer than three corners";
  }
  for (std::size_t i = 0; i < n; ++i) {
    if (does_fold(polygon[i], polygon[(i + 1) % n], polygon[(i + 2) % n])) {
      return corner(i) + " is empty or the next one folds back on it";
    }
    for (std::size_t j = i + 2; j < n; ++j) {
      const bool are_neighbours = i == 0 && j + 1 == n;
      if (
        !are_neighbours &&
        do_meet(polygon[i], polygon[(i + 1) % n], polygon[j], polygon[(j + 1) % n])) {
        return corner(i) + " meets " + corner(j);
      }
    }
  }
  constexpr double kLeastArea = 1e-4;  // [m^2] a square centimetre
  return std::abs(signed_area_m2(polygon)) < kLeastArea ? "no area" : "";
}

}  // namespace stetro_site
