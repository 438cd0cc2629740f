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

#include <array>
#include <chrono>

#include "emulator/line_pacer.hpp"

namespace stetro_driver::emulator
{
namespace
{

using namespace std::chrono_literals;

constexpr std::array<std::uint8_t, 4> kBytes{1, 2, 3, 4};

TEST(LinePacer, LetsAByteArriveAfterTenBits)
{
  LinePacer line;
  line.send(kBytes.data(), 2, 1s, 100'000);  // 100 us a byte
  std::array<std::uint8_t, 4> to{};
  EXPECT_EQ(line.receive(to.data(), to.size(), 1s + 99us), 0U);
  EXPECT_EQ(line.receive(to.data(), to.size(), 1s + 100us), 1U);
  EXPECT_EQ(to[0], 1);
  EXPECT_EQ(line.all_arrived(), Time{1s + 200us});
  EXPECT_EQ(line.receive(to.data(), to.size(), 1s + 200us), 1U);
  EXPECT_EQ(to[0], 2);
  EXPECT_FALSE(line.all_arrived());
}

TEST(LinePacer, QueuesBehindWhatIsOnTheLine)
{
  LinePacer line;
  line.send(kBytes.data(), 2, 0s, 100'000);
  line.send(kBytes.data() + 2, 2, 50us, 50'000);  // begins at 200 us, 200 us a byte
  EXPECT_EQ(line.all_arrived(), Time{600us});
  std::array<std::uint8_t, 4> to{};
  EXPECT_EQ(line.receive(to.data(), to.size(), 600us), 4U);
  EXPECT_EQ(to, kBytes);
}

TEST(LinePacer, StartsAnewAfterAPause)
{
  LinePacer line;
  line.send(kBytes.data(), 1, 0s, 100'000);
  std::array<std::uint8_t, 1> to{};
  EXPECT_EQ(line.receive(to.data(), 1, 1s), 1U);
  line.send(kBytes.data(), 1, 1s, 100'000);
  EXPECT_EQ(line.all_arrived(), Time{1s + 100us});
}

}  // namespace
}  // namespace stetro_driver::emulator
