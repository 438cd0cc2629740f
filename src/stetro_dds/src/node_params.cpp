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

#include "stetro_dds/node_params.hpp"

namespace stetro_dds
{

ContextOptions context_options(const NodeParams & params)
{
  ContextOptions options = ContextOptions::from_environment();
  if (params.network == "localhost") {
    options.scope = NetworkScope::kLocalhost;
    options.static_peers.clear();
  } else if (params.network == "subnet") {
    options.scope = NetworkScope::kSubnet;
  }
  if (params.ros_distro == "humble") {
    options.distro = RosDistro::kHumble;
  } else if (params.ros_distro == "iron") {
    options.distro = RosDistro::kIron;
  } else if (params.ros_distro == "jazzy") {
    options.distro = RosDistro::kJazzy;
  }
  options.intra_process = params.intra_process;
  return options;
}

}  // namespace stetro_dds
