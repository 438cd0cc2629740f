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

#include <CLI/CLI.hpp>

#include "stetro_dds/executor.hpp"
#include "stetro_dds/launch.hpp"
#include "stetro_driver/driver_node.hpp"
#include "stetro_driver/sim_faults.hpp"

int main(int argc, char ** argv)
{
  using stetro_driver::DriverParams;
  const stetro_dds::Program program{
    "stetro_driver", "The sensors and actuators of a sTetro robot, simulated.",
    [](CLI::App & app) { app.footer("sim.faults:\n" + stetro_driver::sim_faults_help()); }};
  return stetro_dds::run_main(argc, argv, program, [](stetro_dds::Launch & launch) {
    const auto configured = launch.configure<DriverParams>("driver", "/stetro");
    const auto setup = stetro_driver::read_setup(configured.params, launch.faults());
    launch.check();
    stetro_dds::Context context(launch.context_options());
    stetro_driver::DriverNode driver(context, configured.options, setup.value());
    stetro_dds::Executor executor;
    executor.add(driver.node());
    driver.start();
    driver.run(executor, [&launch] { return launch.stop_requested(); });
    return 0;
  });
}
