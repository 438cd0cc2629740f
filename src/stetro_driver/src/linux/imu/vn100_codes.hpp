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

#ifndef LINUX__IMU__VN100_CODES_HPP_
#define LINUX__IMU__VN100_CODES_HPP_

#include <array>
#include <cstdint>

namespace stetro_driver::linux_io
{

/// Registers of the VN-100, UM001: what the driver asks for and the emulator has.
namespace vn100_register
{
constexpr unsigned kModel = 1;
constexpr unsigned kSerialNumber = 3;
constexpr unsigned kBaud = 5;
constexpr unsigned kAsciiType = 6;
constexpr unsigned kAsciiRate = 7;
constexpr unsigned kProtocol = 30;  ///< its fifth field: which checksum
constexpr unsigned kBinary = 75;    ///< the first of three binary outputs
}  // namespace vn100_register

/// Codes of a refusal, `$VNERR`.
namespace vn100_error
{
constexpr unsigned kHardFault = 1;
constexpr unsigned kSerialOverflow = 2;
constexpr unsigned kWrongChecksum = 3;
constexpr unsigned kUnknownCommand = 4;
constexpr unsigned kTooFew = 5;
constexpr unsigned kTooMany = 6;
constexpr unsigned kOutOfRange = 7;
constexpr unsigned kUnknownRegister = 8;
constexpr unsigned kNotAccessible = 9;
constexpr unsigned kWatchdogReset = 10;
constexpr unsigned kOutputOverflow = 11;
constexpr unsigned kBaudTooLow = 12;
}  // namespace vn100_error

constexpr unsigned kVn100Ymr = 14;           ///< ASCII output: yaw, pitch, roll and three vectors
constexpr std::int64_t kVn100ImuRate = 800;  ///< binary output divides it [Hz]
/// What ASCII output may be set to [Hz].
constexpr std::array<std::int64_t, 11> kVn100AsciiRates{1, 2, 4, 5, 10, 20, 25, 40, 50, 100, 200};

}  // namespace stetro_driver::linux_io

#endif  // LINUX__IMU__VN100_CODES_HPP_
