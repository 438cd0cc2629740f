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
#include "demo_run.hpp"

#include <unistd.h>

#include <filesystem>
#include <iostream>
#include <stdexcept>
#include <thread>
#include <vector>

#include "child_process.hpp"
#include "installation.hpp"

namespace stetro_bringup
{
namespace
{

using std::chrono_literals::operator""ms;
using Clock = std::chrono::steady_clock;

constexpr double kPatience_s = 60.0;  // for a trusted pose and an accepting supervisor

stetro_dds::NodeOptions node_options()
{
  stetro_dds::NodeOptions options;
  options.name = "demo";
  options.ns = "/stetro";
  options.time = stetro_dds::TimeSource::kClockTopic;
  return options;
}

ReportFacts facts_of(const stetro_site::Deployment & deployment)
{
  ReportFacts facts;
  facts.contact_width_m = deployment.robot.geometry.contact_width_m;
  for (const stetro_site::Flight & flight : deployment.site.flights()) {
    facts.widths_m[flight.id()] = flight.width_m(0.0);
  }
  return facts;
}

}  // namespace

DemoRun::DemoRun(
  stetro_dds::Context & context, const DemoOptions & options, const Task & task,
  const stetro_site::Deployment & deployment)
: options_(options),
  task_(task),
  started_(Clock::now()),
  trace_file_(opened(options.out + "/trace.csv")),
  trace_(trace_file_),
  report_(facts_of(deployment)),
  journey_(SegmentFrames(deployment.site)),
  recorder_([this](const TraceRow & row, bool standing) { take(row, standing); }),
  demo_(context, node_options(), task, recorder_),
  progress_(std::cout, isatty(STDOUT_FILENO) == 1)
{
  if (task.is_journey) {
    files_.emplace(options.out, deployment.site);
    demo_.hear_checks([this](const CheckSample & check) { files_->add(check); });
  }
}

void DemoRun::take(const TraceRow & row, bool standing)
{
  trace_.write(row);
  journey_.add(row);
  if (standing) {
    report_.add_sweeping(row);
  }
  if (files_) {
    files_->add(row);
  }
}

bool DemoRun::goes_on()
{
  if (!demo_.accepted() && wall_time_s() > kPatience_s) {
    give_up("nothing was accepted: " + demo_.last_refusal());
  } else if (wall_time_s() > options_.time_limit_s) {
    give_up("not ended within " + std::to_string(options_.time_limit_s) + " s");
  }
  if (!troubles_.empty() || demo_.ended()) {
    over_ = Clock::now();
    return false;
  }
  ask();
  if (demo_.accepted()) {
    const auto & estimate = demo_.last_estimate();
    progress_.show(demo_.mission(), estimate ? estimate->sample.y_m : 0.0, simulated_time_s());
  }
  return true;
}

// It tells its diagnostics once a second. Who hears none reports the staircase as last told.
bool DemoRun::awaits_staircase() const
{
  return demo_.ended() && !demo_.knows_staircase() && Clock::now() - over_ < 3000ms;
}

// By the robot's clock, so that a run in one process asks at the same tick each time.
void DemoRun::ask()
{
  const auto now = demo_.node().clock().now();
  if (now - asked_ >= 500ms) {
    asked_ = now;
    demo_.ask();
  }
}

void DemoRun::give_up(const std::string & reason) { troubles_.push_back(reason); }

double DemoRun::wall_time_s() const
{
  return std::chrono::duration<double>(Clock::now() - started_).count();
}

double DemoRun::simulated_time_s() const
{
  return std::chrono::duration<double>(demo_.ended_at() - demo_.started_at()).count();
}

ClimbOutcome DemoRun::outcome() const
{
  ClimbOutcome outcome;
  outcome.completed = demo_.finished();
  if (demo_.last_estimate()) {
    outcome.final_segment = demo_.last_estimate()->sample.segment;
    outcome.final_step = demo_.last_estimate()->sample.step;
    outcome.integrity = demo_.last_estimate()->integrity;
  }
  outcome.seed = options_.seed;
  outcome.estimator = options_.estimator;
  outcome.world = options_.world;
  outcome.calibration = options_.calibration;
  outcome.in_process = options_.in_process;
  outcome.wall_time_s = wall_time_s();
  outcome.simulated_time_s = simulated_time_s();
  outcome.staircase = demo_.staircase();
  outcome.hand_overs = journey_.hand_overs();
  outcome.kidnaps = journey_.kidnaps();
  if (!options_.no_ground_truth) {
    outcome.kidnaps_asked = task_.kidnaps_on;
  }
  outcome.times_held = demo_.times_held();
  outcome.faults = demo_.faults();
  outcome.faults.insert(outcome.faults.end(), troubles_.begin(), troubles_.end());
  outcome.shortfalls = shortfalls(outcome, task_.goal);
  return outcome;
}

ClimbOutcome DemoRun::report()
{
  progress_.close();
  recorder_.flush();
  trace_file_.close();
  if (files_) {
    files_->close(journey_.kidnaps());
  }
  const ClimbOutcome result = outcome();
  const ClimbErrors errors = report_.errors();
  auto steps = opened(options_.out + "/steps.csv");
  write_steps_csv(steps, report_);
  opened(options_.out + "/summary.json") << summary_json(result, errors);
  std::cout << '\n';
  print_table(std::cout, report_);
  std::cout << '\n';
  print_summary(std::cout, result, errors);
  if (!options_.no_plots) {
    draw("climb");
    if (task_.is_journey) {
      draw("journey");
    }
  }
  std::cout << "\nresults in " << options_.out << std::endl;
  return result;
}

void DemoRun::draw(const std::string & plot) const
{
  const std::string settings =
    "trace='" + options_.out + "/trace.csv'; folder='" + options_.out + "'";
  ChildProcess gnuplot(
    {"gnuplot", "-e", settings, shipped_file("../plots/" + plot + ".gp")},
    options_.out + "/gnuplot.log");
  while (!gnuplot.ended()) {
    std::this_thread::sleep_for(10ms);
  }
  if (gnuplot.ended() != 0) {
    std::cout << "the plots could not be drawn, see " << options_.out << "/gnuplot.log\n";
  }
}

}  // namespace stetro_bringup
