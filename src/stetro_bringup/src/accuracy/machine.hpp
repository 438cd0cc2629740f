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

#ifndef ACCURACY__MACHINE_HPP_
#define ACCURACY__MACHINE_HPP_

#include <iosfwd>
#include <string>

namespace stetro_bringup
{

/// What a report was made on.
struct Machine
{
  unsigned cores = 0;  ///< 0: not known
  std::string cpu;     ///< empty: not known
};

[[nodiscard]] Machine this_machine();

/// The processor's name in the words of /proc/cpuinfo; empty if it does not say.
[[nodiscard]] std::string cpu_model(std::istream & cpuinfo);

}  // namespace stetro_bringup

#endif  // ACCURACY__MACHINE_HPP_
