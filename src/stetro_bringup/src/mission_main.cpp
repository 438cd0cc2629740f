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
// An operator on the command line: asks for a mission and prints the supervisor's answer.

#include <array>
#include <chrono>
#include <cmath>
#include <iostream>
#include <limits>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "CLI/CLI.hpp"
#include "person_at_terminal.hpp"
#include "stetro_dds/executor.hpp"
#include "stetro_dds/launch.hpp"
#include "stetro_dds/node.hpp"
#include "stetro_dds/stamp.hpp"
#include "stetro_msgs/MissionRequest.hpp"
#include "stetro_msgs/MissionStatus.hpp"
#include "stetro_msgs/ProfileCheck.hpp"

namespace
{

namespace request = stetro_msgs::msg::MissionRequest_Constants;
namespace status = stetro_msgs::msg::MissionStatus_Constants;
namespace qos = stetro_dds::qos;
using std::chrono_literals::operator""ms;
using Clock = std::chrono::steady_clock;
using stetro_bringup::kDone;
using stetro_bringup::kNoAnswer;
using stetro_bringup::kRefused;
using stetro_msgs::msg::MissionRequest;
using stetro_msgs::msg::MissionStatus;
using stetro_msgs::msg::ProfileCheck;

const std::map<std::string, std::uint8_t> kKinds = {
  {"clean", request::KIND_CLEAN_FLIGHT},    {"go", request::KIND_GO_TO_SEGMENT},
  {"pause", request::KIND_PAUSE},           {"resume", request::KIND_RESUME},
  {"abort", request::KIND_ABORT},           {"clear-fault", request::KIND_CLEAR_FAULT},
  {"relocalise", request::KIND_RELOCALISE}, {"check-pose", request::KIND_CHECK_POSE}};

// A check may use a scan from shortly before it was asked for.
constexpr std::chrono::seconds kScanBefore{1};

constexpr double kUnknown = std::numeric_limits<double>::quiet_NaN();
constexpr double kDegree = M_PI / 180.0;

// How well a person with a tape measure knows it, one standard deviation.
constexpr double kToldSigma = 0.05;                  // [m]
constexpr double kToldHeadingSigma = 3.0 * kDegree;  // [rad]

struct Order
{
  std::string what = "status";
  std::string segment;
  std::string frame;  // of the pose; empty: the segment's
  std::vector<double> pose = {kUnknown, kUnknown, kUnknown, kUnknown};  // x, y, z [m], psi [deg]
  int step = request::STEP_UNKNOWN;
  double patience_s = 10.0;
};

// In the order of MISSION_* of MissionStatus.
constexpr std::array kMissionNames = {"unknown", "idle",     "running", "paused",
                                      "held",    "finished", "aborted", "fault"};

void print(const MissionStatus & now)
{
  const std::size_t mission = now.mission() < kMissionNames.size() ? now.mission() : 0;
  std::cout << "mission " << kMissionNames[mission] << ", state '" << now.state().c_str()
            << "', step " << now.step() << " of " << now.step_count();
  if (now.fault().size() > 0) {
    std::cout << ", fault '" << now.fault().c_str() << "': " << now.fault_detail().c_str();
  }
  std::cout << std::endl;
}

// In the order of VERDICT_* of ProfileCheck.
constexpr std::array kVerdictNames = {"unknown", "agrees", "corrected", "ambiguous", "no verdict"};

void print(const ProfileCheck & check)
{
  const std::size_t verdict = check.verdict() < kVerdictNames.size() ? check.verdict() : 0;
  std::cout << "profile on '" << check.segment_id().c_str() << "': " << kVerdictNames[verdict]
            << ": " << check.reason().c_str() << std::endl;
}

class Operator
{
public:
  Operator(stetro_dds::Context & context, const stetro_dds::NodeOptions & options)
  : node_(context, options),
    requests_(node_.advertise<MissionRequest>("mission", qos::kMission)),
    id_(std::to_string(Clock::now().time_since_epoch().count()))
  {
    node_.subscribe<MissionStatus>(
      "mission_status", qos::kLatched, [this](const MissionStatus & heard) { heard_ = heard; });
    node_.subscribe<ProfileCheck>(
      "profile_check", qos::kLatched, [this](const ProfileCheck & heard) {
        const auto stamp = stetro_dds::time_of(heard.header().stamp());
        if (asked_ && stamp + kScanBefore >= *asked_) {
          check_ = heard;
        }
      });
  }

  stetro_dds::Node & node() { return node_; }

  void ask(const Order & order)
  {
    MissionRequest message;
    asked_ = node_.clock().now();
    message.header().stamp() = stetro_dds::stamp_of(*asked_);
    message.request_id() = id_.c_str();
    message.issuer() = "stetro_mission";
    message.kind() = kKinds.at(order.what);
    message.segment_id() = order.segment.c_str();
    message.step() = order.step;
    if (order.what == "relocalise") {
      tell(order, message);
    }
    requests_.publish(message);
  }

  [[nodiscard]] bool reaches_a_supervisor() const
  {
    return requests_.matched() > 0 && node_.clock().known();
  }
  [[nodiscard]] bool is_answered() const { return heard_ && heard_->request_id().c_str() == id_; }
  [[nodiscard]] const std::optional<MissionStatus> & heard() const { return heard_; }
  /// Of a scan of about the time of the request, or later.
  [[nodiscard]] const std::optional<ProfileCheck> & check() const { return check_; }

private:
  static void tell(const Order & order, MissionRequest & message)
  {
    message.header().frame_id() = (order.frame.empty() ? order.segment : order.frame).c_str();
    auto & pose = message.pose().pose();
    pose.position().x(order.pose[0]);
    pose.position().y(order.pose[1]);
    pose.position().z(order.pose[2]);
    pose.orientation().x(0.0);
    pose.orientation().y(0.0);
    pose.orientation().z(std::sin(order.pose[3] * kDegree / 2.0));
    pose.orientation().w(std::cos(order.pose[3] * kDegree / 2.0));
    auto & covariance = message.pose().covariance();
    covariance[0] = covariance[7] = covariance[14] = kToldSigma * kToldSigma;
    covariance[35] = kToldHeadingSigma * kToldHeadingSigma;
  }

  stetro_dds::Node node_;
  stetro_dds::Publisher<MissionRequest> & requests_;
  const std::string id_;
  std::optional<MissionStatus> heard_;
  std::optional<std::chrono::nanoseconds> asked_;
  std::optional<ProfileCheck> check_;
};

/// Waits for what a check that was accepted has told.
int tell_check(
  const Order & order, Operator & person, stetro_dds::Executor & executor,
  Clock::time_point deadline)
{
  while (Clock::now() < deadline && !person.check()) {
    executor.spin_some(20ms);
  }
  if (!person.check()) {
    std::cerr << "no scan could be used within " << order.patience_s << " s\n";
    return kNoAnswer;
  }
  print(*person.check());
  return kDone;
}

int carry_out(const Order & order, Operator & person, stetro_dds::Executor & executor)
{
  const auto patience = std::chrono::duration<double>(order.patience_s);
  const auto deadline = Clock::now() + std::chrono::duration_cast<Clock::duration>(patience);
  const bool only_look = order.what == "status";
  bool asked = false;
  while (Clock::now() < deadline &&
         !(only_look ? person.heard().has_value() : person.is_answered())) {
    if (!only_look && !asked && person.reaches_a_supervisor()) {
      person.ask(order);
      asked = true;
    }
    executor.spin_some(20ms);
  }
  if (!person.heard() || !(only_look || person.is_answered())) {
    return stetro_bringup::no_answer("supervisor", order.patience_s);
  }
  if (only_look) {
    print(*person.heard());
    return kDone;
  }
  const bool accepted = person.heard()->answer() == status::ANSWER_ACCEPTED;
  std::cout << order.what << (accepted ? " accepted" : " refused: ")
            << person.heard()->answer_reason().c_str() << std::endl;
  if (accepted && order.what == "check-pose") {
    return tell_check(order, person, executor, deadline);
  }
  return accepted ? kDone : kRefused;
}

}  // namespace

int main(int argc, char ** argv)
{
  Order order;
  const auto options = [&order](CLI::App & app) {
    std::set<std::string> words{"status"};
    for (const auto & [word, kind] : kKinds) {
      words.insert(word);
    }
    app.add_option("request", order.what, "what to ask for, or status")
      ->check(CLI::IsMember(words))
      ->capture_default_str();
    app.add_option(
      "--flight,--segment", order.segment,
      "id of the flight, for clean; of the flight or floor, for go and relocalise");
    app
      .add_option(
        "--pose", order.pose,
        "for relocalise: x, y, z [m] and heading [deg] of the middle block's place on its tread or "
        "floor")
      ->expected(4);
    app.add_option("--frame", order.frame, "of the pose: map, or the segment's id, the default");
    app.add_option("--step", order.step, "for relocalise: its tread, 0 the floor; -1 unknown")
      ->capture_default_str();
    app.add_option("--patience", order.patience_s, "how long to wait for the answer [s]")
      ->check(CLI::PositiveNumber)
      ->capture_default_str();
    app.footer(
      "check-pose compares a scan with the map and prints what comes of it, on a floor.\n"
      "Exit status: 0 accepted, 1 refused (the reason is printed), 3 nobody answered.");
  };
  return stetro_dds::run_main(
    argc, argv,
    {"stetro_mission", "Asks the supervisor for something, and prints its answer.", options},
    [&order](stetro_dds::Launch & launch) {
      return stetro_bringup::with_person<Operator>(
        launch, "operator", [&order](Operator & person, stetro_dds::Executor & executor) {
          return carry_out(order, person, executor);
        });
    });
}
