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

// Embree on the rooms of bench_profile_caster: walls as upright rectangles, beams in packets of 16
// of neighbours. The directions are worked out before and are not part of the time.

#include <benchmark/benchmark.h>
#include <embree3/rtcore.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <stdexcept>
#include <vector>

#include "random_scenes.hpp"
#include "rooms.hpp"

namespace stetro_site
{
namespace
{

constexpr std::size_t kPacket = 16;

class EmbreeCaster
{
public:
  explicit EmbreeCaster(const std::vector<Segment> & walls)
  : device_(rtcNewDevice("threads=1")), scene_(rtcNewScene(device_))
  {
    RTCGeometry quads = rtcNewGeometry(device_, RTC_GEOMETRY_TYPE_QUAD);
    auto * corners = static_cast<float *>(rtcSetNewGeometryBuffer(
      quads, RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT3, 3 * sizeof(float), 4 * walls.size()));
    auto * faces = static_cast<unsigned *>(rtcSetNewGeometryBuffer(
      quads, RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT4, 4 * sizeof(unsigned), walls.size()));
    unsigned next = 0;
    for (const Segment & wall : walls) {
      const auto corner = [&](const Eigen::Vector2d & at, float z) {
        *corners++ = static_cast<float>(at.x());
        *corners++ = static_cast<float>(at.y());
        *corners++ = z;
        *faces++ = next++;
      };
      corner(wall.from_m, -1.0F);
      corner(wall.to_m, -1.0F);
      corner(wall.to_m, 1.0F);
      corner(wall.from_m, 1.0F);
    }
    rtcSetGeometryBuildQuality(quads, RTC_BUILD_QUALITY_HIGH);
    rtcCommitGeometry(quads);
    rtcAttachGeometry(scene_, quads);
    rtcReleaseGeometry(quads);
    rtcSetSceneBuildQuality(scene_, RTC_BUILD_QUALITY_HIGH);
    rtcCommitScene(scene_);
    if (rtcGetDeviceError(device_) != RTC_ERROR_NONE) {
      throw std::runtime_error("embree: the scene could not be built");
    }
    const BeamFan fan = full_turn(kBeams, -3.0);
    for (std::size_t i = 0; i < kBeams; ++i) {
      const double angle = fan.first_rad + static_cast<double>(i) * fan.step_rad;
      x_.push_back(static_cast<float>(std::cos(angle)));
      y_.push_back(static_cast<float>(std::sin(angle)));
    }
  }

  ~EmbreeCaster()
  {
    rtcReleaseScene(scene_);
    rtcReleaseDevice(device_);
  }

  EmbreeCaster(const EmbreeCaster &) = delete;
  EmbreeCaster & operator=(const EmbreeCaster &) = delete;

  void cast(const Eigen::Vector2d & from, std::vector<double> & ranges) const
  {
    RTCIntersectContext context;
    rtcInitIntersectContext(&context);
    context.flags = RTC_INTERSECT_CONTEXT_FLAG_COHERENT;
    alignas(64) int valid[kPacket];
    std::fill_n(valid, kPacket, -1);
    ranges.resize(kBeams);
    alignas(64) RTCRayHit16 packet;
    for (std::size_t first = 0; first < kBeams; first += kPacket) {
      for (std::size_t i = 0; i < kPacket; ++i) {
        packet.ray.org_x[i] = static_cast<float>(from.x());
        packet.ray.org_y[i] = static_cast<float>(from.y());
        packet.ray.org_z[i] = 0.0F;
        packet.ray.dir_x[i] = x_[first + i];
        packet.ray.dir_y[i] = y_[first + i];
        packet.ray.dir_z[i] = 0.0F;
        packet.ray.tnear[i] = 0.0F;
        packet.ray.tfar[i] = std::numeric_limits<float>::infinity();
        packet.ray.time[i] = 0.0F;
        packet.ray.mask[i] = ~0U;
        packet.ray.flags[i] = 0;
        packet.hit.geomID[i] = RTC_INVALID_GEOMETRY_ID;
      }
      rtcIntersect16(valid, scene_, &context, &packet);
      for (std::size_t i = 0; i < kPacket; ++i) {
        ranges[first + i] = static_cast<double>(packet.ray.tfar[i]);
      }
    }
  }

private:
  RTCDevice device_;
  RTCScene scene_;
  std::vector<float> x_;
  std::vector<float> y_;
};

void embree_16(benchmark::State & state)
{
  const RandomRoom room = bench_room(state.range(0));
  const EmbreeCaster caster(room.walls);
  std::vector<double> ranges;
  double sum = 0.0;
  for (const Eigen::Vector2d & place : room.places) {
    caster.cast(place, ranges);
    sum = std::accumulate(ranges.begin(), ranges.end(), sum);
  }
  std::size_t i = 0;
  for (auto _ : state) {
    caster.cast(room.places[i++ % room.places.size()], ranges);
    benchmark::DoNotOptimize(ranges.data());
    benchmark::ClobberMemory();
  }
  state.counters["mean_range"] = sum / static_cast<double>(kPlaces * kBeams);
}
BENCHMARK(embree_16)->Arg(100)->Arg(1000)->Arg(10000)->Unit(benchmark::kMicrosecond);

}  // namespace
}  // namespace stetro_site
