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
#include "stetro_dds/launch.hpp"
#include "stetro_supervisor/supervisor_node.hpp"

int main(int argc, char ** argv)
{
  using stetro_supervisor::SupervisorNode;
  using stetro_supervisor::SupervisorParams;
  return stetro_dds::run_main(
    argc, argv,
    {"stetro_supervisor", "Drives the climb: sweeps a flight of stairs from its foot to its top."},
    [](stetro_dds::Launch & launch) {
      const auto supervisor = launch.configure<SupervisorParams>("supervisor", "/stetro");
      const auto setup = stetro_supervisor::read_setup(supervisor.params, launch.faults());
      launch.check();
      stetro_dds::Context context(launch.context_options());
      SupervisorNode node(context, supervisor.options, setup.value());
      stetro_dds::Executor executor;
      executor.add(node.node());
      launch.spin(executor);
      node.hold();
      return 0;
    });
}
