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
#include <fcntl.h>
#include <spdlog/spdlog.h>
#include <sys/file.h>
#include <unistd.h>

#include <cstdlib>
#include <filesystem>
#include <iostream>
#include <memory>
#include <stdexcept>
#include <vector>

#include "child_process.hpp"
#include "demo_options.hpp"
#include "demo_run.hpp"
#include "installation.hpp"
#include "journey_files.hpp"
#include "journey_plan.hpp"
#include "stetro_bringup/robot.hpp"
#include "stetro_bringup/series_report.hpp"
#include "stetro_site/fit.hpp"

namespace stetro_bringup
{
namespace
{

using std::chrono_literals::operator""ms;

struct Component
{
  std::string node;
  NodeSettings settings;
};

std::vector<Component> components(const DemoOptions & options, const Task & task)
{
  return {
    {"driver", driver_settings(options, task)},
    {"localizer", localizer_settings(options, task)},
    {"supervisor", supervisor_settings(options, task)}};
}

ClimbOutcome run_in_process(
  const DemoOptions & options, const Task & task, const stetro_site::Deployment & deployment,
  const stetro_dds::Launch & interruptible)
{
  stetro_dds::RosArguments arguments;
  spdlog::set_level(spdlog::level::err);  // the progress line is told enough
  for (const Component & component : components(options, task)) {
    for (const auto & [name, value] : component.settings) {
      arguments.overrides.push_back({component.node, name, value});
    }
  }
  stetro_dds::Launch launch(arguments);
  const auto configuration = configure_robot(launch);
  stetro_dds::Context context(launch.context_options());
  Robot robot(context, configuration);
  DemoRun run(context, options, task, deployment);
  robot.add(run.node());
  while (run.goes_on()) {
    if (interruptible.stop_requested()) {
      run.give_up("interrupted");
      continue;
    }
    robot.step();
  }
  robot.tell_diagnostics();  // now: the second of the wall is no tick of the robot
  return run.report();
}

std::unique_ptr<ChildProcess> started(const Component & component, const DemoOptions & options)
{
  std::vector<std::string> command{
    shipped_program("stetro_" + component.node), "--ros-args", "--log-level", "info"};
  for (const auto & [name, value] : component.settings) {
    command.insert(command.end(), {"-p", name + ":=" + value});
  }
  return std::make_unique<ChildProcess>(command, options.out + '/' + component.node + ".log");
}

ClimbOutcome run_over_dds(
  const DemoOptions & options, const Task & task, const stetro_site::Deployment & deployment,
  const stetro_dds::Launch & launch)
{
  std::vector<std::unique_ptr<ChildProcess>> processes;
  for (const Component & component : components(options, task)) {
    processes.push_back(started(component, options));
  }
  stetro_dds::Context context(launch.context_options());
  DemoRun run(context, options, task, deployment);
  stetro_dds::Executor executor;
  executor.add(run.node());
  while (run.goes_on()) {
    executor.spin_some(50ms);
    if (launch.stop_requested()) {
      run.give_up("interrupted");
    }
    for (const auto & process : processes) {
      if (const auto status = process->ended()) {
        run.give_up(
          process->name() + " ended with status " + std::to_string(*status) + ", see its log in " +
          options.out);
      }
    }
  }
  while (run.awaits_staircase()) {
    executor.spin_some(50ms);
  }
  return run.report();
}

// A domain of the demo's own on this computer: a robot that lives on the caller's domain is not to
// be commanded by a demo. Held by a lock, so that two demos do not meet either.
void take_domain()
{
  constexpr int kFirst = 10;
  constexpr int kCount = 90;
  for (int i = 0; i < kCount; ++i) {
    const int domain = kFirst + (getpid() + i) % kCount;
    const std::string lock = "/tmp/stetro_demo_domain_" + std::to_string(domain) + ".lock";
    const int file = open(lock.c_str(), O_RDWR | O_CREAT | O_CLOEXEC, 0666);
    if (file >= 0 && flock(file, LOCK_EX | LOCK_NB) == 0) {
      setenv("ROS_DOMAIN_ID", std::to_string(domain).c_str(), 1);
      for (const char * name :
           {"ROS_LOCALHOST_ONLY", "ROS_AUTOMATIC_DISCOVERY_RANGE", "ROS_STATIC_PEERS",
            "ROS_DISTRO"}) {
        unsetenv(name);
      }
      return;  // the lock ends with the process
    }
    if (file >= 0) {
      close(file);
    }
  }
  throw std::runtime_error("every domain from 10 to 99 is taken by another demo");
}

std::string introduction(const Task & task, const stetro_site::Site & site)
{
  if (task.is_journey) {
    return "going from floor '" + site.flight(task.start).spec().lower_floor + "' to floor '" +
           task.goal.segment + "' of " + site.name();
  }
  return "climbing " + std::to_string(task.goal.step) + " steps of '" + task.goal.segment + "'";
}

ClimbOutcome run_once(
  DemoOptions options, const stetro_site::Deployment & deployment,
  const stetro_dds::Launch & launch)
{
  Task task = task_of(options, deployment.site);
  if (task.is_journey) {
    const JourneyPlan plan = plan_journey(deployment, task.start, task.goal.segment, options.seed);
    task.start_pose = plan.start;
    options.faults = with_kidnaps_on_floors(options.faults, plan.floors, options.seed);
    task.kidnaps_on = floors_of_kidnaps(options.faults);
  }
  start_afresh(options);
  std::cout << introduction(task, deployment.site) << ", seed " << options.seed
            << (options.in_process
                  ? ", in one process"
                  : std::string(", three processes on ROS_DOMAIN_ID=") + getenv("ROS_DOMAIN_ID"))
            << std::endl;
  if (!options.faults.empty()) {
    std::cout << "faults: " << fault_list(options) << std::endl;
  }
  return options.in_process ? run_in_process(options, task, deployment, launch)
                            : run_over_dds(options, task, deployment, launch);
}

// Each with results of its own; the sum is kept up to date, for a series takes its time.
int run_series(
  const DemoOptions & options, const stetro_site::Deployment & deployment,
  const stetro_dds::Launch & launch)
{
  SeriesReport series;
  std::filesystem::create_directories(options.out);
  for (std::int64_t i = 0; i < options.seeds && !launch.stop_requested(); ++i) {
    DemoOptions one = options;
    one.seed += static_cast<std::uint64_t>(i);
    one.out += "/seed_" + std::to_string(one.seed);
    series.add(run_once(one, deployment, launch));
    opened(options.out + "/series.json") << series.json();
    std::cout << std::endl;
  }
  series.print(std::cout);
  std::cout << "\nresults in " << options.out << std::endl;
  return series.succeeded() ? 0 : 1;
}

int demonstrate(DemoOptions options, const stetro_dds::Launch & launch)
{
  settle(options);
  options.site = site_file(options.site);
  if (options.robot.empty()) {
    options.robot = shipped_file("robot/stetro.yaml");
  }
  const auto deployment = stetro_site::load_deployment(options.site, options.robot);
  if (options.seeds > 1) {
    return run_series(options, deployment, launch);
  }
  return run_once(options, deployment, launch).shortfalls.empty() ? 0 : 1;
}

}  // namespace
}  // namespace stetro_bringup

int main(int argc, char ** argv)
{
  stetro_bringup::take_domain();
  stetro_bringup::DemoOptions options;
  return stetro_dds::run_main(
    argc, argv,
    {"stetro_demo",
     "Lets the simulated robot climb a staircase, or go from floor to floor, and reports how it "
     "went.",
     [&options](CLI::App & app) { stetro_bringup::add_options(app, options); }},
    [&options](stetro_dds::Launch & launch) {
      return stetro_bringup::demonstrate(options, launch);
    });
}
