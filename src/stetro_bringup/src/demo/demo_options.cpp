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
#include "demo_options.hpp"

#include <cstdlib>
#include <filesystem>
#include <set>
#include <sstream>
#include <stdexcept>
#include <system_error>

#include "installation.hpp"

namespace stetro_bringup
{
namespace
{

// Every string is quoted, so that no file name or fault reads as another YAML type.
std::string quoted(const std::string & text) { return '"' + text + '"'; }

std::string number(double value)
{
  std::ostringstream text;
  text << std::showpoint << value;
  return text.str();
}

// At twenty times real time a sample easily overtakes the /clock message before it by some ticks.
constexpr const char * kFutureTolerance_s = "0.1";

NodeSettings common(const DemoOptions & options, const Task & task)
{
  return {
    {"site_file", quoted(options.site)},
    {"robot_file", quoted(options.robot)},
    {"flight", quoted(task.start)},
    // Whatever the caller's ROS 2 is set to, a demo stays on this computer.
    {"dds.network", quoted("localhost")},
    {"dds.ros_distro", quoted("humble")}};
}

std::string shipped_sites()
{
  std::set<std::string> names;
  std::error_code none;
  for (const auto & file : std::filesystem::directory_iterator(shipped_folder() / "site", none)) {
    names.insert(file.path().stem().string());
  }
  std::string all;
  for (const std::string & name : names) {
    all += (all.empty() ? "" : ", ") + name;
  }
  return all;
}

const stetro_site::Floor * highest_drawn(const stetro_site::Site & site)
{
  const stetro_site::Floor * highest = nullptr;
  for (const stetro_site::Floor & floor : site.floors()) {
    if (floor.is_drawn() && (highest == nullptr || floor.elevation_m() > highest->elevation_m())) {
      highest = &floor;
    }
  }
  return highest;
}

}  // namespace

Task task_of(const DemoOptions & options, const stetro_site::Site & site)
{
  // A busy computer keeps emulated devices waiting, and the mission is held as for a loose plug.
  const bool resumes = options.hardware == "emulated";
  const stetro_site::Floor * floor =
    options.goal.empty() ? highest_drawn(site) : &site.floor(options.goal);
  if (floor != nullptr && options.flight.empty()) {
    return {true, site.flights().front().id(), {floor->id, 0}, std::nullopt, {}, resumes};
  }
  const bool one = options.flight.empty() && site.flights().size() == 1;
  const auto & flight = one ? site.flights().front() : site.flight(options.flight);
  return {false, flight.id(), {flight.id(), flight.steps()}, std::nullopt, {}, resumes};
}

std::string site_file(const std::string & path_or_name)
{
  const auto shipped = shipped_folder() / "site" / (path_or_name + ".yaml");
  for (const std::filesystem::path & file : {std::filesystem::path(path_or_name), shipped}) {
    if (std::filesystem::is_regular_file(file)) {
      return file.string();
    }
  }
  throw std::runtime_error(
    "--site " + path_or_name + ": neither a file nor one of the shipped sites " + shipped_sites());
}

void add_options(CLI::App & app, DemoOptions & options)
{
  app.add_option("--out", options.out, "folder of the results")->capture_default_str();
  app.add_option("--seed", options.seed, "of the world, the sensors and the disturbances")
    ->capture_default_str();
  app
    .add_option(
      "--hardware", options.hardware,
      "the simulated robot, or the real one's driver on emulated devices in the simulated world")
    ->check(CLI::IsMember({"sim", "emulated"}))
    ->capture_default_str();
  app
    .add_option(
      "--seeds", options.seeds,
      "runs, one after the other with a seed more each; results in <out>/seed_<seed>, and their "
      "sum in <out>/series.json")
    ->check(CLI::Range(1, 10000))
    ->capture_default_str();
  app
    .add_option(
      "--speed", options.speed,
      "simulated seconds a second; at most so many where the robot's processes set the pace")
    ->check(CLI::Range(0.1, 1000.0))
    ->default_str("20, emulated 1");
  app.add_option("--estimator", options.estimator, "how the localizer estimates")
    ->check(CLI::IsMember({"fused", "paper"}))
    ->capture_default_str();
  app
    .add_option(
      "--site", options.site,
      "what the software believes: a site file, or a shipped one by name (" + shipped_sites() + ")")
    ->capture_default_str();
  app.add_option("--robot", options.robot, "robot file")
    ->check(CLI::ExistingFile)
    ->default_str("the papers' robot");
  auto * flight = app.add_option("--flight", options.flight, "id of the flight to climb");
  flight->default_str("the only one of the site");
  app.add_option("--goal", options.goal, "id of the floor to go to, from the lowest one")
    ->excludes(flight)
    ->default_str("the highest floor, if the site has drawings of floors");
  app.add_option("--world", options.world, "what is there: the site as built, or exactly the site")
    ->check(CLI::IsMember({"as-built", "site"}))
    ->capture_default_str();
  app.add_option("--calibration", options.calibration, "of the range sensors")
    ->check(CLI::IsMember({"factory", "none"}))
    ->capture_default_str();
  app
    .add_option(
      "--faults", options.faults,
      "to inject, see stetro_driver --help; 'kidnap' alone: one on each floor of the way")
    ->delimiter(',');
  app.add_flag(
    "--in-process", options.in_process, "one process; the same seed gives the same bytes");
  app.add_flag(
    "--no-ground-truth", options.no_ground_truth, "the simulator keeps the truth to itself");
  app.add_flag("--no-plots", options.no_plots, "draw nothing");
  app.add_option("--time-limit", options.time_limit_s, "wall time to give up after [s]")
    ->check(CLI::PositiveNumber)
    ->default_str("600, emulated 3600");
}

void settle(DemoOptions & options)
{
  if (options.emulated() && options.in_process) {
    throw std::runtime_error(
      "--in-process repeats a run tick by tick, accepted: --hardware sim; emulated devices keep "
      "time");
  }
  if (options.speed == 0.0) {
    options.speed = options.emulated() ? 1.0 : 20.0;
  }
  if (options.time_limit_s == 0.0) {
    options.time_limit_s = options.emulated() ? 3600.0 : 600.0;
  }
}

std::string fault_list(const DemoOptions & options)
{
  std::string all;
  for (const std::string & fault : options.faults) {
    all += (all.empty() ? "" : ",") + fault;
  }
  return all;
}

NodeSettings driver_settings(const DemoOptions & options, const Task & task)
{
  NodeSettings settings = common(options, task);
  settings.insert(
    settings.end(), {{"hardware", quoted(options.hardware)},
                     {"sim.seed", std::to_string(options.seed)},
                     {"sim.world", quoted(options.world)},
                     {"sim.errors.calibration", quoted(options.calibration)},
                     {"sim.faults", quoted(fault_list(options))},
                     {"sim.ground_truth", options.no_ground_truth ? "false" : "true"},
                     {"sim.speed", number(options.speed)}});
  if (const auto & at = task.start_pose) {
    settings.emplace_back(
      "sim.start",
      '[' + number(at->x_m) + ", " + number(at->y_m) + ", " + number(at->yaw_rad) + ']');
  }
  return settings;
}

NodeSettings localizer_settings(const DemoOptions & options, const Task & task)
{
  NodeSettings settings = common(options, task);
  settings.insert(
    settings.end(), {{"estimator", quoted(options.estimator)},
                     {"use_sim_time", "true"},
                     {"future_tolerance_s", kFutureTolerance_s},
                     {"state_file", quoted(options.out + "/localizer.state")}});
  return settings;
}

NodeSettings supervisor_settings(const DemoOptions & options, const Task & task)
{
  NodeSettings settings = common(options, task);
  settings.insert(
    settings.end(), {{"use_sim_time", "true"},
                     {"future_tolerance_s", kFutureTolerance_s},
                     {"state_file", quoted(options.out + "/supervisor.state")}});
  return settings;
}

void start_afresh(const DemoOptions & options)
{
  std::filesystem::create_directories(options.out);
  for (const char * state : {"localizer.state", "supervisor.state"}) {
    std::filesystem::remove(options.out + '/' + state);
  }
}

}  // namespace stetro_bringup
