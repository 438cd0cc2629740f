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

#include "sim/sim_contacts.hpp"

namespace stetro_driver::sim
{

SimContacts::SimContacts(const SimErrors & errors, std::uint64_t seed)
{
  RandomStream random{seed, "contacts"};
  for (std::size_t i = 0; i < kBumpers; ++i) {
    closing_gap_m_[i] = random.uniform(-errors.bumper_max_m, errors.bumper_max_m);
  }
  for (const ContactPlace place : {ContactPlace::kRiserLeft, ContactPlace::kRiserRight}) {
    closing_gap_m_[static_cast<std::size_t>(place)] =
      random.uniform(-errors.switch_max_m, errors.switch_max_m);
  }
}

void SimContacts::observe(const SimBody & body, Time now, const FaultInjector & faults)
{
  const auto look = [&](ContactPlace place, double gap_m) {
    const auto i = static_cast<std::size_t>(place);
    readings_[i].fault = faults.acting(SimFaultKind::kDead, kContactNames[i]) != nullptr;
    if (!readings_[i].fault && !faults.acting(SimFaultKind::kStuck, kContactNames[i])) {
      set(place, gap_m <= closing_gap_m_[i], now);
    }
  };
  for (int block = 1; block <= 3; ++block) {
    const auto i = static_cast<std::size_t>(block - 1);
    look(static_cast<ContactPlace>(i), body.bumper_gap_m(block, true));
    look(static_cast<ContactPlace>(i + kBumpers / 2), body.bumper_gap_m(block, false));
  }
  look(ContactPlace::kRiserLeft, body.switch_gap_m(body.shape().switch_y_m));
  look(ContactPlace::kRiserRight, body.switch_gap_m(-body.shape().switch_y_m));
}

void SimContacts::press_emergency_stop(bool pressed, Time now)
{
  set(ContactPlace::kEmergencyStop, pressed, now);
  emergency_stop_latched_ = emergency_stop_latched_ || pressed;
}

bool SimContacts::reset_emergency_stop()
{
  emergency_stop_latched_ =
    readings_[static_cast<std::size_t>(ContactPlace::kEmergencyStop)].closed;
  return !emergency_stop_latched_;
}

void SimContacts::set(ContactPlace place, bool closed, Time now)
{
  ContactReading & reading = readings_[static_cast<std::size_t>(place)];
  if (reading.closed != closed) {
    reading.closed = closed;
    reading.last_change = now;
  }
}

}  // namespace stetro_driver::sim
