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

// The four-beam search on the five maps of S-G's table 1: a room of 2.0 x 3.6 m, here with a dozen
// boxes, in cells of 10 to 0.5 cm; (200 / r + 2)(360 / r + 1) cells (D4-2). The methods as
// published with plain vectors, apart in hypotheses and intersection as the table has them, and
// the index.

#include <benchmark/benchmark.h>

#include <array>
#include <random>
#include <string>
#include <vector>

#include "stetro_supervisor/four_beams/beam_search.hpp"
#include "stetro_supervisor/four_beams/four_beam_index.hpp"
#include "stetro_supervisor/four_beams/published_search.hpp"
#include "support/random_room.hpp"

namespace stetro_supervisor
{
namespace
{

using stetro_site::CellIndex;
using stetro_site::GridFrame;
using stetro_site::OccupancyGrid;

/// A map of the table, and what the four beams read at places of it.
struct Bench
{
  explicit Bench(std::int64_t resolution_mm, int unknown_patches = 0)
  : grid(room(static_cast<int>(resolution_mm), unknown_patches))
  {
    constexpr int kReadings = 256;
    std::mt19937 random{20241101};
    const std::vector<CellIndex> places = free_cells(grid);
    std::uniform_int_distribution<std::size_t> any(0, places.size() - 1);
    while (readings.size() < kReadings) {
      const CellIndex place = places[any(random)];
      PerAzimuth<int> distances{};
      for (const Azimuth azimuth : kAzimuths) {
        distances[position(azimuth)] = beam_distance(grid, place, azimuth).value_or(0);
      }
      if (distances[0] * distances[1] * distances[2] * distances[3] > 0) {
        readings.push_back(distances);
      }
    }
  }

  static OccupancyGrid room(int resolution_mm, int unknown_patches)
  {
    GridFrame frame;
    frame.columns = 2000 / resolution_mm + 2;
    frame.rows = 3600 / resolution_mm + 1;
    frame.resolution_m = resolution_mm / 1000.0;
    RoomContents contents;
    contents.unknown_patches = unknown_patches;
    contents.grain = 100 / resolution_mm;  // the same furniture in each
    std::mt19937 random{12};
    return random_room(frame, contents, random);
  }

  const PerAzimuth<int> & reading() { return readings[next++ % readings.size()]; }

  OccupancyGrid grid;
  std::vector<PerAzimuth<int>> readings;
  std::size_t next = 0;
};

void report(benchmark::State & state, const Bench & bench, std::size_t found)
{
  state.counters["cells"] = static_cast<double>(bench.grid.cells().size());
  state.counters["found"] =
    benchmark::Counter(static_cast<double>(found), benchmark::Counter::kAvgIterations);
}

/// Table 1's time 1.
void hypotheses_of(benchmark::State & state, BeamPath path, HypothesisSearch search)
{
  Bench bench(state.range(0));
  std::size_t found = 0;
  for (auto _ : state) {
    const PerAzimuth<int> & distances = bench.reading();
    for (const Azimuth azimuth : kAzimuths) {
      found += hypotheses(bench.grid, azimuth, distances[position(azimuth)], path, search).size();
    }
  }
  report(state, bench, found);
}

/// Table 1's time 2.
void intersection_of(benchmark::State & state, BeamPath path)
{
  Bench bench(state.range(0));
  std::vector<PerAzimuth<std::vector<CellIndex>>> sets(bench.readings.size());
  for (auto & of_reading : sets) {
    const PerAzimuth<int> & distances = bench.reading();
    for (const Azimuth azimuth : kAzimuths) {
      of_reading[position(azimuth)] = hypotheses(
        bench.grid, azimuth, distances[position(azimuth)], path, HypothesisSearch::kFromObstacles);
    }
  }
  std::size_t found = 0;
  std::size_t next = 0;
  for (auto _ : state) {
    found += intersection(sets[next++ % sets.size()]).size();
  }
  report(state, bench, found);
}

/// Table 1's time 3.
void published(benchmark::State & state, BeamPath path, HypothesisSearch search)
{
  Bench bench(state.range(0));
  std::size_t found = 0;
  for (auto _ : state) {
    found += published_search(bench.grid, bench.reading(), path, search).size();
  }
  report(state, bench, found);
}

void hybrid(benchmark::State & state, HypothesisSearch search)
{
  Bench bench(state.range(0));
  std::size_t found = 0;
  for (auto _ : state) {
    found += hybrid_search(bench.grid, bench.reading(), search).size();
  }
  report(state, bench, found);
}

void indexed(benchmark::State & state, int tolerance)
{
  Bench bench(state.range(0));
  const FourBeamIndex index(bench.grid);
  std::vector<CellIndex> cells;
  std::size_t found = 0;
  for (auto _ : state) {
    index.find(bench.reading(), tolerance, cells);
    found += cells.size();
  }
  report(state, bench, found);
}

/// The same where nobody looked at six places: beams into the unknown have no distance to sort by.
void indexed_with_unknown(benchmark::State & state)
{
  Bench bench(state.range(0), 6);
  const FourBeamIndex index(bench.grid);
  std::vector<CellIndex> cells;
  std::size_t found = 0;
  for (auto _ : state) {
    index.find(bench.reading(), 1, cells);
    found += cells.size();
  }
  report(state, bench, found);
  state.SetLabel(std::to_string(index.open_size()) + " open cells");
}

void index_build(benchmark::State & state)
{
  const Bench bench(state.range(0));
  std::size_t found = 0;
  for (auto _ : state) {
    found += FourBeamIndex(bench.grid).size();
  }
  report(state, bench, found);
}

/// The road of any beams in any directions: the whole grid is looked through.
void three_of_four(benchmark::State & state)
{
  Bench bench(state.range(0));
  std::vector<ReachTable> tables;
  for (const Azimuth azimuth : kAzimuths) {
    tables.emplace_back(bench.grid, yaw_rad(azimuth));
  }
  std::size_t found = 0;
  for (auto _ : state) {
    const PerAzimuth<int> & distances = bench.reading();
    std::vector<BeamInterval> beams;
    for (std::size_t i = 0; i < tables.size(); ++i) {
      beams.push_back({&tables[i], distances[i] - 1, distances[i] + 1});
    }
    found += cells_agreeing(bench.grid, beams, 3).cells.size();
  }
  report(state, bench, found);
}

/// One direction that is no row and no column.
void oblique_table(benchmark::State & state)
{
  const Bench bench(state.range(0));
  std::size_t found = 0;
  for (auto _ : state) {
    found += ReachTable(bench.grid, 0.3).cells();
  }
  report(state, bench, found);
}

void resolutions(benchmark::internal::Benchmark * bench)
{
  for (const int resolution_mm : {100, 50, 20, 10, 5}) {
    bench->Arg(resolution_mm);
  }
  bench->ArgName("mm")->Unit(benchmark::kMicrosecond);
}

constexpr auto kEvery = HypothesisSearch::kEveryCell;
constexpr auto kBack = HypothesisSearch::kFromObstacles;

BENCHMARK_CAPTURE(published, method_1, BeamPath::kTracked, kEvery)->Apply(resolutions);
BENCHMARK_CAPTURE(published, method_2, BeamPath::kIgnored, kEvery)->Apply(resolutions);
BENCHMARK_CAPTURE(hybrid, every_cell, kEvery)->Apply(resolutions);
BENCHMARK_CAPTURE(published, method_1_from_obstacles, BeamPath::kTracked, kBack)
  ->Apply(resolutions);
BENCHMARK_CAPTURE(published, method_2_from_obstacles, BeamPath::kIgnored, kBack)
  ->Apply(resolutions);
BENCHMARK_CAPTURE(hybrid, from_obstacles, kBack)->Apply(resolutions);
BENCHMARK_CAPTURE(hypotheses_of, method_1, BeamPath::kTracked, kEvery)->Apply(resolutions);
BENCHMARK_CAPTURE(hypotheses_of, method_2, BeamPath::kIgnored, kEvery)->Apply(resolutions);
BENCHMARK_CAPTURE(hypotheses_of, method_1_from_obstacles, BeamPath::kTracked, kBack)
  ->Apply(resolutions);
BENCHMARK_CAPTURE(hypotheses_of, method_2_from_obstacles, BeamPath::kIgnored, kBack)
  ->Apply(resolutions);
BENCHMARK_CAPTURE(intersection_of, method_1, BeamPath::kTracked)->Apply(resolutions);
BENCHMARK_CAPTURE(intersection_of, method_2, BeamPath::kIgnored)->Apply(resolutions);
BENCHMARK_CAPTURE(indexed, exact, 0)->Apply(resolutions);
BENCHMARK_CAPTURE(indexed, tolerance_1, 1)->Apply(resolutions);
BENCHMARK_CAPTURE(indexed, tolerance_2, 2)->Apply(resolutions);
BENCHMARK(indexed_with_unknown)->Apply(resolutions);
BENCHMARK(index_build)->Apply(resolutions);
BENCHMARK(three_of_four)->Apply(resolutions);
BENCHMARK(oblique_table)->Apply(resolutions);

}  // namespace
}  // namespace stetro_supervisor

BENCHMARK_MAIN();
