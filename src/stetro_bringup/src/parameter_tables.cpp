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
// Prints docs/parameters.md: every parameter of every node, from the lists that also load them.

#include <iostream>

#include "stetro_config/report.hpp"
#include "stetro_dds/node_params.hpp"
#include "stetro_driver/params.hpp"
#include "stetro_localizer/params.hpp"
#include "stetro_supervisor/supervisor_params.hpp"

namespace
{

template <class Params>
void print(const char * title, const char * about)
{
  std::cout << "\n## " << title << "\n\n"
            << about << "\n\n"
            << stetro_config::reference_table<Params>();
}

}  // namespace

int main()
{
  std::cout
    << "# Parameters\n\n"
       "Written by `stetro_parameter_tables`; a test holds this page to the code. Files have the\n"
       "layout of ROS 2 (`/stetro/driver:`, below it `ros__parameters:`), the command line is\n"
       "`--ros-args --params-file FILE -p name:=value`. An unknown name, a wrong type, a value\n"
       "that is not accepted or a node given twice in one file ends the program with exit code 2\n"
       "and a list of every fault. A section for a node of another program is a warning in the "
       "log.\n";
  print<stetro_dds::NodeParams>("Every node", "How a component talks and which time it follows.");
  print<stetro_driver::DriverParams>("Driver", "Node `/stetro/driver`.");
  print<stetro_localizer::LocalizerParams>("Localizer", "Node `/stetro/localizer`.");
  print<stetro_supervisor::SupervisorParams>("Supervisor", "Node `/stetro/supervisor`.");
  return 0;
}
