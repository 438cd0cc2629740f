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

#include "stetro_localizer/fused/switch_watch.hpp"

#include <algorithm>
#include <cmath>

#include "stetro_localizer/fused/bumper_aiding.hpp"
#include "stetro_localizer/fused/riser_switch_aiding.hpp"

namespace stetro_localizer
{
namespace
{

constexpr double kClear = 0.03;    // so far from the wall a closed switch is wrong [m]
constexpr double kLeads = 0.004;   // bumpers close within +-1 mm, walls are straight to 1 mm [m]
constexpr double kSure = 4.0;      // standard deviations of the estimate
constexpr double kLasts = 0.3;     // a contradiction that is none passes sooner [s]
constexpr double kPushes = 1.5;    // the wheels turn a robot square in less [s]
constexpr double kForward = 1e-3;  // slower is no push [m/s]
constexpr std::size_t kRiserSwitch = 3;

const Switch & switch_of(const ContactSample & sample, std::size_t side, std::size_t i)
{
  if (i == kRiserSwitch) {
    return side == 0 ? sample.riser_left : sample.riser_right;
  }
  return side == 0 ? sample.left[i] : sample.right[i];
}

double sigma_m(const FusedCore & core, const Expectation & gap)
{
  return std::sqrt(core.filter.innovation(gap, 0.0, 0.0).variance);
}

}  // namespace

void SwitchWatch::note(const ContactSample & sample, const FusedCore & core, int steps)
{
  for (std::size_t side = 0; side < 2; ++side) {
    for (std::size_t i = 0; i < kOfASide; ++i) {
      Watched & watched = switches_[side * kOfASide + i];
      const Switch & now = switch_of(sample, side, i);
      note_one(watched, now);
      if (!core.located_on || !now.known) {
        continue;
      }
      if (i != kRiserSwitch) {
        contradict(watched, bumper_contradicted(sample, core, side, i), sample.stamp);
      } else {
        const bool ahead = *core.located_on < steps;
        contradict(watched, now.closed && (!ahead || riser_contradicted(core, side)), sample.stamp);
      }
    }
  }
}

void SwitchWatch::note_one(Watched & watched, const Switch & now)
{
  watched.unknown = !now.known;
  if (now.known) {
    watched.stuck = watched.stuck && now.closed == watched.closed;
    watched.closed = now.closed;
  }
}

void SwitchWatch::contradict(Watched & watched, bool contradicted, Nanoseconds stamp)
{
  if (!contradicted) {
    watched.contradicted_since = Nanoseconds{0};
    return;
  }
  if (watched.contradicted_since == Nanoseconds{0}) {
    watched.contradicted_since = stamp;
  }
  watched.stuck = watched.stuck || seconds(stamp - watched.contradicted_since) >= kLasts;
}

Expectation SwitchWatch::bumper_gap(
  const FusedCore & core, std::size_t side, std::size_t block) const
{
  return expect_bumper(
    core.filter.state(), side == 0 ? Side::kLeft : Side::kRight,
    robot_.block_x_m(static_cast<int>(block) + 1), robot_.block_length_m, robot_.contact_width_m);
}

bool SwitchWatch::bumper_contradicted(
  const ContactSample & sample, const FusedCore & core, std::size_t side, std::size_t block) const
{
  const Expectation gap = bumper_gap(core, side, block);
  if (switch_of(sample, side, block).closed) {
    return gap.value() > kClear + kSure * sigma_m(core, gap);
  }
  const double yaw_sigma_rad = std::sqrt(core.filter.variance(kStateYaw));
  for (std::size_t other = 0; other < 3; ++other) {
    const double apart_m = std::abs(
      robot_.block_x_m(static_cast<int>(block) + 1) -
      robot_.block_x_m(static_cast<int>(other) + 1));
    const double leads_m = bumper_gap(core, side, other).value() - gap.value();
    const bool closed = switch_of(sample, side, other).is_closed();
    if (closed && leads_m > kLeads + kSure * yaw_sigma_rad * apart_m) {
      return true;
    }
  }
  return false;
}

bool SwitchWatch::riser_contradicted(const FusedCore & core, std::size_t side) const
{
  const double tip_y_m = side == 0 ? robot_.switch_y_m : -robot_.switch_y_m;
  const Expectation gap = expect_riser_switch(core.filter.state(), robot_.switch_x_m, tip_y_m);
  return gap.value() > kClear + kSure * sigma_m(core, gap);
}

void SwitchWatch::note(const OdometrySample & sample, const FusedCore & core)
{
  const Switch & left = core.contacts.riser_left;
  const Switch & right = core.contacts.riser_right;
  const bool one = left.known && right.known && left.closed != right.closed;
  if (!one || sample.vx_mps < kForward) {
    pushing_since_ = Nanoseconds{0};
    return;
  }
  if (pushing_since_ == Nanoseconds{0}) {
    pushing_since_ = sample.stamp;
  }
  if (seconds(sample.stamp - pushing_since_) >= kPushes) {
    switches_[left.closed ? kOfASide + kRiserSwitch : kRiserSwitch].stuck = true;  // the open one
  }
}

bool SwitchWatch::any_dead() const
{
  return std::any_of(
    switches_.begin(), switches_.end(), [](const Watched & one) { return one.unknown; });
}

bool SwitchWatch::any_stuck() const
{
  return std::any_of(
    switches_.begin(), switches_.end(), [](const Watched & one) { return one.stuck; });
}

}  // namespace stetro_localizer
