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

#ifndef SIM__SIM_TOF_HPP_
#define SIM__SIM_TOF_HPP_

#include <string_view>
#include <vector>

#include "sim/random_stream.hpp"
#include "sim/sim_body.hpp"
#include "stetro_driver/body_shape.hpp"
#include "stetro_driver/sensor_frame.hpp"
#include "stetro_driver/sim_errors.hpp"

namespace stetro_driver::sim
{

/// What a cone of light brings back from a scene.
struct Echo
{
  double distance_m = 0.0;    ///< weighted by returned energy, cos(incidence) / distance^2
  double equivalent_m = 0.0;  ///< 1 / sqrt(mean energy over the cone): a white wall this far away
  bool any = false;
};

/// A simulated VL53L0X behind a driver that hands out bare millimetres.
/**
 * effective distance: mean over the rays of the 25 degree cone, weighted by the energy they return;
 * reading = round to mm(effective (1 + gain) + offset + slow + flicker + white). Whether there is a
 * reading at all depends on the echo's strength. What the kernel interface cannot tell apart (a weak
 * echo that looks like a distance) is handed on as it comes.
 *
 * Slow and flicker wander, over minutes and within seconds: averaging does not take them out, as
 * in a recorded sensor. Derivation: docs/derivations/range_noise.md.
 */
class SimTof
{
public:
  SimTof(
    const TofMounting & mounting, const SimErrors & errors, std::uint64_t seed,
    std::string_view name);

  /// One measurement. \param cycle_s time since the last one
  [[nodiscard]] RangeReading measure(const SimBody & body, Time now, double cycle_s);

  /// The echo before any error: of use to tests and plots.
  [[nodiscard]] Echo echo(const SimBody & body) const;

  [[nodiscard]] double offset_m() const { return offset_m_; }
  [[nodiscard]] double gain() const { return gain_; }

  template <class Archive>
  void archive(Archive & each)
  {
    random_.archive(each);
    slow_.archive(each);
    flicker_random_.archive(each);
    flicker_.archive(each);
  }

private:
  [[nodiscard]] bool finds(double equivalent_m);
  [[nodiscard]] double spurious_m();

  TofMounting mounting_;
  SimErrors errors_;
  std::vector<Vector3> rays_;  // unit, about the mounting's direction, equal solid angles
  RandomStream random_;
  double offset_m_;
  double gain_;
  Wander slow_;
  RandomStream flicker_random_;  // its own: the other errors of a seed do not depend on it
  Wander flicker_;
};

}  // namespace stetro_driver::sim

#endif  // SIM__SIM_TOF_HPP_
