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

#include <gtest/gtest.h>

#include <sstream>

#include "accuracy/machine.hpp"

namespace stetro_bringup
{
namespace
{

std::string cpu_in(const std::string & cpuinfo)
{
  std::istringstream text(cpuinfo);
  return cpu_model(text);
}

TEST(Machine, NamesItsProcessorOrItsBoard)
{
  EXPECT_EQ(
    cpu_in("processor\t: 0\nmodel\t\t: 85\nmodel name\t: Swift 3000 CPU @ 2.00GHz\nflags\t: fpu\n"),
    "Swift 3000 CPU @ 2.00GHz");
  EXPECT_EQ(
    cpu_in("processor\t: 0\nCPU part\t: 0xd08\n\nModel\t\t: Fruit Board 4 Rev 1.4\n"),
    "Fruit Board 4 Rev 1.4");
  EXPECT_EQ(cpu_in("processor\t: 0\n"), "");
  EXPECT_EQ(cpu_in(""), "");
}

}  // namespace
}  // namespace stetro_bringup
