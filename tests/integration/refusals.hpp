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

#ifndef TESTS__INTEGRATION__REFUSALS_HPP_
#define TESTS__INTEGRATION__REFUSALS_HPP_

#include <cstdint>
#include <string>

#include "stetro_msgs/DiagnosticArray.hpp"

namespace stetro_tests
{

/// How many messages of a topic a node says, in /diagnostics, that it refused or found malformed.
/** \return -1 if the array has nothing about that node's topic */
std::int64_t refused_count(
  const diagnostic_msgs::msg::DiagnosticArray & diagnostics, const std::string & node,
  const std::string & topic);

}  // namespace stetro_tests

#endif  // TESTS__INTEGRATION__REFUSALS_HPP_
