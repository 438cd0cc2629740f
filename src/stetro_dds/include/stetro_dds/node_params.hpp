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

#ifndef STETRO_DDS__NODE_PARAMS_HPP_
#define STETRO_DDS__NODE_PARAMS_HPP_

#include <string>

#include "stetro_config/field.hpp"
#include "stetro_config/loader.hpp"
#include "stetro_dds/context.hpp"

namespace stetro_dds
{

/// Parameters that every node has.
struct NodeParams
{
  bool use_sim_time = false;
  std::string network = "environment";
  std::string ros_distro = "environment";
  bool intra_process = true;
};

template <class Visitor>
void visit(NodeParams & p, Visitor && each)
{
  using stetro_config::Any, stetro_config::OneOf;
  each("use_sim_time", p.use_sim_time, Any{}, "take the time from /clock");
  each(
    "dds.network", p.network, OneOf{"environment", "localhost", "subnet"},
    "who may be talked to; environment: as the ROS_ variables say, else localhost");
  each(
    "dds.ros_distro", p.ros_distro, OneOf{"environment", "humble", "iron", "jazzy"},
    "which ROS 2 shares the domain; environment: ROS_DISTRO, else humble");
  each(
    "dds.intra_process", p.intra_process, Any{},
    "nodes of one process exchange messages without the network");
}

/// A node's own parameters and those that every node has, as one list.
template <class Params>
struct AllParams
{
  Params own{};
  NodeParams common{};
};

template <class Params, class Visitor>
void visit(AllParams<Params> & p, Visitor && each)
{
  visit(p.own, each);
  visit(p.common, each);
}

template <class Params>
auto check(const AllParams<Params> & p, stetro_config::Faults & faults)
  -> decltype(check(p.own, faults))
{
  check(p.own, faults);
}

/// The environment's options, overruled by what the parameters say.
/** \throws stetro_config::ConfigError for a variable that is not understood */
ContextOptions context_options(const NodeParams & params);

}  // namespace stetro_dds

#endif  // STETRO_DDS__NODE_PARAMS_HPP_
