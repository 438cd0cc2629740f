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

#include "stetro_localizer/localizer_node.hpp"

#include <string>
#include <utility>

#include "node/localizer_parts.hpp"
#include "stetro_config/fault.hpp"

namespace stetro_localizer
{
namespace
{

namespace qos = stetro_dds::qos;
using stetro_dds::LifecycleTransition;
using Rejection = std::optional<stetro_dds::Refusal>;

constexpr std::chrono::milliseconds kTick{100};
constexpr std::chrono::milliseconds kStallCheck{500};
constexpr int kStalledChecks = 4;  // so many without time passing: the clock stalls

LocalizerSetup setup_of(const LocalizerParams & params)
{
  stetro_config::Faults faults;
  auto setup = read_setup(params, faults);
  faults.throw_if_any();
  return std::move(setup).value();
}

}  // namespace

LocalizerNode::Parts::Parts(
  stetro_dds::Context & context, const stetro_dds::NodeOptions & options,
  const LocalizerSetup & setup)
: params_(setup.params),
  node_(context, options),
  estimator_(std::make_unique<BuildingEstimator>(setup)),
  state_file_(params_.state_file),
  told_poses_(nanoseconds(params_.future_tolerance_s)),
  pose_(node_.advertise<geometry_msgs::msg::PoseWithCovarianceStamped>("pose", qos::kPose)),
  stair_pose_(node_.advertise<stetro_msgs::msg::StairPose>("stair_pose", qos::kLatched)),
  innovations_(node_.advertise<stetro_msgs::msg::Innovations>("innovations", qos::kSensor)),
  tf_(node_.advertise<tf2_msgs::msg::TFMessage>("/tf", qos::kTf)),
  static_tf_(node_.advertise<tf2_msgs::msg::TFMessage>("/tf_static", qos::kTfStatic))
{
  read_state();
  static_tf_.publish(to_static_transforms(node_.clock().now(), setup.site));
  open_sensors();
  open_corrections();
  node_.create_timer(kTick, [this](Nanoseconds now) { tick(now); });
  node_.create_steady_timer(kStallCheck, [this](Nanoseconds) { watch_clock(); });
  add_diagnostics();
  node_.lifecycle().request(LifecycleTransition::kConfigure);
  node_.lifecycle().request(LifecycleTransition::kActivate);
}

void LocalizerNode::Parts::read_state()
{
  const StateReading stored = state_file_.read();
  if (stored.kind == StateReading::Kind::kDamaged) {
    state_trouble_ = "not used: " + stored.why;
    node_.log().error("state file {}", state_trouble_);
  } else if (stored.kind == StateReading::Kind::kFound) {
    node_.log().info("step and calibration found in {}", state_file_.path());
  }
  estimator_->begin(stored);
  stored_version_ = estimator_->state_version();
  tell_resets(estimator_->estimate());
  if (stored.kind == StateReading::Kind::kFound) {  // the next restart is another number
    StoredState renumbered = stored.state;
    renumbered.reset_counter = estimator_->estimate().reset_counter;
    write(renumbered);
  }
}

// The order here is the order in which one round of the executor takes the samples: what carries
// the ranges comes before them.
void LocalizerNode::Parts::open_sensors()
{
  node_.subscribe<nav_msgs::msg::Odometry>(
    "odom", qos::kSensor, [this](const nav_msgs::msg::Odometry & message) -> Rejection {
      OdometrySample sample;
      stetro_site::Pose odom;
      if (auto rejection = take(message, sample, odom)) {
        return rejection;
      }
      const Nanoseconds before = estimator_->estimate().stamp;
      auto rejection = refusal_of(estimator_->add_odometry(sample, node_.clock().now()));
      odom_ = rejection ? odom_ : odom;
      publish_later_than(before);
      return rejection;
    });
  node_.subscribe<sensor_msgs::msg::Imu>(
    "imu/data", qos::kSensor, [this](const sensor_msgs::msg::Imu & message) -> Rejection {
      GyroSample sample;
      if (auto rejection = take(message, sample)) {
        return rejection;
      }
      const Nanoseconds before = estimator_->estimate().stamp;
      auto rejection = refusal_of(estimator_->add_gyro(sample, node_.clock().now()));
      publish_later_than(before);
      return rejection;
    });
  node_.subscribe<stetro_msgs::msg::Contacts>(
    "contacts", qos::kContacts, [this](const stetro_msgs::msg::Contacts & message) -> Rejection {
      ContactSample sample;
      auto rejection = take(message, sample);
      return rejection ? rejection
                       : refusal_of(estimator_->add_contacts(sample, node_.clock().now()));
    });
  node_.subscribe<stetro_msgs::msg::BlockStates>(
    "blocks", qos::kSensor, [this](const stetro_msgs::msg::BlockStates & message) -> Rejection {
      BlockSample sample;
      auto rejection = take(message, sample);
      return rejection ? rejection
                       : refusal_of(estimator_->add_blocks(sample, node_.clock().now()));
    });
  node_.subscribe<stetro_msgs::msg::RangeArray>(
    "ranges", qos::kSensor,
    [this](const stetro_msgs::msg::RangeArray & message) { return take_ranges(message); });
}

Rejection LocalizerNode::Parts::take_ranges(const stetro_msgs::msg::RangeArray & message)
{
  RangeSample sample;
  if (auto rejection = take(message, nanoseconds(params_.max_sample_age_s), sample)) {
    return rejection;
  }
  if (auto rejection = refusal_of(estimator_->add_ranges(sample, node_.clock().now()))) {
    return rejection;
  }
  publish();
  publish_innovations();
  store();
  return std::nullopt;
}

// Motion brings a later estimate between ranges, but not with every method.
void LocalizerNode::Parts::publish_later_than(Nanoseconds before)
{
  if (estimator_->estimate().stamp > before) {
    publish();
  }
}

void LocalizerNode::Parts::open_corrections()
{
  node_.subscribe<geometry_msgs::msg::PoseWithCovarianceStamped>(
    "initialpose", qos::kCorrection,
    [this](const geometry_msgs::msg::PoseWithCovarianceStamped & message) {
      return take_told_pose(message);
    });
  node_.subscribe<stetro_msgs::msg::PoseCorrection>(
    "pose_correction", qos::kCorrection,
    [this](const stetro_msgs::msg::PoseCorrection & message) { return take_correction(message); });
}

void LocalizerNode::Parts::tick(Nanoseconds now)
{
  const Nanoseconds before = estimator_->estimate().stamp;
  const std::uint32_t reasons = estimator_->estimate().reasons;
  estimator_->tick(now);
  const StairEstimate & after = estimator_->estimate();
  if (after.stamp > Nanoseconds{0} && (after.stamp != before || after.reasons != reasons)) {
    publish();
    publish_innovations();
  }
  store();
}

// Simulated time stands still when its driver is gone; then no tick comes to notice the silence.
void LocalizerNode::Parts::watch_clock()
{
  const Nanoseconds now = node_.clock().now();
  stalled_checks_ = now == last_checked_ ? stalled_checks_ + 1 : 0;
  last_checked_ = now;
  if (stalled_checks_ == kStalledChecks && estimator_->estimate().stamp > Nanoseconds{0}) {
    publish();
  }
}

void LocalizerNode::Parts::publish()
{
  StairEstimate estimate = estimator_->estimate();
  tell_resets(estimate);
  if (!node_.lifecycle().active()) {
    return;
  }
  if (stalled_checks_ >= kStalledChecks) {
    estimate.reasons |= kInputSilent;
    const bool known = estimate.step && estimate.integrity != Integrity::kLost;
    estimate.integrity = integrity_of(estimate.reasons, known);
  }
  const Segment & segment = estimator_->segment();
  // What is LOST on a floor has numbers still, for whoever looks for the robot: not as `pose`.
  const bool known = is_known(estimate.pose) && estimate.integrity != Integrity::kLost;
  if (known) {
    fill(pose_message_, estimate, segment);
    pose_.publish(pose_message_);
  }
  fill(stair_pose_message_, estimate, segment);
  stair_pose_.publish(stair_pose_message_);
  if (known && odom_) {
    fill(tf_message_, estimate, segment, *odom_);
    tf_.publish(tf_message_);
  }
  tell_changes(estimate);
}

void LocalizerNode::Parts::publish_innovations()
{
  if (node_.lifecycle().active()) {
    fill(innovations_message_, *estimator_, estimator_->segment());
    innovations_.publish(innovations_message_);
  }
}

void LocalizerNode::Parts::tell_changes(const StairEstimate & estimate)
{
  const Segment & segment = estimator_->segment();
  if (segment.id != told_segment_) {
    node_.log().info("on {}", segment.id.empty() ? "no segment that is known" : segment.id);
    told_segment_ = segment.id;
  }
  if (estimate.integrity != told_integrity_ || estimate.step != told_step_) {
    const bool sound = estimate.integrity == Integrity::kOk;
    node_.log().log(
      sound ? spdlog::level::info : spdlog::level::warn, "step {}, integrity {}{}{}",
      estimate.step.value_or(-1), to_string(estimate.integrity), estimate.reasons == 0u ? "" : ": ",
      reason_names(estimate.reasons));
    told_integrity_ = estimate.integrity;
    told_step_ = estimate.step;
  }
}

void LocalizerNode::Parts::store()
{
  if (estimator_->state_version() == stored_version_) {
    return;
  }
  stored_version_ = estimator_->state_version();
  write(estimator_->state_to_store());
}

void LocalizerNode::Parts::write(const StoredState & state)
{
  const auto trouble = state_file_.write(state);
  if (trouble && *trouble != state_trouble_) {
    node_.log().error("{}", *trouble);
  }
  state_trouble_ = trouble.value_or("");
}

LocalizerNode::LocalizerNode(
  stetro_dds::Context & context, const stetro_dds::NodeOptions & options,
  const LocalizerSetup & setup)
: parts_(std::make_unique<Parts>(context, options, setup))
{
}

LocalizerNode::LocalizerNode(
  stetro_dds::Context & context, const stetro_dds::NodeOptions & options,
  const LocalizerParams & params)
: LocalizerNode(context, options, setup_of(params))
{
}

LocalizerNode::~LocalizerNode() = default;

stetro_dds::Node & LocalizerNode::node() { return parts_->node_; }

const StairEstimate & LocalizerNode::estimate() const { return parts_->estimator_->estimate(); }

}  // namespace stetro_localizer
