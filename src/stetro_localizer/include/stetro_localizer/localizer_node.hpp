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

#ifndef STETRO_LOCALIZER__LOCALIZER_NODE_HPP_
#define STETRO_LOCALIZER__LOCALIZER_NODE_HPP_

#include <memory>

#include "stetro_dds/context.hpp"
#include "stetro_dds/node.hpp"
#include "stetro_localizer/estimator.hpp"
#include "stetro_localizer/localizer_setup.hpp"
#include "stetro_localizer/params.hpp"

namespace stetro_localizer
{

/// The localizer in the graph: reads the robot's sensors, publishes where it is and how sure.
/**
 * Subscribes odom, imu/data, contacts, blocks, ranges, initialpose and pose_correction; publishes
 * pose (frame `map`), stair_pose, innovations, /tf (map -> odom), /tf_static (map -> each flight
 * and each drawn floor of the site, once) and /diagnostics. It answers each array of ranges at
 * once; with the ranges silent it publishes a prediction ten times a second. A pose that is LOST,
 * or of which a number is unknown, is not published as `pose` nor in /tf, only in stair_pose.
 *
 * The step and the calibration are read from the state file at the start and written after the
 * answer whenever they changed. Where floors are drawn the estimate goes from floor to flight to
 * floor, see BuildingEstimator.
 *
 * Belongs to its executor's thread.
 */
class LocalizerNode
{
public:
  LocalizerNode(
    stetro_dds::Context & context, const stetro_dds::NodeOptions & options,
    const LocalizerSetup & setup);

  /// Reads the setup first. \throws stetro_config::ConfigError with every fault of it
  LocalizerNode(
    stetro_dds::Context & context, const stetro_dds::NodeOptions & options,
    const LocalizerParams & params);
  ~LocalizerNode();
  LocalizerNode(const LocalizerNode &) = delete;
  LocalizerNode & operator=(const LocalizerNode &) = delete;

  stetro_dds::Node & node();

  [[nodiscard]] const StairEstimate & estimate() const;

private:
  class Parts;
  std::unique_ptr<Parts> parts_;
};

}  // namespace stetro_localizer

#endif  // STETRO_LOCALIZER__LOCALIZER_NODE_HPP_
