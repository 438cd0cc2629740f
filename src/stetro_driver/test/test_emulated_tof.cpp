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
#include <cerrno>
#include <chrono>
#include <string>
#include <thread>

#include "device_bench.hpp"
#include "emulator/emulated_tof.hpp"

namespace stetro_driver::emulator
{
namespace
{

using std::chrono::milliseconds;

/// What a read gave: the text, or the errno.
struct Answer
{
  std::string text;
  int error = 0;
  Time took{0};
};

Answer read_from(EmulatedTof & tof)
{
  const linux_io::DeviceClock clock;
  std::array<char, 64> text{};
  const Time begun = clock.now();
  const ssize_t size = tof.read(text.data(), text.size());
  Answer answer;
  answer.took = clock.now() - begun;
  if (size < 0) {
    answer.error = static_cast<int>(-size);
  } else {
    answer.text.assign(text.data(), static_cast<std::size_t>(size));
  }
  return answer;
}

TEST(EmulatedTof, AReadIsAMeasurementAndBlocksAsLong)
{
  EmulatedTof tof{linux_io::DeviceClock{}};
  EXPECT_EQ(read_from(tof).text, "8190\n") << "nothing within reach";
  tof.see(217);
  const Answer answer = read_from(tof);
  EXPECT_EQ(answer.text, "217\n");
  EXPECT_GE(answer.took, milliseconds{32});
  EXPECT_EQ(tof.reads(), 2u);
  EXPECT_EQ(tof.overlaps(), 0u);
}

TEST(EmulatedTof, FailsAsTheKernelDoes)
{
  EmulatedTof tof{linux_io::DeviceClock{}};
  tof.set_trouble(TofTrouble::kSilent);
  const Answer silent = read_from(tof);
  EXPECT_EQ(silent.error, ETIMEDOUT);
  EXPECT_GE(silent.took, milliseconds{99});
  tof.set_trouble(TofTrouble::kNoReply);
  EXPECT_EQ(read_from(tof).error, EREMOTEIO);
  tof.set_trouble(TofTrouble::kBadBus);
  EXPECT_EQ(read_from(tof).error, EIO);
  tof.set_trouble(TofTrouble::kSlow);
  EXPECT_GE(read_from(tof).took, milliseconds{89});
  tof.set_trouble(TofTrouble::kNone);
  EXPECT_EQ(read_from(tof).text, "8190\n");
  tof.set_bound(false);
  EXPECT_EQ(read_from(tof).error, ENODEV);
}

TEST(EmulatedTof, GarbageIsNeverADistance)
{
  EmulatedTof tof{linux_io::DeviceClock{Time::zero(), 100.0}};
  tof.see(217);
  tof.set_trouble(TofTrouble::kGarbled);
  for (int i = 0; i < 14; ++i) {
    EXPECT_NE(read_from(tof).text, "217\n") << i;
  }
}

TEST(EmulatedTof, WiresThatComeOffEndAMeasurement)
{
  EmulatedTof tof{linux_io::DeviceClock{}};
  tof.set_trouble(TofTrouble::kSlow);
  Answer answer;
  std::thread reader{[&] { answer = read_from(tof); }};
  const bool begun = eventually([&] { return tof.reads() == 1; });
  tof.set_trouble(TofTrouble::kNoReply);
  reader.join();
  EXPECT_TRUE(begun);
  EXPECT_EQ(answer.error, EREMOTEIO);
}

TEST(EmulatedTof, CountsReadersThatDisturbEachOther)
{
  EmulatedTof tof{linux_io::DeviceClock{}};
  tof.set_trouble(TofTrouble::kSilent);
  std::thread first{[&] { static_cast<void>(read_from(tof)); }};
  const bool begun = eventually([&] { return tof.reads() == 1; });
  static_cast<void>(read_from(tof));
  first.join();
  EXPECT_TRUE(begun);
  EXPECT_EQ(tof.overlaps(), 1u);
}

}  // namespace
}  // namespace stetro_driver::emulator
