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

#include "stetro_driver/driver_node.hpp"

#include <optional>
#include <stdexcept>
#include <string>
#include <utility>

#include "node/stepped_run.hpp"
#include "node/timed_run.hpp"

namespace stetro_driver
{
namespace
{

stetro_dds::NodeOptions options_for(
  stetro_dds::NodeOptions options, const DriverHardware & hardware)
{
  const bool simulated = hardware.world != nullptr;
  options.time = simulated ? stetro_dds::TimeSource::kByHand : stetro_dds::TimeSource::kSystem;
  options.hardware_id = simulated ? "simulated stetro" : "stetro";
  return options;
}

}  // namespace

/// The hardware, and the one of the two runs that fits it.
class DriverNode::Body
{
public:
  Body(
    stetro_dds::Context & context, stetro_dds::NodeOptions options, const DriverSetup & setup,
    DriverHardware hardware)
  : hardware_(std::move(hardware))
  {
    options = options_for(std::move(options), hardware_);
    if (hardware_.stepped != nullptr) {
      stepped_.emplace(context, std::move(options), setup, hardware_);
    } else {
      timed_.emplace(context, std::move(options), setup, hardware_);
    }
  }

  ~Body() { hardware_.robot->make_safe(); }
  Body(const Body &) = delete;
  Body & operator=(const Body &) = delete;

  void start() { stepped_ ? stepped_->start() : timed_->start(); }

  void step()
  {
    if (!stepped_) {
      throw std::logic_error("DriverNode::step() is for a world that waits for its steps");
    }
    stepped_->step();
  }

  void run(stetro_dds::Executor & executor, const std::function<bool()> & stop)
  {
    stepped_ ? stepped_->run(executor, stop) : timed_->run(executor, stop);
  }

  stetro_dds::Node & node() { return stepped_ ? stepped_->node() : timed_->node(); }
  const SimulatedWorld * world() const { return hardware_.world; }

private:
  const DriverHardware hardware_;
  std::optional<SteppedRun> stepped_;
  std::optional<TimedRun> timed_;
};

DriverNode::DriverNode(
  stetro_dds::Context & context, stetro_dds::NodeOptions options, const DriverSetup & setup)
: DriverNode(context, std::move(options), setup, make_hardware(setup))
{
}

DriverNode::DriverNode(
  stetro_dds::Context & context, stetro_dds::NodeOptions options, const DriverSetup & setup,
  DriverHardware hardware)
: body_(std::make_unique<Body>(context, std::move(options), setup, std::move(hardware)))
{
}

DriverNode::~DriverNode() = default;

void DriverNode::start() { body_->start(); }

void DriverNode::step() { body_->step(); }

void DriverNode::run(stetro_dds::Executor & executor, const std::function<bool()> & stop)
{
  body_->run(executor, stop);
}

stetro_dds::Node & DriverNode::node() { return body_->node(); }

const SimulatedWorld * DriverNode::world() const { return body_->world(); }

}  // namespace stetro_driver
