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
#include "stetro_bringup/robot.hpp"

int main(int argc, char ** argv)
{
  return stetro_dds::run_main(
    argc, argv,
    {"stetro_robot", "The whole robot in one process: driver, localizer and supervisor."},
    [](stetro_dds::Launch & launch) {
      const auto configuration = stetro_bringup::configure_robot(launch);
      stetro_dds::Context context(launch.context_options());
      stetro_bringup::Robot robot(context, configuration);
      robot.run([&launch] { return launch.stop_requested(); });
      return 0;
    });
}
