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

#include <chrono>
#include <iostream>

#include "CLI/CLI.hpp"
#include "stetro_dds/executor.hpp"
#include "stetro_dds/launch.hpp"
#include "stetro_driver/commissioning.hpp"
#include "stetro_driver/driver_node.hpp"
#include "stetro_driver/sim_faults.hpp"

namespace
{

struct Options
{
  bool check = false;
  bool skip_signs = false;
  bool yes = false;
};

/// Checks what the robot file lists, prints a table, and moves nothing. \return the exit status
int check(const stetro_driver::DriverSetup & setup, const Options & options)
{
  const auto hardware = stetro_driver::make_hardware(setup);
  if (hardware.stepped != nullptr) {
    std::cerr << "--check: hardware '" << setup.params.hardware
              << "' has no devices, accepted: linux, emulated\n";
    return 2;
  }
  const auto clock = [world = hardware.world]() -> stetro_driver::Time {
    return world != nullptr ? world->time() : std::chrono::system_clock::now().time_since_epoch();
  };
  stetro_driver::TerminalAssistant person{options.yes ? nullptr : &std::cin, std::cout};
  const auto rows =
    stetro_driver::Commissioning{*hardware.robot, clock, options.skip_signs ? nullptr : &person}
      .run();
  stetro_driver::print_check(std::cout, rows);
  return stetro_driver::all_well(rows) ? 0 : 1;
}

}  // namespace

int main(int argc, char ** argv)
{
  using stetro_driver::DriverParams;
  Options options;
  const stetro_dds::Program program{
    "stetro_driver", "The sensors and actuators of a sTetro robot: real, emulated or simulated.",
    [&options](CLI::App & app) {
      auto * check = app.add_flag(
        "--check", options.check,
        "find and read each device, verify signs, print a table; moves nothing");
      app.add_flag("--skip-signs", options.skip_signs, "without a hand, a push or a turn")
        ->needs(check);
      app.add_flag("--yes", options.yes, "do not wait for Enter before each of these")
        ->needs(check);
      app.footer("sim.faults:\n" + stetro_driver::sim_faults_help());
    }};
  return stetro_dds::run_main(argc, argv, program, [&options](stetro_dds::Launch & launch) {
    const auto configured = launch.configure<DriverParams>("driver", "/stetro");
    const auto setup = stetro_driver::read_setup(configured.params, launch.faults());
    launch.check();
    if (options.check) {
      return check(setup.value(), options);
    }
    stetro_dds::Context context(launch.context_options());
    stetro_driver::DriverNode driver(context, configured.options, setup.value());
    stetro_dds::Executor executor;
    executor.add(driver.node());
    driver.start();
    driver.run(executor, [&launch] { return launch.stop_requested(); });
    return 0;
  });
}
