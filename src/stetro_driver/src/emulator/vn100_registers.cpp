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

#include "emulator/vn100_registers.hpp"

#include <algorithm>
#include <array>
#include <cstdio>
#include <optional>
#include <sstream>
#include <vector>

#include "linux/imu/vn100_binary.hpp"
#include "linux/imu/vn100_codes.hpp"

namespace stetro_driver::emulator
{
namespace
{

using linux_io::AsciiChecksum;
using linux_io::AsciiSentence;
using linux_io::whole_of;
namespace error = linux_io::vn100_error;
namespace reg = linux_io::vn100_register;

std::string refusal(unsigned code)
{
  char body[16];
  std::snprintf(body, sizeof(body), "VNERR,%02X", code);
  return body;
}

std::vector<std::string> split(const std::string & fields)
{
  std::vector<std::string> parts;
  std::istringstream stream(fields);
  for (std::string part; std::getline(stream, part, ',');) {
    parts.push_back(part);
  }
  return parts;
}

template <class Accepted = std::initializer_list<unsigned>>
bool is_one_of(const std::string & field, const Accepted & accepted, int base = 10)
{
  const auto value = whole_of(field, base);
  return value && std::find(accepted.begin(), accepted.end(), *value) != accepted.end();
}

/// Whether a register may be told so.
bool accepts(unsigned number, const std::vector<std::string> & fields)
{
  switch (number) {
    case reg::kBaud:
      return is_one_of(
        fields[0], {9600, 19200, 38400, 57600, 115200, 128000, 230400, 460800, 921600});
    case reg::kAsciiType:
      return is_one_of(fields[0], {0, linux_io::kVn100Ymr});
    case reg::kAsciiRate:
      return is_one_of(fields[0], linux_io::kVn100AsciiRates);
    case reg::kProtocol:
      return fields.size() == 7 && is_one_of(fields[4], {1, 3});
    default:  // kBinary
      return fields.size() == 4 && is_one_of(fields[0], {0, 1, 2, 3}) &&
             whole_of(fields[1]).value_or(0) > 0 && is_one_of(fields[2], {1}, 16) &&
             is_one_of(fields[3], {linux_io::kVn100Fields}, 16);
  }
}

}  // namespace

Vn100Registers::Vn100Registers(
  const std::string & model, const std::string & serial_number, std::uint32_t baud)
: registers_{
    {reg::kModel, model},
    {reg::kSerialNumber, serial_number},
    {reg::kBaud, std::to_string(baud)},
    {reg::kAsciiType, "14"},
    {reg::kAsciiRate, "40"},
    {reg::kProtocol, "0,0,0,0,1,0,1"},
    {reg::kBinary, "0,8,01,0131"}}
{
}

std::string Vn100Registers::answer(const std::string & line)
{
  std::string whole = line + "\r\n";
  if (line.size() > 3 && line.substr(line.size() - 3) == "*XX") {  // not to be checked
    whole = linux_io::to_ascii(line.substr(1, line.size() - 4));
  }
  const auto * bytes = reinterpret_cast<const std::uint8_t *>(whole.data());
  const auto scan = linux_io::scan_ascii(bytes, whole.size());
  std::optional<AsciiSentence> command;
  if (scan.verdict == linux_io::FrameVerdict::kFrame) {
    command = linux_io::parse_ascii(bytes, whole.size());
  }
  const AsciiChecksum before = checksum();
  return linux_io::to_ascii(command ? obey(*command) : refusal(error::kWrongChecksum), before);
}

std::string Vn100Registers::obey(const AsciiSentence & command)
{
  if (command.count == 0) {
    return refusal(error::kTooFew);
  }
  const auto number = whole_of(command.fields[0]);
  if (command.type == "ASY") {
    if (!number || *number > 1) {
      return refusal(error::kOutOfRange);
    }
    sending_ = *number == 1;
    return "VNASY," + std::to_string(*number);
  }
  if (command.type != "RRG" && command.type != "WRG") {
    return refusal(error::kUnknownCommand);
  }
  if (!number || registers_.count(*number) == 0) {
    return refusal(error::kUnknownRegister);
  }
  if (command.type == "WRG") {
    const std::string refused = write(*number, command);
    if (!refused.empty()) {
      return refused;
    }
  }
  char head[24];
  std::snprintf(head, sizeof(head), "VN%.3s,%02u,", command.type.data(), *number);
  return head + registers_.at(*number);
}

std::string Vn100Registers::write(unsigned number, const AsciiSentence & command)
{
  if (number == reg::kModel || number == reg::kSerialNumber) {
    return refusal(error::kNotAccessible);
  }
  if (command.count < 2) {
    return refusal(error::kTooFew);
  }
  std::string fields;
  for (std::size_t i = 1; i < command.count; ++i) {
    fields += (i == 1 ? "" : ",") + std::string(command.fields[i]);
  }
  if (!accepts(number, split(fields))) {
    return refusal(error::kOutOfRange);
  }
  registers_[number] = fields;
  return "";
}

unsigned Vn100Registers::field(unsigned number, std::size_t which) const
{
  return whole_of(split(registers_.at(number)).at(which)).value_or(0);
}

double Vn100Registers::ascii_rate_hz() const
{
  return sending_ && field(reg::kAsciiType, 0) == linux_io::kVn100Ymr ? field(reg::kAsciiRate, 0)
                                                                      : 0.0;
}

double Vn100Registers::binary_rate_hz() const
{
  return sending_ && field(reg::kBinary, 0) != 0
           ? static_cast<double>(linux_io::kVn100ImuRate) / field(reg::kBinary, 1)
           : 0.0;
}

std::uint32_t Vn100Registers::baud() const { return field(reg::kBaud, 0); }

AsciiChecksum Vn100Registers::checksum() const
{
  return field(reg::kProtocol, 4) == 3 ? AsciiChecksum::kCrc16 : AsciiChecksum::kXor8;
}

}  // namespace stetro_driver::emulator
