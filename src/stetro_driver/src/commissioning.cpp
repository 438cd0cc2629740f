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

#include "stetro_driver/commissioning.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <iomanip>
#include <istream>
#include <map>
#include <ostream>
#include <thread>
#include <utility>

namespace stetro_driver
{
namespace
{

constexpr Time kSettling = std::chrono::milliseconds{500};
constexpr Time kPatience = std::chrono::seconds{20};
constexpr Time kLook = std::chrono::milliseconds{5};
constexpr double kNear = 0.5;            // a hand brings a range down to this share, or less
constexpr double kHandReach_m = 0.3;     // where nothing was, a hand is nearer than this
constexpr double kEnoughTurn_rad = 0.1;  // 6 degrees

std::string range_text(const RangeReading & reading)
{
  if (std::isinf(reading.range_m)) {
    return reading.range_m > 0.0 ? "nothing within reach" : "too near";
  }
  char text[32];
  std::snprintf(text, sizeof(text), "%.3f m", reading.range_m);
  return text;
}

/// Whether something has come before a sensor.
bool came_near(const RangeReading & before, const RangeReading & now)
{
  if (now.status == RangeStatus::kFault || now.status == RangeStatus::kStale) {
    return false;
  }
  if (before.status == RangeStatus::kTooNear) {
    return false;  // nearer than that cannot be told
  }
  if (now.status == RangeStatus::kTooNear) {
    return true;
  }
  return std::isfinite(before.range_m) ? now.range_m < kNear * before.range_m
                                       : now.range_m < kHandReach_m;
}

std::string name_of(RangePlace place)
{
  return std::string(kRangeNames[static_cast<std::size_t>(place)]);
}
std::string name_of(ContactPlace place)
{
  return std::string(kContactNames[static_cast<std::size_t>(place)]);
}

/// What to look at first, by kind of device.
std::string advice_for(const std::string & device)
{
  static const std::map<std::string, std::string> kAdvice{
    {"contacts", "chip and line numbers in devices.contacts, group gpio, other users of the line"},
    {"servos", "power and cable of the servos, devices.chassis.bus path and baud, each id"},
    {"range sensors", "run the address helper, compare devices.range_sensors with /sys/bus/iio"},
    {"imu", "power and cable of the VN-100, devices.imu path and baud, group dialout"}};
  const auto found = kAdvice.find(device);
  return found == kAdvice.end() ? "its cable and its entry under devices: in the robot file"
                                : found->second;
}

}  // namespace

bool TerminalAssistant::ask(const std::string & item, const std::string & request)
{
  out_ << item << ": " << request;
  if (in_ == nullptr) {
    out_ << std::endl;
    return true;
  }
  out_ << "  [Enter, then do it; s: skip] " << std::flush;
  std::string answer;
  return std::getline(*in_, answer) && answer != "s";
}

void TerminalAssistant::thank(const std::string & item)
{
  out_ << item << ": thank you" << std::endl;
}

Commissioning::Commissioning(
  HardwareInterface & robot, std::function<Time()> clock, Assistant * person)
: robot_(robot), clock_(std::move(clock)), person_(person)
{
}

std::vector<CheckRow> Commissioning::run()
{
  rows_.clear();
  if (find()) {
    read_once();
    check_hands();
    check_pushes();
    check_turn();
  }
  return rows_;
}

void Commissioning::add(
  std::string item, CheckOutcome outcome, std::string found, std::string advice)
{
  rows_.push_back({std::move(item), outcome, std::move(found), std::move(advice)});
}

bool Commissioning::find()
{
  bool found = true;
  try {
    robot_.configure();
  } catch (const HardwareError & error) {
    found = false;
    if (robot_.devices().empty()) {
      add("robot", CheckOutcome::kFailed, error.what());
    }
  }
  for (const DeviceStatus & device : robot_.devices()) {
    if (device.fault) {
      add(device.name, CheckOutcome::kFailed, device.fault->detail, advice_for(device.name));
    } else {
      std::string figures;
      for (const auto & [name, value] : device.figures) {
        if (name == "voltage" || name == "temperature") {
          figures += ", " + name + " " + value;
        }
      }
      add(device.name, CheckOutcome::kPassed, "found" + figures);
    }
  }
  if (!found) {
    add("readings and signs", CheckOutcome::kSkipped, "not every device was found");
  }
  return found;
}

SensorFrame Commissioning::read()
{
  auto frame = robot_.read(clock_());
  return frame.ok() ? frame.value() : SensorFrame{};
}

std::string Commissioning::watch(const std::function<std::string(const SensorFrame &)> & seen)
{
  const auto begin = std::chrono::steady_clock::now();
  while (std::chrono::steady_clock::now() - begin < kPatience) {
    std::string said = seen(read());
    if (!said.empty()) {
      return said;
    }
    std::this_thread::sleep_for(kLook);
  }
  return "";
}

void Commissioning::read_once()
{
  const Time begun = clock_();
  SensorFrame frame = read();
  while (clock_() - begun < kSettling) {
    std::this_thread::sleep_for(kLook);
    frame = read();
  }
  for (std::size_t i = 0; i < kRangePlaces; ++i) {
    const RangeReading & reading = frame.ranges[i];
    const std::string item = "reads " + std::string(kRangeNames[i]);
    if (reading.status == RangeStatus::kFault && reading.stamp <= Time::zero()) {
      add(item, CheckOutcome::kSkipped, "not fitted");
    } else if (reading.status == RangeStatus::kFault || reading.status == RangeStatus::kStale) {
      add(item, CheckOutcome::kFailed, "no measurement", advice_for("range sensors"));
    } else {
      add(item, CheckOutcome::kPassed, range_text(reading));
    }
  }
  for (std::size_t i = 0; i < kContactPlaces; ++i) {
    const ContactReading & contact = frame.contacts[i];
    const std::string item = "reads " + std::string(kContactNames[i]);
    if (contact.fault) {
      add(
        item, CheckOutcome::kFailed, "closed since the start, loose, or not fitted",
        "its `active` level and its wire: nothing may press it now");
    } else {
      add(item, CheckOutcome::kPassed, contact.closed ? "closed" : "open");
    }
  }
  const double rate = frame.gyro.rate_rad_s[2];
  const bool still = !frame.gyro.fault && std::abs(rate) < 0.05;
  char text[48];
  std::snprintf(text, sizeof(text), "%.4f rad/s about z", rate);
  add(
    "reads imu", still ? CheckOutcome::kPassed : CheckOutcome::kFailed, text,
    still ? "" : "the robot must stand still, devices.imu.rate_hz and its mounting");
}

void Commissioning::check_hands()
{
  for (std::size_t i = 0; i < kRangePlaces; ++i) {
    check_hand(static_cast<RangePlace>(i));
  }
}

void Commissioning::check_hand(RangePlace place)
{
  const std::string item = "hand before " + name_of(place);
  const SensorFrame before = read();
  if (before.range(place).status == RangeStatus::kTooNear) {
    add(item, CheckOutcome::kSkipped, "something is close before it already");
    return;
  }
  if (
    person_ == nullptr || before.range(place).stamp <= Time::zero() ||
    !person_->ask(item, "hold a hand close before this sensor")) {
    add(item, CheckOutcome::kSkipped, "");
    return;
  }
  const std::string answered = watch([&](const SensorFrame & frame) -> std::string {
    if (came_near(before.range(place), frame.range(place))) {
      return name_of(place);
    }
    for (std::size_t i = 0; i < kRangePlaces; ++i) {
      if (came_near(before.ranges[i], frame.ranges[i])) {
        return std::string(kRangeNames[i]);
      }
    }
    return "";
  });
  const bool well = answered == name_of(place);
  add(
    item, well ? CheckOutcome::kPassed : CheckOutcome::kFailed,
    well ? range_text(read().range(place))
         : (answered.empty() ? "nothing came near" : answered + " saw it"),
    well ? "" : "the addresses in devices.range_sensors: which sensor is which");
  person_->thank(item);
  static_cast<void>(watch([&](const SensorFrame & frame) -> std::string {
    const auto away = [&](std::size_t i) { return !came_near(before.ranges[i], frame.ranges[i]); };
    bool all_away = true;
    for (std::size_t i = 0; i < kRangePlaces; ++i) {
      all_away = all_away && away(i);
    }
    return all_away ? "away" : "";
  }));
}

void Commissioning::check_pushes()
{
  for (std::size_t i = 0; i < kContactPlaces; ++i) {
    check_push(static_cast<ContactPlace>(i));
  }
}

void Commissioning::check_push(ContactPlace place)
{
  const std::string item = "push of " + name_of(place);
  const SensorFrame before = read();
  if (person_ == nullptr || !person_->ask(item, "press it and keep it pressed")) {
    add(item, CheckOutcome::kSkipped, "");
    return;
  }
  const std::string answered = watch([&](const SensorFrame & frame) -> std::string {
    for (std::size_t i = 0; i < kContactPlaces; ++i) {
      if (frame.contacts[i].closed && !before.contacts[i].closed) {
        return std::string(kContactNames[i]);
      }
    }
    return "";
  });
  const bool well = answered == name_of(place);
  add(
    item, well ? CheckOutcome::kPassed : CheckOutcome::kFailed,
    well ? "closed" : (answered.empty() ? "nothing closed" : answered + " closed"),
    well ? "" : "its line and `active` level in devices.contacts");
  person_->thank(item);
  if (well) {  // the next one is told from it by being open before
    static_cast<void>(watch([&](const SensorFrame & frame) -> std::string {
      return frame.contact(place).closed ? "" : "open";
    }));
  }
}

void Commissioning::check_turn()
{
  const std::string item = "turn to the left";
  if (
    person_ == nullptr ||
    !person_->ask(item, "turn the robot a little to the left, seen from above against the clock")) {
    add(item, CheckOutcome::kSkipped, "");
    return;
  }
  double turned_rad = 0.0;
  Time last{0};
  const std::string answered = watch([&](const SensorFrame & frame) -> std::string {
    if (last > Time::zero() && frame.gyro.stamp > last) {
      turned_rad += frame.gyro.rate_rad_s[2] * time_to_seconds(frame.gyro.stamp - last);
    }
    last = std::max(last, frame.gyro.stamp);
    return std::abs(turned_rad) < kEnoughTurn_rad ? "" : (turned_rad > 0.0 ? "left" : "right");
  });
  const bool well = answered == "left";
  add(
    item, well ? CheckOutcome::kPassed : CheckOutcome::kFailed,
    answered.empty() ? "no turn was felt" : "counted to the " + answered,
    well ? "" : "devices.imu.mounting_*_rad: how the VN-100 is screwed on");
  person_->thank(item);
}

void print_check(std::ostream & out, const std::vector<CheckRow> & rows)
{
  std::size_t widest = 0;
  std::map<CheckOutcome, int> counts;
  for (const CheckRow & row : rows) {
    widest = std::max(widest, row.item.size());
    ++counts[row.outcome];
  }
  const auto word = [](CheckOutcome outcome) {
    return outcome == CheckOutcome::kPassed   ? "passed"
           : outcome == CheckOutcome::kFailed ? "FAILED"
                                              : "skipped";
  };
  for (const CheckRow & row : rows) {
    out << std::left << std::setw(static_cast<int>(widest) + 2) << row.item << std::setw(9)
        << word(row.outcome) << row.found << '\n';
    if (!row.advice.empty()) {
      out << std::setw(static_cast<int>(widest) + 11) << ""
          << "look at " << row.advice << '\n';
    }
  }
  out << counts[CheckOutcome::kPassed] << " passed, " << counts[CheckOutcome::kFailed]
      << " failed, " << counts[CheckOutcome::kSkipped] << " skipped\n";
}

bool all_well(const std::vector<CheckRow> & rows)
{
  return std::none_of(rows.begin(), rows.end(), [](const CheckRow & row) {
    return row.outcome == CheckOutcome::kFailed;
  });
}

}  // namespace stetro_driver
