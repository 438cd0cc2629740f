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
#ifndef DEMO__DEMO_OPTIONS_HPP_
#define DEMO__DEMO_OPTIONS_HPP_

#include <cstdint>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "CLI/CLI.hpp"
#include "stetro_bringup/summary.hpp"
#include "stetro_site/pose.hpp"
#include "stetro_site/site.hpp"

namespace stetro_bringup
{

/// What `stetro_demo` was asked to do.
struct DemoOptions
{
  std::string out = "out/demo";  ///< folder of the results
  std::uint64_t seed = 1;        ///< of the world, the sensors and the disturbances
  std::int64_t seeds = 1;        ///< runs one after the other, each with the next seed
  std::string hardware = "sim";  ///< or `emulated`: the real robot's driver on emulated devices
  double speed = 0.0;            ///< simulated seconds a second at most; zero: 20, emulated 1
  std::string estimator = "fused";
  std::string site = "papers_staircase";  ///< what the software believes: a file, or one shipped
  std::string robot;                      ///< empty: the papers' robot
  std::string flight;                     ///< id of the flight to clean; empty: the only one
  std::string goal;                     ///< id of the floor to go to; empty: the highest drawn one
  std::string world = "as-built";       ///< what is there: as-built or site
  std::string calibration = "factory";  ///< of the range sensors: factory or none
  std::vector<std::string> faults;      ///< to inject, by name
  bool in_process = false;              ///< one process on simulated time: a repeatable run
  bool no_ground_truth = false;         ///< the simulator keeps the truth to itself
  bool no_plots = false;
  double time_limit_s = 0.0;  ///< wall time to give up after; zero: 600 s, emulated an hour

  [[nodiscard]] bool emulated() const { return hardware == "emulated"; }
};

/// Fills in what depends on the hardware. \throws std::runtime_error for what cannot go together
void settle(DemoOptions & options);

/// Declares the options on the command line, read into `options`, which must outlive it.
void add_options(CLI::App & app, DemoOptions & options);

/// What is asked of the robot, and where it ends.
struct Task
{
  bool is_journey = false;  ///< through the building to a floor; else one flight is cleaned
  std::string start;        ///< flight in whose frame the robot starts
  Goal goal;
  std::optional<stetro_site::Pose> start_pose;  ///< in that frame; nothing: at the flight's foot
  std::vector<std::string> kidnaps_on;          ///< floors on which one is to happen
  bool resumes = false;                         ///< when the mission is held
};

/// The flight that was chosen, or the floor; of a building with drawn floors the highest of these.
/** \throws std::out_of_range naming what was chosen and what there is */
[[nodiscard]] Task task_of(const DemoOptions & options, const stetro_site::Site & site);

/// Parameters of one node, as the command line of ROS 2 takes them: name and YAML text.
using NodeSettings = std::vector<std::pair<std::string, std::string>>;

/// The faults to inject, as the driver takes them.
[[nodiscard]] std::string fault_list(const DemoOptions & options);

[[nodiscard]] NodeSettings driver_settings(const DemoOptions & options, const Task & task);
[[nodiscard]] NodeSettings localizer_settings(const DemoOptions & options, const Task & task);
[[nodiscard]] NodeSettings supervisor_settings(const DemoOptions & options, const Task & task);

/// The file that `--site` means: a path, or the name of a shipped site.
/** \throws std::runtime_error if it is neither, naming the shipped ones */
[[nodiscard]] std::string site_file(const std::string & path_or_name);

/// Makes the folder of the results and removes what an earlier climb left of its state.
void start_afresh(const DemoOptions & options);

}  // namespace stetro_bringup

#endif  // DEMO__DEMO_OPTIONS_HPP_
