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

#ifndef SUPPORT__TEST_DOMAIN_HPP_
#define SUPPORT__TEST_DOMAIN_HPP_

#include "stetro_dds/context.hpp"

namespace stetro_dds
{

/// A domain id that no other test process on this computer uses, for as long as this one lives.
/** ROS_DOMAIN_ID, if set, decides. */
std::uint32_t test_domain_id();

/// Options for that domain, loopback only.
ContextOptions test_options(bool intra_process = true);

}  // namespace stetro_dds

#endif  // SUPPORT__TEST_DOMAIN_HPP_
