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
#include "climb_run.hpp"
#include "demo_options.hpp"
#include "stetro_bringup/robot.hpp"
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

std::vector<Component> components(const DemoOptions & options)
{
  return {
    {"driver", driver_settings(options)},
    {"localizer", localizer_settings(options)},
    {"supervisor", supervisor_settings(options)}};
}

int climb_in_process(
  const DemoOptions & options, const ReportFacts & facts, int step_count,
  const stetro_dds::Launch & interruptible)
{
  stetro_dds::RosArguments arguments;
  spdlog::set_level(spdlog::level::err);  // the progress line is told enough
  for (const Component & component : components(options)) {
    for (const auto & [name, value] : component.settings) {
      arguments.overrides.push_back({component.node, name, value});
    }
  }
  stetro_dds::Launch launch(arguments);
  const auto configuration = configure_robot(launch);
  stetro_dds::Context context(launch.context_options());
  Robot robot(context, configuration);
  ClimbRun run(context, options, facts, step_count);
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

int climb_over_dds(
  const DemoOptions & options, const ReportFacts & facts, int step_count,
  const stetro_dds::Launch & launch)
{
  std::vector<std::unique_ptr<ChildProcess>> processes;
  for (const Component & component : components(options)) {
    processes.push_back(started(component, options));
  }
  stetro_dds::Context context(launch.context_options());
  ClimbRun run(context, options, facts, step_count);
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

// The only flight of the site, or the one that was named.
const stetro_site::Flight & chosen(const stetro_site::Site & site, const std::string & id)
{
  if (!id.empty() || site.flights().size() != 1) {
    return site.flight(id);  // throws, naming those there are
  }
  return site.flights().front();
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

int climb(DemoOptions options, const stetro_dds::Launch & launch)
{
  if (options.site.empty()) {
    options.site = shipped_file("site/papers_staircase.yaml");
  }
  if (options.robot.empty()) {
    options.robot = shipped_file("robot/stetro.yaml");
  }
  const auto deployment = stetro_site::load_deployment(options.site, options.robot);
  const auto & flight = chosen(deployment.site, options.flight);
  options.flight = flight.id();
  const ReportFacts facts{flight.width_m(0.0), deployment.robot.geometry.contact_width_m};
  start_afresh(options);
  std::cout << "climbing " << flight.steps() << " steps of '" << options.flight << "', seed "
            << options.seed
            << (options.in_process
                  ? ", in one process"
                  : std::string(", three processes on ROS_DOMAIN_ID=") + getenv("ROS_DOMAIN_ID"))
            << std::endl;
  return options.in_process ? climb_in_process(options, facts, flight.steps(), launch)
                            : climb_over_dds(options, facts, flight.steps(), launch);
}

}  // namespace
}  // namespace stetro_bringup

int main(int argc, char ** argv)
{
  stetro_bringup::take_domain();
  stetro_bringup::DemoOptions options;
  return stetro_dds::run_main(
    argc, argv,
    {"stetro_demo", "Lets the simulated robot climb a staircase and reports how it went.",
     [&options](CLI::App & app) { stetro_bringup::add_options(app, options); }},
    [&options](stetro_dds::Launch & launch) { return stetro_bringup::climb(options, launch); });
}
