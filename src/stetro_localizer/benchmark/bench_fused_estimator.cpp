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

// How long the fused estimator takes over a sample: what fits between two of them.

#include <benchmark/benchmark.h>

#include <algorithm>
#include <array>
#include <cstdint>

#include "stetro_localizer/fused/history.hpp"
#include "support/stair_robot.hpp"

namespace stetro_localizer
{
namespace
{

using std::chrono::milliseconds;

constexpr Nanoseconds kStart = std::chrono::seconds(1000);

/// Stands on tread 3, block 2 lifted off it: then block3_front sees the riser, too.
FusedCore standing_core(const FusedModel & model)
{
  FusedCore core = model.begin();
  core.steps.tell(3);
  for (int i = 0; i < 60; ++i) {  // the step filter settles, then block 2 rises in a second
    BlockSample blocks;
    blocks.stamp = kStart - milliseconds(33 * (60 - i));
    const double raised_m = std::clamp((i - 20) * 0.006, 0.0, 0.18);
    const bool stands = raised_m == 0.0;
    blocks.blocks[0] = {0.14, stands ? 0.33 : 0.5, true, false, false};
    blocks.blocks[1] = {raised_m, stands ? 0.33 : 0.0, true, !stands, false};
    blocks.blocks[2] = {0.0, stands ? 0.33 : 0.5, true, false, false};
    model.take(core, Sample(blocks));
  }
  core.filter.set(kStateX, -0.085, 1e-6);
  core.filter.set(kStateY, 1.0, 1e-6);
  core.filter.set(kStateYaw, 0.0, 1e-6);
  return core;
}

struct Bench
{
  Bench() : model(LocalizerParams{}, stetro_site::RobotGeometry{}, papers_flight()) {}

  FusedModel model;
  FusedCore core = standing_core(model);
};

void predict(benchmark::State & state)
{
  Bench bench;
  const ProcessNoise noise;
  for (auto _ : state) {
    bench.core.filter.predict(0.01, 1e-6, noise, true);
    benchmark::DoNotOptimize(bench.core.filter.state());
  }
}
BENCHMARK(predict);

void range_update(benchmark::State & state)
{
  Bench bench;
  const SideRangeAiding aiding(Side::kRight, {0.0, -0.05}, ConeOnWall(0.4363));
  for (auto _ : state) {
    const Expectation expected = aiding.expect(bench.core.filter.state());
    const Innovation innovation =
      bench.core.filter.innovation(expected, expected.value() + 1e-4, 1e-4);
    if (innovation.nis() < 15.0) {
      bench.core.filter.correct(expected, innovation);
    }
    benchmark::DoNotOptimize(bench.core.filter.state());
  }
}
BENCHMARK(range_update);

/// The array of that number: no reading repeats the one before, or it would be stuck.
RangeSample eight_readings(Nanoseconds stamp, std::uint64_t number)
{
  RangeSample sample;
  sample.stamp = stamp;
  for (const Place place : stetro_site::kPlaces) {
    sample[place] = {stamp, 0.035, 0.0, RangeStatus::kValid};
  }
  const double jitter_m = number % 2 == 0 ? 0.001 : -0.001;
  sample[Place::kSideLeft].range_m = 1.0117 * 1.0 + jitter_m;
  sample[Place::kSideRight].range_m = 1.0117 * 0.95 + jitter_m;
  sample[Place::kFrontLeft].range_m = sample[Place::kFrontRight].range_m =
    1.0117 * 0.215 + jitter_m;  // riser 5, a tread beyond the one 8.5 cm ahead
  sample[Place::kBlock3Front].range_m = 1.0117 * 0.195 + jitter_m;
  return sample;
}

constexpr std::array<Source, 5> kFused{
  Source::kSideLeft, Source::kSideRight, Source::kFrontLeft, Source::kFrontRight,
  Source::kBlock3Front};

/// Each array must correct five times, or what is measured is not what it is called.
bool all_fused(const SourceReports & reports, std::uint64_t arrays)
{
  return std::all_of(kFused.begin(), kFused.end(), [&](Source source) {
    return reports[source].fused + 1 >= arrays;  // the first one is confirmed by none
  });
}

/// Five minutes: hours without wheels and gyroscope leave nothing that a gate could hold.
constexpr benchmark::IterationCount kArrays = 10'000;

void range_array(benchmark::State & state)
{
  Bench bench;
  Nanoseconds stamp = kStart;
  std::uint64_t arrays = 0;
  for (auto _ : state) {
    stamp += milliseconds(33);
    bench.model.take(bench.core, Sample(eight_readings(stamp, arrays)));
    benchmark::DoNotOptimize(bench.core.filter.state());
    ++arrays;
  }
  if (!all_fused(bench.core.reports, arrays)) {
    state.SkipWithError("not every array was fused five times");
  }
}
BENCHMARK(range_array)->Iterations(kArrays);

// As on the robot: 20 ms old, with wheels and gyroscope that came since taken again.
void range_array_late(benchmark::State & state)
{
  Bench bench;
  History history(bench.model, bench.core, nanoseconds(FusedParams{}.window_s), 256);
  Nanoseconds now = kStart;
  std::uint64_t arrays = 0;
  for (auto _ : state) {
    state.PauseTiming();
    for (int i = 0; i < 3; ++i) {
      now += milliseconds(10);
      history.take(OdometrySample{now, 0.0, 0.0, 0.0});
      history.take(GyroSample{now, 1e-6});
    }
    state.ResumeTiming();
    history.take(Sample(eight_readings(now - milliseconds(19), arrays)));
    ++arrays;
  }
  if (!all_fused(history.core().reports, arrays)) {
    state.SkipWithError("not every array was fused five times");
  }
}
BENCHMARK(range_array_late);

}  // namespace
}  // namespace stetro_localizer

BENCHMARK_MAIN();
