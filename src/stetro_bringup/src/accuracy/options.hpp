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

#ifndef ACCURACY__OPTIONS_HPP_
#define ACCURACY__OPTIONS_HPP_

#include <cstdint>
#include <string>
#include <vector>

#include "CLI/CLI.hpp"

namespace stetro_bringup
{

/// What `stetro_accuracy` was asked to do.
struct AccuracyOptions
{
  std::uint64_t runs = 50;              ///< climbs, of each scenario
  std::uint64_t first_seed = 1;         ///< the climbs' seeds rise from it by one
  std::string estimator = "fused";      ///< a name, or "both"
  std::string world = "as-built";       ///< what is there: as-built or site
  std::string calibration = "factory";  ///< of the range sensors: factory or none
  std::vector<std::string> faults;      ///< scenarios, or "all"; none: fault-free
  std::string robot;                    ///< empty: the papers' robot
  std::string site;                  ///< what the software believes; empty: the papers' staircase
  std::string flight;                ///< id; empty: the only one of the site
  std::string localizer;             ///< file of its parameters; empty: its defaults
  std::string errors;                ///< file of the simulator's errors; empty: its defaults
  std::string out = "out/accuracy";  ///< folder of the results
  unsigned jobs = 0;                 ///< threads; 0: as many as cores
  bool no_plots = false;
  std::string markdown;  ///< file for the tables of a report; empty: none
  std::string commit;    ///< of the source, for that file
};

/// Declares the options on the command line, read into `options`, which must outlive it.
void add_options(CLI::App & app, AccuracyOptions & options);

/// The estimators by name; the first drives the robot, the others listen.
[[nodiscard]] std::vector<std::string> estimators_of(const AccuracyOptions & options);

/// The command line that gives the same figures again.
/** Without what changes none of them: folders, threads, the picture. */
[[nodiscard]] std::string command_of(const AccuracyOptions & options);

}  // namespace stetro_bringup

#endif  // ACCURACY__OPTIONS_HPP_
