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

#ifndef NODE__LOCALIZER_PARTS_HPP_
#define NODE__LOCALIZER_PARTS_HPP_

#include <array>
#include <chrono>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>

#include "node/convert.hpp"
#include "stetro_dds/node.hpp"
#include "stetro_localizer/building_estimator.hpp"
#include "stetro_localizer/localizer_node.hpp"
#include "stetro_localizer/stamp_guard.hpp"
#include "stetro_localizer/state_file.hpp"
#include "stetro_msgs/PoseCorrection.hpp"

namespace stetro_localizer
{

/// What people said on `initialpose`.
struct ToldPoses
{
  explicit ToldPoses(Nanoseconds future_tolerance) : order({future_tolerance, kOldest}) {}

  static constexpr std::chrono::seconds kOldest{5};
  StampGuard order;  // of those taken
  std::uint64_t taken = 0;
  std::uint64_t refused = 0;
  stetro_dds::Refusal last_refusal;  // empty: none yet
  Nanoseconds last_logged{0};        // on the steady clock
};

/// What the node is made of. The messages keep their memory from one answer to the next.
class LocalizerNode::Parts
{
public:
  Parts(
    stetro_dds::Context & context, const stetro_dds::NodeOptions & options,
    const LocalizerSetup & setup);

private:
  friend class LocalizerNode;

  void read_state();
  void open_sensors();
  void open_corrections();
  void add_diagnostics();
  std::optional<stetro_dds::Refusal> take_ranges(const stetro_msgs::msg::RangeArray & message);
  std::optional<stetro_dds::Refusal> take_told_pose(
    const geometry_msgs::msg::PoseWithCovarianceStamped & message);
  std::optional<stetro_dds::Refusal> judge_told_pose(
    const geometry_msgs::msg::PoseWithCovarianceStamped & message);
  std::optional<stetro_dds::Refusal> take_correction(
    const stetro_msgs::msg::PoseCorrection & message);
  void tick(Nanoseconds now);
  void watch_clock();
  void publish();
  void publish_later_than(Nanoseconds before);
  void publish_innovations();
  void tell_changes(const StairEstimate & estimate);
  void tell_resets(const StairEstimate & estimate);
  void store();
  void write(const StoredState & state);
  void report_estimate(stetro_dds::DiagnosticReport & report) const;
  void report_inputs(stetro_dds::DiagnosticReport & report);
  void report_corrections(stetro_dds::DiagnosticReport & report) const;
  void report_calibration(stetro_dds::DiagnosticReport & report) const;
  void report_staircase(stetro_dds::DiagnosticReport & report) const;

  const LocalizerParams params_;
  stetro_dds::Node node_;
  std::unique_ptr<BuildingEstimator> estimator_;
  StateFile state_file_;
  std::string state_trouble_;  // empty: the state file is well
  std::uint64_t stored_version_ = 0;
  std::optional<stetro_site::Pose> odom_;  // base_link in odom, by the wheels
  int stalled_checks_ = 0;                 // in a row in which the node's time stood still
  Nanoseconds last_checked_{0};
  std::optional<Integrity> told_integrity_;
  std::optional<int> told_step_;
  std::string told_segment_;
  std::uint32_t told_resets_ = 0;  // the last one in the log
  ToldPoses told_poses_;
  CorrectionOutcome told_correction_ = CorrectionOutcome::kNone;  // the last one in the log
  std::uint64_t unfit_corrections_ = 0;                           // that no estimator has seen
  std::array<std::uint64_t, kSourceCount> counted_{};             // samples at the last report
  Nanoseconds counted_at_{0};                                     // on the steady clock

  stetro_dds::Publisher<geometry_msgs::msg::PoseWithCovarianceStamped> & pose_;
  stetro_dds::Publisher<stetro_msgs::msg::StairPose> & stair_pose_;
  stetro_dds::Publisher<stetro_msgs::msg::Innovations> & innovations_;
  stetro_dds::Publisher<tf2_msgs::msg::TFMessage> & tf_;
  stetro_dds::Publisher<tf2_msgs::msg::TFMessage> & static_tf_;
  geometry_msgs::msg::PoseWithCovarianceStamped pose_message_;
  stetro_msgs::msg::StairPose stair_pose_message_;
  stetro_msgs::msg::Innovations innovations_message_;
  tf2_msgs::msg::TFMessage tf_message_;
};

}  // namespace stetro_localizer

#endif  // NODE__LOCALIZER_PARTS_HPP_
