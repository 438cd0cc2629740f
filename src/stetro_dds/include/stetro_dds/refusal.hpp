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

#ifndef STETRO_DDS__REFUSAL_HPP_
#define STETRO_DDS__REFUSAL_HPP_

#include <string>

namespace stetro_dds
{

/// Why something was not done: a message not used, a transition not taken, a time not believed.
struct Refusal
{
  std::string reason;    ///< short and from a small fixed set: it is the name of a counter
  std::string detail{};  ///< the value that offended and what would be accepted, for the log
};

}  // namespace stetro_dds

#endif  // STETRO_DDS__REFUSAL_HPP_
