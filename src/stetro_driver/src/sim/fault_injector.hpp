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

#ifndef SIM__FAULT_INJECTOR_HPP_
#define SIM__FAULT_INJECTOR_HPP_

#include <string_view>
#include <vector>

#include "stetro_driver/sim_faults.hpp"

namespace stetro_driver::sim
{

/// Knows which faults act now. Those that happen once remember that they did.
class FaultInjector
{
public:
  explicit FaultInjector(std::vector<SimFault> faults);

  /// \param elapsed_s since the simulation's start
  void advance(double elapsed_s) { elapsed_s_ = elapsed_s; }

  /// The robot has driven on a floor for so long.
  void drive(std::string_view floor, double time_s);

  /// The fault of this kind that acts on a device now; nullptr when there is none.
  [[nodiscard]] const SimFault * acting(SimFaultKind kind, std::string_view device = {}) const;

  /// The same for faults that happen once: from now on it has happened.
  [[nodiscard]] const SimFault * strike(SimFaultKind kind);

  /// How long an acting fault has acted [s].
  [[nodiscard]] double acting_for_s(const SimFault & fault) const
  {
    return elapsed_s_ - fault.from_s;
  }

  /// Whether one that happens once is due and has not happened.
  [[nodiscard]] bool pending(SimFaultKind kind) const;

  template <class Archive>
  void archive(Archive & each)
  {
    for (Due & due : faults_) {
      each(due.struck, due.driven_s);
    }
  }

private:
  struct Due
  {
    SimFault fault;
    bool struck = false;
    double driven_s = 0.0;  // on its floor, if it has one
  };
  [[nodiscard]] bool in_time(const Due & due) const;

  std::vector<Due> faults_;
  double elapsed_s_ = 0.0;
};

}  // namespace stetro_driver::sim

#endif  // SIM__FAULT_INJECTOR_HPP_
