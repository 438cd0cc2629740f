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

#include <cmath>
#include <string>

#include "node/localizer_parts.hpp"
#include "node/staircase_report.hpp"
#include "stetro_localizer/input_watch.hpp"

namespace stetro_localizer
{

using stetro_dds::DiagnosticReport;
using stetro_dds::Health;

void LocalizerNode::Parts::add_diagnostics()
{
  auto & diagnostics = node_.diagnostics();
  diagnostics.add("estimate", [this](DiagnosticReport & report) { report_estimate(report); });
  diagnostics.add("inputs", [this](DiagnosticReport & report) { report_inputs(report); });
  diagnostics.add("corrections", [this](DiagnosticReport & report) { report_corrections(report); });
  diagnostics.add("calibration", [this](DiagnosticReport & report) { report_calibration(report); });
  diagnostics.add(
    "staircase as built", [this](DiagnosticReport & report) { report_staircase(report); });
}

void LocalizerNode::Parts::report_estimate(DiagnosticReport & report) const
{
  const StairEstimate & estimate = estimator_->estimate();
  const std::string why = reason_names(estimate.reasons);
  if (estimate.integrity == Integrity::kLost) {
    report.summarise(Health::kError, "LOST: " + why);
  } else if (estimate.integrity == Integrity::kDegraded) {
    report.summarise(Health::kWarn, "DEGRADED: " + why);
  }
  report.value("segment", estimator_->segment().id);
  report.value("step", static_cast<std::int64_t>(estimate.step.value_or(-1)));
  report.value("y [m]", estimate.pose.y_m);
  report.value("y sigma [m]", std::sqrt(estimate.covariance(1, 1)));
  report.value("heading [deg]", estimate.pose.yaw_rad * 180.0 / M_PI);
  report.value("heading sigma [deg]", std::sqrt(estimate.covariance(5, 5)) * 180.0 / M_PI);
  report.value("resets", static_cast<std::uint64_t>(estimate.reset_counter));
  report.value("last reset", std::string(to_string(estimate.reset_cause)));
  report.value("initialpose taken", told_poses_.taken);
  report.value("initialpose refused", told_poses_.refused);
  if (told_poses_.refused > 0) {
    const stetro_dds::Refusal & last = told_poses_.last_refusal;
    report.value("initialpose last refused", last.reason + ": " + last.detail);
  }
  if (estimate.contact_closure_m) {
    report.value("contact closure [m]", *estimate.contact_closure_m);
  }
}

void LocalizerNode::Parts::report_staircase(DiagnosticReport & report) const
{
  tell(
    report, estimator_->staircase_as_built(), estimator_->flight(),
    params_.fused.alerts.as_built_m);
}

void LocalizerNode::Parts::report_corrections(DiagnosticReport & report) const
{
  for (std::size_t i = 1; i < kCorrectionOutcomes; ++i) {
    const std::uint64_t count = estimator_->corrections()[i];
    if (count > 0) {
      report.value(to_string(static_cast<CorrectionOutcome>(i)), count);
    }
  }
  report.value("bad message", unfit_corrections_);
  report.value("hand-overs", estimator_->crossings());
}

void LocalizerNode::Parts::report_inputs(DiagnosticReport & report)
{
  const Nanoseconds now = stetro_dds::Clock::steady_now();
  const double elapsed_s = seconds(now - counted_at_);
  for (const Source input : InputWatch::kInputs) {
    const SourceReport & of = estimator_->reports()[input];
    auto & counted = counted_[static_cast<std::size_t>(input)];
    const std::string name = to_string(input);
    report.value(name + " [Hz]", static_cast<double>(of.fused - counted) / elapsed_s);
    counted = of.fused;
    for (std::size_t why = 1; why < kRefusalCount; ++why) {
      if (of.refused[why] > 0) {
        report.value(name + " refused, " + to_string(static_cast<Refusal>(why)), of.refused[why]);
      }
    }
  }
  counted_at_ = now;
  for (const Source source : estimator_->compared()) {
    report.value(std::string(to_string(source)) + " gated", estimator_->reports()[source].gated);
  }
  if (estimator_->estimate().reasons & kInputSilent) {
    report.summarise(Health::kWarn, "an input is silent");
  }
}

void LocalizerNode::Parts::report_calibration(DiagnosticReport & report) const
{
  for (const Bias & bias : estimator_->biases()) {
    report.value(bias.name, bias.estimate.value);
    report.value(std::string(bias.name) + " sigma", std::sqrt(bias.estimate.variance));
  }
  report.value("state file", state_file_.path());
  if (!state_trouble_.empty()) {
    report.summarise(Health::kError, "state file: " + state_trouble_);
  }
}

}  // namespace stetro_localizer
