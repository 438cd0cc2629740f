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

#ifndef NODE__STEPPED_RUN_HPP_
#define NODE__STEPPED_RUN_HPP_

#include <functional>

#include "node/driver_front.hpp"
#include "stetro_dds/executor.hpp"
#include "stetro_driver/pacer.hpp"

namespace stetro_driver
{

/// The driver of a world that waits for its steps: time is ours to make. One thread.
class SteppedRun
{
public:
  /// \param hardware with a stepped world; outlives the run
  SteppedRun(
    stetro_dds::Context & context, stetro_dds::NodeOptions options, const DriverSetup & setup,
    const DriverHardware & hardware);

  void start();

  /// One tick: the command in force, the world, the topics. No clock is read.
  void step();

  /// Ticks at `sim.speed` of the steady clock, slower while localizer or supervisor are behind.
  void run(stetro_dds::Executor & executor, const std::function<bool()> & stop);

  [[nodiscard]] stetro_dds::Node & node() { return front_.node(); }

private:
  [[nodiscard]] RobotAccess access();
  [[nodiscard]] GateClocks clocks() const;
  std::optional<stetro_dds::Refusal> hear_localizer(Time stamp);
  Time configured();
  void report();

  HardwareInterface & robot_;
  SteppedWorld & world_;
  bool paced_ = false;
  Pacer pacer_;
  DriverFront front_;
};

}  // namespace stetro_driver

#endif  // NODE__STEPPED_RUN_HPP_
