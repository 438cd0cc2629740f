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

#include "emulator/vn100_registers.hpp"

namespace stetro_driver::emulator
{
namespace
{

Vn100Registers factory() { return {"VN-100T-CR", "0100012345", 115'200}; }

std::string body_of(const std::string & sentence)
{
  return sentence.substr(1, sentence.find('*') - 1);
}

std::string told(Vn100Registers & registers, const std::string & body)
{
  return body_of(registers.answer("$" + body + "*XX"));
}

TEST(Vn100Registers, AnswersAsTheManualShows)
{
  Vn100Registers registers = factory();
  EXPECT_EQ(body_of(registers.answer("$VNRRG,5*46")), "VNRRG,05,115200");
  EXPECT_EQ(registers.answer("$VNWRG,06,0*6C"), "$VNWRG,06,0*6C\r\n");
  EXPECT_EQ(registers.answer("$VNRRG,30*XX"), "$VNRRG,30,0,0,0,0,1,0,1*6C\r\n");
  EXPECT_EQ(told(registers, "VNRRG,01"), "VNRRG,01,VN-100T-CR");
}

TEST(Vn100Registers, SendsWhatItIsTold)
{
  Vn100Registers registers = factory();
  EXPECT_EQ(registers.ascii_rate_hz(), 40.0) << "as the factory left it";
  EXPECT_EQ(registers.binary_rate_hz(), 0.0);
  EXPECT_EQ(told(registers, "VNWRG,75,3,8,01,0131"), "VNWRG,75,3,8,01,0131");
  EXPECT_EQ(registers.binary_rate_hz(), 100.0) << "800 / 8";
  EXPECT_EQ(told(registers, "VNASY,0"), "VNASY,0");
  EXPECT_EQ(registers.binary_rate_hz(), 0.0) << "paused";
  told(registers, "VNASY,1");
  EXPECT_EQ(registers.binary_rate_hz(), 100.0);
  told(registers, "VNWRG,06,0");
  EXPECT_EQ(registers.ascii_rate_hz(), 0.0);
  told(registers, "VNWRG,06,14");
  told(registers, "VNWRG,07,200");
  EXPECT_EQ(registers.ascii_rate_hz(), 200.0);
  told(registers, "VNWRG,05,921600");
  EXPECT_EQ(registers.baud(), 921'600u);
}

TEST(Vn100Registers, TheChecksumChangesBehindTheAnswer)
{
  Vn100Registers registers = factory();
  const std::string answer = registers.answer("$VNWRG,30,0,0,0,0,3,0,1*XX");
  EXPECT_EQ(answer.size() - answer.find('*'), 5u) << "two digits";
  const std::string next = registers.answer("$VNRRG,06*XX");
  EXPECT_EQ(next.size() - next.find('*'), 7u) << "four digits";
}

TEST(Vn100Registers, RefusesWithTheErrorsOfTheManual)
{
  Vn100Registers registers = factory();
  EXPECT_EQ(body_of(registers.answer("$VNRRG,5*47")), "VNERR,03") << "checksum";
  EXPECT_EQ(body_of(registers.answer("$VN")), "VNERR,03");
  EXPECT_EQ(told(registers, "VNXYZ,1"), "VNERR,04") << "command";
  EXPECT_EQ(told(registers, "VNRRG"), "VNERR,05") << "too few";
  EXPECT_EQ(told(registers, "VNWRG,07"), "VNERR,05");
  EXPECT_EQ(told(registers, "VNWRG,07,30"), "VNERR,07") << "no such rate";
  EXPECT_EQ(told(registers, "VNWRG,75,3,0,01,0131"), "VNERR,07") << "divided by nothing";
  EXPECT_EQ(told(registers, "VNASY,2"), "VNERR,07");
  EXPECT_EQ(told(registers, "VNRRG,99"), "VNERR,08") << "register";
  EXPECT_EQ(told(registers, "VNWRG,01,VN-200"), "VNERR,09") << "access";
  EXPECT_EQ(registers.ascii_rate_hz(), 40.0) << "nothing has changed";
}

}  // namespace
}  // namespace stetro_driver::emulator
