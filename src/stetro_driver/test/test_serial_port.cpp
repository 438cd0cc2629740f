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
#include <sys/stat.h>
#include <unistd.h>

#include <array>
#include <chrono>
#include <string>
#include <vector>

#include "device_bench.hpp"
#include "emulator/pty.hpp"
#include "linux/serial_port.hpp"
#include "pty_name.hpp"

namespace stetro_driver::linux_io
{
namespace
{

using emulator::Pty;
using namespace std::chrono_literals;
using Bytes = std::vector<std::uint8_t>;

constexpr Time kSoon = 2s;  // a limit that nothing here needs

// Everything up to `count` bytes, or what came in time.
Bytes read_bytes(SerialPort & port, std::size_t count)
{
  Bytes bytes;
  std::array<std::uint8_t, 512> chunk{};
  while (bytes.size() < count) {
    const auto got = port.read(chunk.data(), chunk.size(), kSoon);
    if (!got || got.value() == 0) {
      break;
    }
    bytes.insert(
      bytes.end(), chunk.begin(), chunk.begin() + static_cast<std::ptrdiff_t>(got.value()));
  }
  return bytes;
}

Bytes all_values()
{
  Bytes bytes;
  for (int value = 0; value < 256; ++value) {
    bytes.push_back(static_cast<std::uint8_t>(value));
  }
  return bytes;
}

TEST(SerialPort, PassesEveryByteBothWaysUnchanged)
{
  Pty pty{test::pty_name("every")};
  SerialPort port{"bus", {pty.link(), 115'200}};
  const Bytes sent = all_values();
  pty.write(sent.data(), sent.size());
  EXPECT_EQ(read_bytes(port, sent.size()), sent);

  ASSERT_FALSE(port.write(sent.data(), sent.size(), kSoon));
  std::array<std::uint8_t, 512> chunk{};
  Bytes received;
  const auto deadline = std::chrono::steady_clock::now() + kSoon;
  while (received.size() < sent.size() && std::chrono::steady_clock::now() < deadline) {
    const std::size_t count = pty.read(chunk.data(), chunk.size());
    received.insert(
      received.end(), chunk.begin(), chunk.begin() + static_cast<std::ptrdiff_t>(count));
  }
  EXPECT_EQ(received, sent);
}

TEST(SerialPort, SetsSpeedsThatAreNoStandardOnes)
{
  Pty pty{test::pty_name("speed")};
  for (const std::int64_t baud : {57'600, 115'200, 200'000, 666'666, 1'000'000}) {
    const SerialPort port{"bus", {pty.link(), baud}};
    EXPECT_EQ(pty.baud(), baud);
  }
}

TEST(SerialPort, WaitsAsLongAsToldAndSaysThatNothingCame)
{
  Pty pty{test::pty_name("wait")};
  SerialPort port{"bus", {pty.link(), 115'200}};
  std::uint8_t byte = 0;
  const auto before = std::chrono::steady_clock::now();
  const auto got = port.read(&byte, 1, 20ms);
  EXPECT_GE(std::chrono::steady_clock::now() - before, 20ms);
  ASSERT_TRUE(got);
  EXPECT_EQ(got.value(), 0U);
}

TEST(SerialPort, IsNobodyElsesUntilItIsClosed)
{
  Pty pty{test::pty_name("mine")};
  for (int i = 0; i < 2; ++i) {
    const SerialPort port{"bus", {pty.link(), 115'200}};
    EXPECT_THROW((SerialPort{"other", {pty.link(), 115'200}}), HardwareError);
  }
}

TEST(SerialPort, ReportsThatItWasUnpluggedAndIsMadeAgain)
{
  Pty pty{test::pty_name("unplug")};
  for (int i = 0; i < 2; ++i) {
    SerialPort port{"servo bus", {pty.link(), 115'200}};
    pty.unplug();
    std::uint8_t byte = 0x55;
    const auto got = port.read(&byte, 1, kSoon);
    ASSERT_FALSE(got);
    EXPECT_EQ(got.fault().kind, IoFaultKind::kSilent);
    EXPECT_EQ(got.fault().detail, "servo bus: unplugged");
    const auto fault = port.write(&byte, 1, kSoon);
    ASSERT_TRUE(fault);
    EXPECT_EQ(fault->kind, IoFaultKind::kSilent);
    pty.plug();
  }
}

TEST(SerialPort, NamesDeviceAndPathOfWhatItCannotUse)
{
  const auto message = [](const std::string & path) -> std::string {
    try {
      const SerialPort port{"servo bus", {path, 115'200}};
    } catch (const HardwareError & error) {
      return error.what();
    }
    return "opened";
  };
  EXPECT_EQ(
    message("/nowhere/tty"),
    "servo bus: cannot open '/nowhere/tty': No such file or directory; accepted: the path of a "
    "serial device this user may open");
  EXPECT_EQ(message("/dev/null"), "servo bus: '/dev/null' is not a serial device");
}

TEST(SerialPort, LeavesNoFileOpen)
{
  Pty pty{test::pty_name("files")};
  const OpenResources before;
  for (int i = 0; i < 3; ++i) {
    const SerialPort port{"bus", {pty.link(), 115'200}};
    EXPECT_THROW((SerialPort{"other", {pty.link(), 115'200}}), HardwareError);
    EXPECT_THROW((SerialPort{"bus", {"/dev/null", 115'200}}), HardwareError);
  }
  EXPECT_TRUE(OpenResources{} == before);
}

TEST(SerialPort, ForgetsWhatWasReceived)
{
  Pty pty{test::pty_name("drop")};
  SerialPort port{"bus", {pty.link(), 115'200}};
  const Bytes sent = all_values();
  pty.write(sent.data(), sent.size());
  ASSERT_EQ(read_bytes(port, 1).size(), sent.size());
  pty.write(sent.data(), sent.size());
  port.drop_input();
  std::uint8_t byte = 0;
  const auto got = port.read(&byte, 1, 1ms);
  ASSERT_TRUE(got);
  EXPECT_EQ(got.value(), 0U);
}

}  // namespace
}  // namespace stetro_driver::linux_io
