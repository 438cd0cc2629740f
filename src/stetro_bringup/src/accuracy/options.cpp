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

#include "accuracy/options.hpp"

namespace stetro_bringup
{
namespace
{

constexpr std::int64_t kLastSeed = 1'000'000'000'000'000'000;  // with a million runs on top

}  // namespace

void add_options(CLI::App & app, AccuracyOptions & options)
{
  app.add_option("--runs", options.runs, "climbs, of each scenario")
    ->check(CLI::Range(1, 1'000'000))
    ->capture_default_str();
  app.add_option("--first-seed", options.first_seed, "the climbs' seeds rise from it by one")
    ->check(CLI::Range(std::int64_t{0}, kLastSeed))  // of a signed type: -3 must not wrap around
    ->capture_default_str();
  app
    .add_option(
      "--estimator", options.estimator,
      "how the localizer estimates; both: fused drives, paper listens")
    ->check(CLI::IsMember({"paper", "fused", "both"}))
    ->capture_default_str();
  app.add_option("--world", options.world, "what is there: the site as built, or exactly the site")
    ->check(CLI::IsMember({"as-built", "site"}))
    ->capture_default_str();
  app.add_option("--calibration", options.calibration, "of the range sensors")
    ->check(CLI::IsMember({"factory", "none"}))
    ->capture_default_str();
  app
    .add_option(
      "--faults", options.faults,
      "scenarios, one after the other, or all: dead, stuck, spike, offset_jump, gain_change, "
      "drifting, late, gyro_bias_jump, no_side_ranges, steps; or what stetro_driver --help knows")
    ->delimiter(',');
  app.add_option("--robot", options.robot, "robot file")
    ->check(CLI::ExistingFile)
    ->default_str("the papers' robot");
  app.add_option("--site", options.site, "site file: what the software believes")
    ->check(CLI::ExistingFile)
    ->default_str("the papers' staircase");
  app.add_option("--flight", options.flight, "id of the flight to climb")
    ->default_str("the only one of the site");
  app.add_option("--localizer", options.localizer, "file of the localizer's parameters")
    ->check(CLI::ExistingFile)
    ->default_str("its defaults");
  app.add_option("--errors", options.errors, "file of the simulator's errors, tof_gain_std: 0.04")
    ->check(CLI::ExistingFile)
    ->default_str("its defaults");
  app.add_option("--out", options.out, "folder of the results")->capture_default_str();
  app.add_option("--jobs", options.jobs, "climbs at a time; 0: as many as cores")
    ->check(CLI::Range(0, 256))
    ->capture_default_str();
  app.add_flag("--no-plots", options.no_plots, "draw nothing");
  app.add_option("--markdown", options.markdown, "write the tables of a report into this file");
  app.add_option("--commit", options.commit, "name of the source's version, for that file");
}

std::vector<std::string> estimators_of(const AccuracyOptions & options)
{
  if (options.estimator == "both") {
    return {"fused", "paper"};
  }
  return {options.estimator};
}

std::string command_of(const AccuracyOptions & options)
{
  std::string command = "scripts/accuracy --runs " + std::to_string(options.runs) +
                        " --first-seed " + std::to_string(options.first_seed) + " --estimator " +
                        options.estimator + " --world " + options.world + " --calibration " +
                        options.calibration;
  const auto add = [&](const std::string & name, const std::string & value) {
    command += value.empty() ? "" : " --" + name + ' ' + value;
  };
  std::string faults;
  for (const std::string & name : options.faults) {
    faults += (faults.empty() ? "" : ",") + name;
  }
  add("faults", faults);
  add("robot", options.robot);
  add("site", options.site);
  add("flight", options.flight);
  add("localizer", options.localizer);
  add("errors", options.errors);
  return command;
}

}  // namespace stetro_bringup
