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

#ifndef FAKE_ROBOT_HPP_
#define FAKE_ROBOT_HPP_

#include <atomic>
#include <functional>
#include <optional>

#include "stetro_driver/hardware_interface.hpp"

namespace stetro_driver::test
{

/// Hardware that remembers what it was told.
class FakeRobot : public HardwareInterface
{
public:
  void configure() override {}
  void activate() override
  {
    ++activations;
    broken = false;
  }
  void deactivate() override {}
  void reset_emergency_stop() override {}
  Result<SensorFrame> read(Time now) override
  {
    if (on_read) {
      on_read();
    }
    SensorFrame frame;
    frame.time = now;
    frame.ranges_complete = ++reads % 3 == 0;
    frame.blocks[0].fault = broken;
    return frame;
  }
  std::optional<IoFault> write(const JointCommand & command) override
  {
    ++writes;
    vx_m_s = command.vx_m_s;
    return fault;
  }
  void make_safe() noexcept override { ++safes; }

  std::function<void()> on_read;
  std::optional<IoFault> fault;
  std::atomic<bool> broken{false};  // a block, until it is activated again
  std::atomic<int> reads{0};
  std::atomic<int> writes{0};
  std::atomic<double> vx_m_s{0.0};
  std::atomic<int> safes{0};
  std::atomic<int> activations{0};
};

}  // namespace stetro_driver::test

#endif  // FAKE_ROBOT_HPP_
