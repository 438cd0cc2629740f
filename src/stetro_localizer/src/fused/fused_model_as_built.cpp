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

// What is found of the staircase as built.

#include <algorithm>
#include <array>

#include "stetro_localizer/front_reference.hpp"
#include "stetro_localizer/fused/fused_model.hpp"

namespace stetro_localizer
{
namespace
{

constexpr double kLearned = 0.9;       // of the prior's standard deviation: more is no measurement
constexpr double kBelied = 3.5;        // standard deviations: the prior is wrong here
constexpr double kCalibrated = 0.005;  // standard deviation of a gauge that counts [m]

constexpr std::array<Place, 2> kFrontPair{Place::kFrontLeft, Place::kFrontRight};

double squared(double value) { return value * value; }

const Expectation::Entry * of_tread_ahead(const Expectation & expectation)
{
  return std::find_if(expectation.begin(), expectation.end(), [](const auto & entry) {
    return entry.index == kStateTreadAhead;
  });
}

}  // namespace

// By the tread's own doubt and that of the gauge. Before the first tread pair and heading are not
// calibrated yet: then the gauge says nothing.
bool FusedModel::belies_site(const ScalarEstimate & gauged, int step) const
{
  if (gauged.variance > squared(kCalibrated)) {
    return false;
  }
  const double variance = gauged.variance + squared(params_.fused.priors.tread_m);
  return squared(gauged.value - tread_m(step)) > squared(kBelied) * variance;
}

// The filter's estimate is the better one, unless the site file, on which it leans, is wrong.
StepAsBuilt FusedModel::as_built_here(const FusedCore & core) const
{
  const int step = core.located_on.value_or(0);
  if (step == 0) {
    return {};
  }
  const auto now = [&core](int index) {
    return ScalarEstimate{core.filter[index], core.filter.variance(index)};
  };
  StepAsBuilt here{step, std::nullopt, now(kStateWidth)};
  const double learned = squared(kLearned * params_.fused.priors.tread_m);
  if (core.gauged_here && belies_site(*core.gauged_here, step)) {
    here.tread_m = core.gauged_here;
  } else if (core.filter.variance(kStateTreadHere) < learned) {
    here.tread_m = now(kStateTreadHere);
  }
  return here;
}

FrontCalibration FusedModel::front_calibration(const FusedCore & core) const
{
  StateVector touching = core.filter.state();
  touching[kStateX] = -robot_.switch_x_m;
  FrontCalibration calibration;
  StateVector of_mean = StateVector::Zero();  // what each state shifts the pair's mean depth by
  for (std::size_t i = 0; i < fronts_.size(); ++i) {
    const int offset = offset_index(fronts_[i].ranger());
    const int gain = gain_index(fronts_[i].ranger());
    calibration.offset_m[i] = core.filter[offset];
    calibration.gain[i] = core.filter[gain];
    const Expectation expected = fronts_[i].expect(touching, SeenRiser::kNext, 0.0);
    const double per_depth = of_tread_ahead(expected)->slope;
    for (const auto & entry : expected) {
      const bool counts = entry.index == offset || entry.index == gain;
      of_mean[entry.index] += counts ? entry.slope / per_depth / 2.0 : 0.0;
    }
  }
  calibration.depth_variance = of_mean.dot(core.filter.covariance() * of_mean);
  return calibration;
}

// The tread ahead comes under block 2. The next one is not in sight yet, so what is known of the
// pair now leans on nothing that it will say of it. What a tread that belies the site file has
// done to the filter's calibration is in that for good: then the one from before it stays.
void FusedModel::hand_gauge_on(FusedCore & core) const
{
  core.gauged_here = core.gauge_ahead.depth_m(core.front_calibration.depth_variance);
  core.gauge_ahead = {};
  core.site_belied =
    core.site_belied || (core.gauged_here && belies_site(*core.gauged_here, *core.located_on + 1));
  if (!core.site_belied) {
    core.front_calibration = front_calibration(core);
  }
}

void FusedModel::begin_gauge(FusedCore & core) const
{
  core.gauged_here.reset();
  core.gauge_ahead = {};
  core.site_belied = false;
  core.front_calibration = front_calibration(core);
}

// Readings count whether they pass their gates or not, one by one: the mean is of many.
void FusedModel::gauge_tread_ahead(FusedCore & core, const RangeSample & sample) const
{
  const auto x_m = core.gauge_ahead.x_m(core.travel_m);
  const auto heights = core.steps.heights_in_flight();
  if (!core.located_on || !x_m || !heights) {
    return;
  }
  for (std::size_t i = 0; i < fronts_.size(); ++i) {
    const RangeReading & reading = sample[kFrontPair[i]];
    const double beam_z_m = (*heights)[0] + robot_.at(kFrontPair[i]).height_m;
    const auto seen = riser_ahead(flight_, beam_z_m, params_.heading.nosing_margin_m);
    if (
      reading.status != RangeStatus::kValid || seen != *core.located_on + 2 ||
      sees_side_wall(core, kFrontPair[i], reading.range_m) ||
      !cone_is_clear(beam_z_m, *seen, reading.range_m)) {
      continue;
    }
    StateVector state = core.filter.state();
    state[kStateX] = *x_m;
    state[offset_index(fronts_[i].ranger())] = core.front_calibration.offset_m[i];
    state[gain_index(fronts_[i].ranger())] = core.front_calibration.gain[i];
    const Expectation expected = fronts_[i].expect(state, SeenRiser::kNext, 0.0);
    const double per_depth = of_tread_ahead(expected)->slope;
    core.gauge_ahead.add(
      state[kStateTreadAhead] + (reading.range_m - expected.value()) / per_depth,
      range_variance_m2(reading.range_m) / squared(per_depth));
  }
}

}  // namespace stetro_localizer
