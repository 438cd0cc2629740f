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

// CGAL's triangular expansion on the rooms of bench_profile_caster. It answers with the polygon
// that is seen, without beams; only the exact kernel is sound on all of these rooms. CGAL's
// licence is the GPL: this file is part of the benchmark and of nothing that is shipped.

#include <CGAL/Arr_segment_traits_2.h>
#include <CGAL/Arrangement_2.h>
#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/Triangular_expansion_visibility_2.h>
#include <benchmark/benchmark.h>

#include <stdexcept>
#include <vector>

#include "random_scenes.hpp"
#include "rooms.hpp"

namespace stetro_site
{
namespace
{

using Kernel = CGAL::Exact_predicates_exact_constructions_kernel;
using Arrangement = CGAL::Arrangement_2<CGAL::Arr_segment_traits_2<Kernel>>;
using Expansion = CGAL::Triangular_expansion_visibility_2<Arrangement, CGAL::Tag_true>;

/// The floor between the boxes: the one face with a hole for each.
Arrangement::Face_const_handle floor_of(const Arrangement & arrangement)
{
  for (auto face = arrangement.faces_begin(); face != arrangement.faces_end(); ++face) {
    if (!face->is_unbounded() && face->number_of_holes() > 0) {
      return face;
    }
  }
  throw std::logic_error("the room has no floor");
}

void cgal_triangular_expansion_exact(benchmark::State & state)
{
  const RandomRoom room = bench_room(state.range(0));
  std::vector<Kernel::Segment_2> walls;
  for (const Segment & wall : room.walls) {
    walls.emplace_back(
      Kernel::Point_2(wall.from_m.x(), wall.from_m.y()),
      Kernel::Point_2(wall.to_m.x(), wall.to_m.y()));
  }
  Arrangement arrangement;
  CGAL::insert_non_intersecting_curves(arrangement, walls.begin(), walls.end());
  const auto floor = floor_of(arrangement);
  const Expansion expansion(arrangement);
  std::size_t edges = 0;
  std::size_t i = 0;
  for (auto _ : state) {
    const Eigen::Vector2d & place = room.places[i++ % room.places.size()];
    Arrangement seen;
    expansion.compute_visibility(Kernel::Point_2(place.x(), place.y()), floor, seen);
    edges += seen.number_of_edges();
  }
  state.counters["edges"] = static_cast<double>(edges) / static_cast<double>(i);
}
BENCHMARK(cgal_triangular_expansion_exact)
  ->Arg(100)
  ->Arg(1000)
  ->Arg(10000)
  ->Unit(benchmark::kMicrosecond);

}  // namespace
}  // namespace stetro_site
