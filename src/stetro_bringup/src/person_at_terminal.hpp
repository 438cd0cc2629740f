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

#ifndef PERSON_AT_TERMINAL_HPP_
#define PERSON_AT_TERMINAL_HPP_

#include <unistd.h>

#include <iostream>
#include <string>

#include "stetro_dds/context.hpp"
#include "stetro_dds/executor.hpp"
#include "stetro_dds/launch.hpp"

// What programs share by which a person asks the robot for something and is told what came of it.

namespace stetro_bringup
{

constexpr int kDone = 0;
constexpr int kRefused = 1;
constexpr int kNoAnswer = 3;

// Such a node has nothing to set but what every node has.
struct PersonParams
{
};

template <class Visitor>
void visit(PersonParams &, Visitor &&)
{
}

/// \param whom a kind of node \return the exit status
inline int no_answer(const std::string & whom, double patience_s)
{
  std::cerr << "no " << whom << " has answered within " << patience_s
            << " s; is it on this ROS_DOMAIN_ID, and this node on its time (use_sim_time)?\n";
  return kNoAnswer;
}

/// Does something with a node of one's own, as several people may be at terminals at once.
/**
 * \tparam Person made of a context and node options; gives its node()
 * \param act int(Person &, Executor &)
 * \return what it returns: the exit status
 */
template <class Person, class Act>
int with_person(stetro_dds::Launch & launch, const std::string & name, Act && act)
{
  const auto configured =
    launch.configure<PersonParams>(name + "_" + std::to_string(getpid()), "/stetro");
  stetro_dds::Context context(launch.context_options());
  Person person(context, configured.options);
  stetro_dds::Executor executor;
  executor.add(person.node());
  return act(person, executor);
}

}  // namespace stetro_bringup

#endif  // PERSON_AT_TERMINAL_HPP_
