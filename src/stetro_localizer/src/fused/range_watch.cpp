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

#include "stetro_localizer/fused/range_watch.hpp"

#include <algorithm>
#include <cmath>

namespace stetro_localizer
{
namespace
{

constexpr double kLevel = 0.03;          // two blocks on one tread differ by less [m]
constexpr double kInPlace = 0.02;        // less way than this is none [m]
constexpr double kSurelyRaised = 0.05;   // a down sensor is then beyond its nearest distance [m]
constexpr double kOutOfSight = 0.13;     // block 2 is then above what block3_front sees [m]
constexpr double kNear = 0.7;            // of the reach: what two see, the third one sees, too
constexpr double kBeyondTooNear = 0.10;  // a riser so far away is not too near [m]

constexpr std::array<Place, 3> kFronts{Place::kFrontLeft, Place::kStairFront, Place::kFrontRight};

}  // namespace

void RangeWatch::note(const BlockSample & sample, double travel_m)
{
  std::array<double, 3> height_m{};
  std::array<bool, 3> bears{};
  for (std::size_t i = 0; i < 3; ++i) {
    const BlockReading & block = sample.blocks[i];
    if (block.fault || !block.load_known) {
      blocks_ = {};
      return;
    }
    height_m[i] = block.height_m;
    bears[i] = block.load >= bearing_load_;
  }
  for (std::size_t i = 0; i < 3; ++i) {
    RaisedBlock & block = blocks_[i];
    block.stands = bears[i] && !sample.blocks[i].moving;
    block.raised_m = 0.0;
    if (bears[i]) {
      stood_m_[i] = height_m;
      bore_[i] = bears;
      stood_at_m_[i] = travel_m;
    }
    block.in_place = std::abs(travel_m - stood_at_m_[i]) < kInPlace;
    block.level = std::abs(stood_m_[i][i] - stood_m_[i][2]) < kLevel;
    for (std::size_t ground = 0; ground < 3 && !bears[i]; ++ground) {
      if (bears[ground] && bore_[i][ground]) {
        block.raised_m = (height_m[i] - height_m[ground]) - (stood_m_[i][i] - stood_m_[i][ground]);
      }
    }
  }
}

void RangeWatch::note(const RangeSample & sample, double travel_m, double riser_m)
{
  for (std::size_t i = 0; i < 3; ++i) {
    blocks_[i].in_place = blocks_[i].in_place && std::abs(travel_m - stood_at_m_[i]) < kInPlace;
  }
  for (const Place place : stetro_site::kPlaces) {
    const RangeReading & reading = sample[place];
    if (reading.status == RangeStatus::kAbsent) {
      continue;
    }
    RangeMonitor & monitor = monitors_[stetro_site::index_of(place)];
    monitor.note(reading);
    const Must expected = must(place, sample, riser_m);
    const bool near = reading.status == RangeStatus::kTooNear;
    const bool nothing =
      reading.status == RangeStatus::kNoTarget || reading.status == RangeStatus::kWeak;
    if ((expected != Must::kNothing && nothing) || (expected == Must::kSeeFarther && near)) {
      monitor.miss();
    } else if (expected == Must::kSee && near) {
      monitor.meet();
    }
  }
}

RangeWatch::Must RangeWatch::must(Place place, const RangeSample & sample, double riser_m) const
{
  switch (place) {
    case Place::kBlock1Down:
      return must_down(blocks_[0]);
    case Place::kBlock2Down:
      return must_down(blocks_[1]);
    case Place::kBlock3Front:
      return must_behind(riser_m);
    case Place::kFrontLeft:
    case Place::kFrontRight:
    case Place::kStairFront:
      return others_see(place, sample) ? Must::kSeeFarther : Must::kNothing;
    case Place::kSideLeft:
    case Place::kSideRight:
      break;
  }
  return Must::kNothing;
}

RangeWatch::Must RangeWatch::must_down(const RaisedBlock & block) const
{
  if (block.stands) {
    return Must::kSee;
  }
  return block.in_place && block.raised_m > kSurelyRaised ? Must::kSeeFarther : Must::kNothing;
}

RangeWatch::Must RangeWatch::must_behind(double riser_m) const
{
  const RaisedBlock & block2 = blocks_[1];
  if (!block2.level || !blocks_[2].stands) {
    return Must::kNothing;
  }
  if (block2.stands) {
    return Must::kSee;
  }
  const double range_m = riser_m - robot_.at(Place::kBlock3Front).x_m;
  const bool sees = block2.in_place && block2.raised_m > kOutOfSight && range_m > kBeyondTooNear &&
                    range_m < kNear * robot_.range_sensor.reliable_range_m;
  return sees ? Must::kSeeFarther : Must::kNothing;
}

bool RangeWatch::others_see(Place place, const RangeSample & sample) const
{
  return std::all_of(kFronts.begin(), kFronts.end(), [&](Place other) {
    const RangeReading & reading = sample[other];
    return other == place ||
           (reading.status == RangeStatus::kValid && reading.range_m > kBeyondTooNear &&
            reading.range_m < kNear * robot_.range_sensor.reliable_range_m);
  });
}

bool RangeWatch::any_dead(Nanoseconds now, Nanoseconds since, double patience_s) const
{
  return std::any_of(monitors_.begin(), monitors_.end(), [&](const RangeMonitor & monitor) {
    return monitor.dead(now, since, patience_s);
  });
}

bool RangeWatch::any_stuck() const
{
  return std::any_of(monitors_.begin(), monitors_.end(), [](const RangeMonitor & monitor) {
    return monitor.stuck() || monitor.blind();
  });
}

}  // namespace stetro_localizer
