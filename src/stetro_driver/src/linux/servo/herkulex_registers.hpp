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

#ifndef LINUX__SERVO__HERKULEX_REGISTERS_HPP_
#define LINUX__SERVO__HERKULEX_REGISTERS_HPP_

#include <cmath>
#include <cstdint>
#include <string>

#include "stetro_driver/time.hpp"

namespace stetro_driver::linux_io
{

/// Addresses in the RAM of a HerkuleX DRS-0101 or 0201.
namespace ram
{
constexpr std::uint8_t kId = 0;
constexpr std::uint8_t kAckPolicy = 1;
constexpr std::uint8_t kTorquePolicy = 3;
constexpr std::uint8_t kAccelerationRatio = 8;
constexpr std::uint8_t kStatusError = 48;
constexpr std::uint8_t kStatusDetail = 49;
constexpr std::uint8_t kTorqueControl = 52;
constexpr std::uint8_t kLed = 53;
constexpr std::uint8_t kVoltage = 54;
constexpr std::uint8_t kTemperature = 55;
constexpr std::uint8_t kControlMode = 56;
constexpr std::uint8_t kTick = 57;
constexpr std::uint8_t kPosition = 58;      // calibrated; a word
constexpr std::uint8_t kDifferential = 62;  // a word
constexpr std::uint8_t kPwm = 64;           // a word
constexpr std::size_t kSize = 74;
constexpr std::uint8_t kEepOffset = 6;  // the same register in EEP, up to kLastCopied
constexpr std::uint8_t kLastCopied = 47;
}  // namespace ram

/// Bits of the status error. They latch until they are cleared.
enum ServoError : std::uint8_t {
  kVoltageError = 0x01,
  kPositionLimitError = 0x02,
  kTemperatureError = 0x04,
  kPacketError = 0x08,
  kOverloadError = 0x10,
  kDriverError = 0x20,
  kEepError = 0x40,
};

/// Bits of the status detail.
enum ServoDetail : std::uint8_t {
  kMovingDetail = 0x01,
  kInPositionDetail = 0x02,
  kChecksumDetail = 0x04,
  kUnknownCommandDetail = 0x08,
  kRegisterRangeDetail = 0x10,
  kGarbageDetail = 0x20,
  kMotorOnDetail = 0x40,
};

/// Values of the torque control register.
enum class Torque : std::uint8_t { kFree = 0x00, kBrake = 0x40, kOn = 0x60 };

/// Values of the control mode register.
enum class ServoMode : std::uint8_t { kPosition = 0, kVelocity = 1 };

/// Bits of SET in a jog.
enum JogSet : std::uint8_t { kJogStop = 0x01, kJogVelocity = 0x02, kJogInvalid = 0x20 };

/// Names of the bits that are set, "overload, voltage".
[[nodiscard]] inline std::string describe_errors(std::uint8_t errors)
{
  constexpr const char * kNames[] = {"voltage",  "position limit", "temperature",  "invalid packet",
                                     "overload", "driver fault",   "EEP distorted"};
  std::string text;
  for (int bit = 0; bit < 7; ++bit) {
    if ((errors & (1 << bit)) != 0) {
      text += (text.empty() ? "" : ", ") + std::string(kNames[bit]);
    }
  }
  return text;
}

constexpr double kRadPerDegree = 0.01745329251994329577;
constexpr double kRadPerCount = 0.325 * kRadPerDegree;  // of position; 0101 and 0201
constexpr int kCentreCount = 512;
constexpr int kLowestCount = 0x15;  // factory limits of position
constexpr int kHighestCount = 0x3EA;
constexpr std::uint16_t kPositionMask = 0x03FF;  // real servos set bits above
constexpr int kFullPwm = 1023;
constexpr std::uint16_t kBackwards = 0x4000;  // sign of the speed in a jog
constexpr double kVoltPerCount = 0.074;
constexpr Time kServoTick{11'200'000};  // of playtimes and trajectories

[[nodiscard]] inline double position_rad(std::uint16_t word)
{
  return kRadPerCount * ((word & kPositionMask) - kCentreCount);
}

/// Nearest count, which the factory limits may refuse.
[[nodiscard]] inline int position_count(double rad)
{
  return static_cast<int>(std::lround(rad / kRadPerCount)) + kCentreCount;
}

}  // namespace stetro_driver::linux_io

#endif  // LINUX__SERVO__HERKULEX_REGISTERS_HPP_
