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

// How long a profile of 1440 beams takes on walls and on grids. The yardsticks of the other files
// in this folder cast the same rooms from the same places in the same run.

#include <benchmark/benchmark.h>

#include <numeric>
#include <vector>

#include "cast_walls.hpp"
#include "random_scenes.hpp"
#include "rooms.hpp"
#include "stetro_site/grid_caster.hpp"
#include "stetro_site/segment_caster.hpp"

namespace stetro_site
{
namespace
{

/// Casts from one place after the other; `mean_range` tells whether yardsticks see the same.
void cast_in_turn(
  benchmark::State & state, const ProfileCaster & caster,
  const std::vector<Eigen::Vector2d> & places)
{
  const BeamFan fan = full_turn(kBeams, -3.0);
  std::vector<double> ranges_m;
  double sum_m = 0.0;
  for (const Eigen::Vector2d & place : places) {
    caster.cast(place, fan, kReach, ranges_m);
    sum_m = std::accumulate(ranges_m.begin(), ranges_m.end(), sum_m);
  }
  std::size_t i = 0;
  for (auto _ : state) {
    caster.cast(places[i++ % places.size()], fan, kReach, ranges_m);
    benchmark::DoNotOptimize(ranges_m.data());
    benchmark::ClobberMemory();
  }
  state.counters["mean_range"] = sum_m / static_cast<double>(places.size() * kBeams);
}

void segment_caster(benchmark::State & state)
{
  const RandomRoom room = bench_room(state.range(0));
  cast_in_turn(state, SegmentCaster(room.walls), room.places);
}
BENCHMARK(segment_caster)->Arg(100)->Arg(1000)->Arg(10000)->Unit(benchmark::kMicrosecond);

/// The same bits without AVX, as the least of processors gives them.
void segment_caster_plain(benchmark::State & state)
{
  class PlainCaster : public ProfileCaster
  {
  public:
    explicit PlainCaster(const std::vector<Segment> & walls) : walls_(walls, WallSides::kBoth) {}
    void cast(
      const Eigen::Vector2d & from_m, const BeamFan & fan, double reach_m,
      std::vector<double> & ranges_m) const override
    {
      cast_walls(walls_, {from_m, fan, reach_m, 1.0}, Instructions::kPlain, ranges_m);
    }

  private:
    WallTree walls_;
  };
  const RandomRoom room = bench_room(state.range(0));
  cast_in_turn(state, PlainCaster(room.walls), room.places);
}
BENCHMARK(segment_caster_plain)->Arg(100)->Arg(1000)->Arg(10000)->Unit(benchmark::kMicrosecond);

void grid_caster(benchmark::State & state)
{
  const OccupancyGrid grid = random_grid_room(static_cast<int>(state.range(0)), kGridBoxes, 11);
  const GridCaster caster(grid, Unknown::kWall);
  cast_in_turn(state, caster, free_places(grid, kPlaces, 12));
}
BENCHMARK(grid_caster)->Arg(500)->Arg(2000)->Unit(benchmark::kMicrosecond);

/// Making a caster ready, once a map.
void prepare_segments(benchmark::State & state)
{
  const RandomRoom room = bench_room(state.range(0));
  for (auto _ : state) {
    benchmark::DoNotOptimize(SegmentCaster(room.walls));
  }
}
BENCHMARK(prepare_segments)->Arg(100)->Arg(1000)->Arg(10000)->Unit(benchmark::kMicrosecond);

void prepare_grid(benchmark::State & state)
{
  const OccupancyGrid grid = random_grid_room(static_cast<int>(state.range(0)), kGridBoxes, 11);
  for (auto _ : state) {
    benchmark::DoNotOptimize(GridCaster(grid, Unknown::kWall));
  }
}
BENCHMARK(prepare_grid)->Arg(500)->Arg(2000)->Unit(benchmark::kMicrosecond);

}  // namespace
}  // namespace stetro_site

BENCHMARK_MAIN();
