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

#ifndef SUPPORT__LOCALIZER_ON_WIRE_HPP_
#define SUPPORT__LOCALIZER_ON_WIRE_HPP_

#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <optional>
#include <string>

#include "node/convert.hpp"
#include "stetro_config/report.hpp"
#include "stetro_dds/executor.hpp"
#include "stetro_localizer/localizer_node.hpp"
#include "stetro_site/robot.hpp"
#include "support/sensor_wire.hpp"

namespace stetro_localizer
{

/// The localizer, the robot's sensors on the wire, and somebody who listens; one process.
class LocalizerOnWire : public testing::Test
{
protected:
  /// The node is not started yet. \param site as it stands in the site file
  explicit LocalizerOnWire(const std::string & site)
  {
    std::filesystem::create_directories(folder_);
    params_.site_file = (folder_ / "site.yaml").string();
    params_.robot_file = (folder_ / "robot.yaml").string();
    std::ofstream{params_.site_file} << site;
    std::ofstream{params_.robot_file} << stetro_config::to_yaml(stetro_site::Robot{});
    listen();
  }

  ~LocalizerOnWire() override
  {
    stop();
    std::filesystem::remove_all(folder_);
  }

  void start()
  {
    localizer_.emplace(
      context_, stetro_dds::NodeOptions{"localizer", "/stetro", stetro_dds::TimeSource::kByHand},
      params_);
    executor_.add(localizer_->node());
    wire_.set_turn([this](Nanoseconds now) {
      if (localizer_) {
        localizer_->node().clock().set(now);
      }
      executor_.drain();
    });
  }

  void stop()
  {
    if (localizer_) {
      executor_.remove(localizer_->node());
      localizer_.reset();
    }
  }

  /// A value of a task in the node's diagnostics; empty if there is none.
  [[nodiscard]] std::string diagnosed(const std::string & of, const std::string & key)
  {
    for (const auto & [task, report] : localizer_->node().diagnostics().reports()) {
      for (const auto & [name, value] : report.values()) {
        if (task == of && name == key) {
          return value;
        }
      }
    }
    return "";
  }

  const std::filesystem::path folder_ =
    std::filesystem::temp_directory_path() / ("localizer_" + std::to_string(::getpid()));
  LocalizerParams params_;
  stetro_dds::Context context_{test_options()};
  stetro_dds::Executor executor_;
  SensorWire wire_{context_};
  std::optional<stetro_msgs::msg::StairPose> stair_pose_;
  std::optional<geometry_msgs::msg::PoseWithCovarianceStamped> pose_;
  std::optional<stetro_msgs::msg::Innovations> innovations_;
  std::optional<tf2_msgs::msg::TFMessage> tf_;
  std::optional<tf2_msgs::msg::TFMessage> static_tf_;
  std::optional<LocalizerNode> localizer_;

private:
  void listen()
  {
    namespace qos = stetro_dds::qos;
    auto & node = wire_.node();
    node.subscribe<stetro_msgs::msg::StairPose>(
      "stair_pose", qos::kLatched,
      [this](const stetro_msgs::msg::StairPose & m) { stair_pose_ = m; });
    node.subscribe<geometry_msgs::msg::PoseWithCovarianceStamped>(
      "pose", qos::kPose,
      [this](const geometry_msgs::msg::PoseWithCovarianceStamped & m) { pose_ = m; });
    node.subscribe<stetro_msgs::msg::Innovations>(
      "innovations", qos::kSensor,
      [this](const stetro_msgs::msg::Innovations & m) { innovations_ = m; });
    node.subscribe<tf2_msgs::msg::TFMessage>(
      "/tf", qos::kTf, [this](const tf2_msgs::msg::TFMessage & m) { tf_ = m; });
    node.subscribe<tf2_msgs::msg::TFMessage>(
      "/tf_static", qos::kTfStatic, [this](const tf2_msgs::msg::TFMessage & m) { static_tf_ = m; });
    executor_.add(node);
  }
};

}  // namespace stetro_localizer

#endif  // SUPPORT__LOCALIZER_ON_WIRE_HPP_
