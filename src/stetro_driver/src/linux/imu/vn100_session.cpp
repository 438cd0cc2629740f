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

#include "linux/imu/vn100_session.hpp"

#include <algorithm>
#include <cstdio>

#include "linux/imu/vn100_codes.hpp"

namespace stetro_driver::linux_io
{
namespace
{

constexpr char kDevice[] = "VN-100";
// As the maker's library: a command is sent again after 200 ms.
constexpr int kTries = 3;
constexpr Time kAnswerTime = std::chrono::milliseconds{200};
constexpr Time kWriteTime = std::chrono::milliseconds{100};

const char * words_of_error(unsigned code)
{
  switch (code) {
    case vn100_error::kHardFault:
      return "hard fault";
    case vn100_error::kSerialOverflow:
      return "serial buffer overflow";
    case vn100_error::kUnknownCommand:
      return "unknown command";
    case vn100_error::kTooFew:
      return "too few parameters";
    case vn100_error::kTooMany:
      return "too many parameters";
    case vn100_error::kOutOfRange:
      return "parameter out of range";
    case vn100_error::kUnknownRegister:
      return "unknown register";
    case vn100_error::kNotAccessible:
      return "register may not be accessed";
    case vn100_error::kWatchdogReset:
      return "reset by its watchdog";
    case vn100_error::kOutputOverflow:
      return "output buffer overflow";
    case vn100_error::kBaudTooLow:
      return "baud too low for the output";
    default:
      return "unknown error";
  }
}

std::string two_digits(unsigned number)
{
  char text[12];
  std::snprintf(text, sizeof(text), "%02u", number);
  return text;
}

std::string joined(const AsciiSentence & sentence, std::size_t first)
{
  std::string fields;
  for (std::size_t i = first; i < sentence.count; ++i) {
    fields += (i == first ? "" : ",") + std::string(sentence.fields[i]);
  }
  return fields;
}

/// The same lists of numbers: the sensor may print them with other leading zeros.
bool same_fields(const std::string & a, const std::string & b)
{
  std::string_view rest_a = a;
  std::string_view rest_b = b;
  while (!rest_a.empty() && !rest_b.empty()) {
    const std::string_view field_a = rest_a.substr(0, rest_a.find(','));
    const std::string_view field_b = rest_b.substr(0, rest_b.find(','));
    const auto value = whole_of(field_a, 16);
    if (!value || value != whole_of(field_b, 16)) {
      return false;
    }
    rest_a.remove_prefix(std::min(rest_a.size(), field_a.size() + 1));
    rest_b.remove_prefix(std::min(rest_b.size(), field_b.size() + 1));
  }
  return rest_a.empty();  // more fields, such as the port, may follow in b
}

}  // namespace

Vn100Session::Vn100Session(
  const Vn100Config & config, const DeviceClock & clock, const std::atomic<bool> & stop)
: config_(config), clock_(clock), stop_(stop), port_(kDevice, config.serial)
{
}

IoFault Vn100Session::bad_answer(const std::string & what) const
{
  return {IoFaultKind::kBadAnswer, std::string(kDevice) + ": " + what};
}

std::optional<IoFault> Vn100Session::listen(Time patience, const Sink & sink)
{
  const Result<std::size_t> count = port_.read(bytes_.data(), bytes_.size(), clock_.real(patience));
  const Time now = clock_.now();
  if (!count) {
    return count.fault();
  }
  stream_.feed(bytes_.data(), count.value(), [&](const Vn100Frame & frame, std::size_t age) {
    sink(frame, now - vn100_wire_time(config_, age));
  });
  return std::nullopt;
}

Result<std::string> Vn100Session::ask(
  const std::string & command, unsigned number, const std::string & fields)
{
  const std::string body =
    "VN" + command + "," + two_digits(number) + (fields.empty() ? "" : "," + fields);
  const std::string sentence = to_ascii(body);
  const std::uint64_t lost_before = stream_.counts().lost_bytes;
  std::optional<Result<std::string>> answer;
  const auto look = [&](const Vn100Frame & frame, Time) {
    const auto * heard = std::get_if<AsciiSentence>(&frame);
    if (answer || !heard || heard->count == 0) {
      return;
    }
    if (heard->type == "ERR") {
      const unsigned code = whole_of(heard->fields[0], 16).value_or(0);
      if (code == vn100_error::kWrongChecksum) {
        return;  // hurt on its way there: it is sent again
      }
      answer = bad_answer("refuses " + body + ": " + words_of_error(code));
    } else if (heard->type == command && whole_of(heard->fields[0]) == number) {
      answer = joined(*heard, 1);
    }
  };
  for (int attempt = 0; attempt < kTries && !stop_; ++attempt) {
    const auto * bytes = reinterpret_cast<const std::uint8_t *>(sentence.data());
    if (auto fault = port_.write(bytes, sentence.size(), clock_.real(kWriteTime))) {
      return *fault;
    }
    const Time until = clock_.now() + kAnswerTime;
    for (Time now = clock_.now(); now < until && !stop_; now = clock_.now()) {
      if (auto fault = listen(until - now, look)) {
        return *fault;
      }
      if (answer) {
        return *answer;
      }
    }
  }
  if (stream_.counts().lost_bytes > lost_before) {
    return bad_answer("garbled, no answer to " + body + ": wrong baud, or not a VN-100?");
  }
  return IoFault{IoFaultKind::kSilent, std::string(kDevice) + ": no answer to " + body};
}

Result<Vn100Identity> Vn100Session::identify()
{
  const auto model = ask("RRG", vn100_register::kModel, "");
  if (!model) {
    return model.fault();
  }
  const auto serial_number = ask("RRG", vn100_register::kSerialNumber, "");
  if (!serial_number) {
    return serial_number.fault();
  }
  return Vn100Identity{model.value(), serial_number.value()};
}

std::optional<IoFault> Vn100Session::write_register(unsigned number, const std::string & fields)
{
  const auto echo = ask("WRG", number, fields);
  if (!echo) {
    return echo.fault();
  }
  if (!same_fields(fields, echo.value())) {
    return bad_answer(
      "register " + two_digits(number) + " was told " + fields + " and says " + echo.value());
  }
  return std::nullopt;
}

std::optional<IoFault> Vn100Session::configure()
{
  char fields[8];
  std::snprintf(fields, sizeof(fields), "%04X", unsigned{kVn100Fields});
  const std::string divisor = std::to_string(kVn100ImuRate / config_.rate_hz);
  const bool binary = config_.output == "binary";
  // 3 sends on both of its ports, so that it does not matter which of them is wired.
  const std::string packets = (binary ? "3," : "0,") + divisor + ",01," + fields;
  if (auto fault = write_register(vn100_register::kAsciiType, "0")) {
    return fault;
  }
  if (auto fault = write_register(vn100_register::kBinary, packets)) {
    return fault;
  }
  if (binary) {
    return std::nullopt;
  }
  if (auto fault = write_register(vn100_register::kAsciiRate, std::to_string(config_.rate_hz))) {
    return fault;
  }
  return write_register(vn100_register::kAsciiType, std::to_string(kVn100Ymr));
}

}  // namespace stetro_driver::linux_io
