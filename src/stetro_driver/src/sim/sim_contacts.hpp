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

#ifndef SIM__SIM_CONTACTS_HPP_
#define SIM__SIM_CONTACTS_HPP_

#include <array>

#include "sim/fault_injector.hpp"
#include "sim/random_stream.hpp"
#include "sim/sim_body.hpp"
#include "stetro_driver/sensor_frame.hpp"
#include "stetro_driver/sim_errors.hpp"

namespace stetro_driver::sim
{

/// Six bumpers, two riser switches and the emergency stop.
/** Each closes at a gap of its own, within the tolerance of its kind. */
class SimContacts
{
public:
  SimContacts(const SimErrors & errors, std::uint64_t seed);

  /// Looks at the gaps and remembers what changed when.
  void observe(const SimBody & body, Time now, const FaultInjector & faults);

  /// Presses or releases the button of the emergency stop. Pressed once, it stays latched.
  void press_emergency_stop(bool pressed, Time now);

  /// Ends the latch. \return whether it has ended: not while the button is pressed
  bool reset_emergency_stop();

  [[nodiscard]] bool emergency_stop_latched() const { return emergency_stop_latched_; }

  [[nodiscard]] const std::array<ContactReading, kContactPlaces> & readings() const
  {
    return readings_;
  }

  template <class Archive>
  void archive(Archive & each)
  {
    for (ContactReading & reading : readings_) {
      each(reading.closed, reading.fault, reading.last_change);
    }
    each(emergency_stop_latched_);
  }

private:
  void set(ContactPlace place, bool closed, Time now);

  std::array<double, kContactPlaces> closing_gap_m_{};
  std::array<ContactReading, kContactPlaces> readings_{};
  bool emergency_stop_latched_ = false;
};

}  // namespace stetro_driver::sim

#endif  // SIM__SIM_CONTACTS_HPP_
