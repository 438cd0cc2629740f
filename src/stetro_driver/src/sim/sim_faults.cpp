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

#include "stetro_driver/sim_faults.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <sstream>
#include <stdexcept>

#include "stetro_driver/sensor_frame.hpp"

namespace stetro_driver
{
namespace
{

/// Which devices a kind of fault can strike.
enum class Strikes {
  kNobody,
  kRanges,
  kRangesAndGyro,
  kGyro,
  kAnyDevice,
  kFloors,
};

struct Entry
{
  std::string_view name;
  SimFaultKind kind;
  Strikes strikes;
  bool has_value;
  double value;
  double least;
  double most;
  std::string_view meaning;
};

constexpr std::array<Entry, 14> kEntries{{
  {"dead", SimFaultKind::kDead, Strikes::kAnyDevice, false, 0, 0, 0, "does not answer"},
  {"stuck", SimFaultKind::kStuck, Strikes::kAnyDevice, false, 0, 0, 0, "repeats its last answer"},
  {"spike", SimFaultKind::kSpike, Strikes::kRangesAndGyro, true, 0.2, 0, 1,
   "this share of its readings is far off"},
  {"late", SimFaultKind::kLate, Strikes::kRanges, true, 0.2, 0, 0.6,
   "its readings arrive so many seconds late"},
  {"offset_jump", SimFaultKind::kOffsetJump, Strikes::kRanges, true, 0.05, -0.5, 0.5,
   "its readings are so many metres too long"},
  {"gain_change", SimFaultKind::kGainChange, Strikes::kRanges, true, 0.1, -0.5, 0.5,
   "its readings are too long by this share"},
  {"drift", SimFaultKind::kDrift, Strikes::kRanges, true, 0.002, -0.05, 0.05,
   "its readings grow by so many metres a second"},
  {"bias_jump", SimFaultKind::kBiasJump, Strikes::kGyro, true, 0.02, -0.5, 0.5,
   "its rate is so many rad/s too high"},
  {"slip", SimFaultKind::kSlip, Strikes::kNobody, true, 0.02, -0.3, 0.3,
   "the body slips so many metres along its next motion"},
  {"missed_touchdown", SimFaultKind::kMissedTouchdown, Strikes::kNobody, false, 0, 0, 0,
   "the next touch-down shows neither lower lock nor load"},
  {"double_touchdown", SimFaultKind::kDoubleTouchdown, Strikes::kNobody, false, 0, 0, 0,
   "the next touch-down of block 2 shows twice"},
  {"old_tread", SimFaultKind::kOldTread, Strikes::kNobody, false, 0, 0, 0,
   "block 2 comes down on the tread it left, and block3_front says otherwise"},
  {"kidnap", SimFaultKind::kKidnap, Strikes::kFloors, true, 0.3, -2, 2,
   "the robot is carried so many metres to the left; on a floor anywhere else on it. With a floor: "
   "only there, and the seconds are those that it has driven there"},
  {"estop", SimFaultKind::kEmergencyStop, Strikes::kNobody, false, 0, 0, 0,
   "the emergency stop is pressed until the end of the fault"},
}};

[[noreturn]] void refuse(const std::string & item, const std::string & why)
{
  throw std::invalid_argument("fault '" + item + "': " + why + "\n" + sim_faults_help());
}

std::string trimmed(std::string_view text)
{
  const auto first = text.find_first_not_of(" \t\n");
  if (first == std::string_view::npos) {
    return {};
  }
  return std::string(text.substr(first, text.find_last_not_of(" \t\n") - first + 1));
}

double number(const std::string & text, const std::string & item)
{
  std::size_t read = 0;
  double value = 0.0;
  try {
    value = std::stod(text, &read);
  } catch (const std::exception &) {
    read = 0;
  }
  if (read == 0 || read != text.size() || !std::isfinite(value)) {
    refuse(item, "'" + text + "' is not a number");
  }
  return value;
}

template <class Names>
bool holds(const Names & names, const std::string & name)
{
  return std::find(names.begin(), names.end(), name) != names.end();
}

bool strikes(Strikes strikes, const std::string & device)
{
  const bool range = holds(kRangeNames, device);
  switch (strikes) {
    case Strikes::kNobody:
      return device.empty();
    case Strikes::kRanges:
      return range;
    case Strikes::kRangesAndGyro:
      return range || device == "gyro";
    case Strikes::kGyro:
      return device == "gyro";
    case Strikes::kAnyDevice:
      return range || device == "gyro" ||
             (holds(kContactNames, device) && device != "emergency_stop");
    case Strikes::kFloors:
      return true;  // the site knows which there are
  }
  return false;
}

/// Cuts `text` at the first `mark` and returns what stood behind it; nothing without a mark.
std::optional<std::string> cut(std::string & text, char mark, std::size_t from = 0)
{
  const auto at = text.find(mark, from);
  if (at == std::string::npos) {
    return std::nullopt;
  }
  std::string behind = trimmed(std::string_view(text).substr(at + 1));
  text = trimmed(std::string_view(text).substr(0, at));
  return behind;
}

SimFault parse_one(const std::string & item)
{
  std::string head = item;
  const auto value = cut(head, '=');
  auto when = cut(head, '@');
  const auto device = cut(head, ':');
  const auto entry =
    std::find_if(kEntries.begin(), kEntries.end(), [&](const Entry & e) { return e.name == head; });
  if (entry == kEntries.end()) {
    refuse(item, "unknown kind '" + head + "'");
  }
  SimFault fault;
  fault.kind = entry->kind;
  fault.device = device.value_or("");
  if (!strikes(entry->strikes, fault.device)) {
    refuse(item, "'" + fault.device + "' is no device that it can strike");
  }
  if (!when) {
    refuse(item, "no time given, '@seconds' is missing");
  }
  if (const auto until = cut(*when, '-', 1)) {
    fault.until_s = number(*until, item);
  }
  fault.from_s = number(*when, item);
  if (fault.from_s < 0.0 || fault.until_s <= fault.from_s) {
    refuse(item, "times run from 0 upwards");
  }
  if (value && !entry->has_value) {
    refuse(item, "takes no value");
  }
  fault.value = value ? number(*value, item) : entry->value;
  if (fault.value < entry->least || fault.value > entry->most) {
    std::ostringstream why;
    why << "value " << fault.value << ", accepted: " << entry->least << " to " << entry->most;
    refuse(item, why.str());
  }
  return fault;
}

}  // namespace

std::vector<SimFault> parse_sim_faults(std::string_view text)
{
  std::vector<SimFault> faults;
  std::string rest = trimmed(text);
  while (!rest.empty()) {
    const auto behind = cut(rest, ',');
    faults.push_back(parse_one(rest));
    rest = behind.value_or("");
  }
  return faults;
}

std::string sim_faults_help()
{
  std::ostringstream out;
  out << "faults: kind[:device]@from[-until][=value], separated by commas; times in seconds since "
         "the start\n";
  for (const Entry & entry : kEntries) {
    std::string form{entry.name};
    form += entry.strikes == Strikes::kNobody   ? "@from"
            : entry.strikes == Strikes::kFloors ? "[:floor]@from"
                                                : ":device@from";
    out << "  " << form << std::string(form.size() < 24 ? 24 - form.size() : 1, ' ')
        << entry.meaning;
    if (entry.has_value) {
      out << " (" << entry.least << " to " << entry.most << ", default " << entry.value << ")";
    }
    out << "\n";
  }
  out << "devices: gyro";
  for (const auto name : kRangeNames) {
    out << ", " << name;
  }
  for (const auto name : kContactNames) {
    if (name != "emergency_stop") {
      out << ", " << name;
    }
  }
  out << " (spike: ranges and gyro; bias_jump: gyro; late, offset_jump, "
         "gain_change, drift: ranges)\n";
  return out.str();
}

}  // namespace stetro_driver
