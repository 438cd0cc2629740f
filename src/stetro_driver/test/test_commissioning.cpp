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

#include <algorithm>
#include <map>
#include <memory>
#include <sstream>
#include <string>

#include "hardware_bench.hpp"
#include "stetro_driver/commissioning.hpp"

namespace stetro_driver
{
namespace
{

using emulator::EmulatedDevices;
using emulator::EmulatedRobot;

template <class Names>
std::size_t place_in(const std::string & item, const std::string & prefix, const Names & names)
{
  const std::string name = item.substr(prefix.size());
  return static_cast<std::size_t>(std::find(names.begin(), names.end(), name) - names.begin());
}

/// Does what it is asked to, to emulated devices. What it was told to do wrongly, it does wrongly.
class Hands : public Assistant
{
public:
  explicit Hands(EmulatedDevices & devices) : devices_(devices) {}

  bool ask(const std::string & item, const std::string &) override
  {
    asked.push_back(item);
    if (item == skipped) {
      return false;
    }
    act(item, true);
    return true;
  }
  void thank(const std::string & item) override { act(item, false); }

  std::vector<std::string> asked;
  std::string skipped;
  std::map<std::string, std::string> instead;  ///< of an item, another one
  double turn_rad_s = 0.3;

private:
  void act(const std::string & asked_for, bool begin)
  {
    const auto other = instead.find(asked_for);
    const std::string item = other == instead.end() ? asked_for : other->second;
    if (item.rfind("hand", 0) == 0) {
      devices_.hold_before(
        static_cast<RangePlace>(place_in(item, "hand before ", kRangeNames)),
        begin ? std::optional<double>{0.012} : std::nullopt);
    } else if (item.rfind("push", 0) == 0) {
      devices_.press(
        static_cast<ContactPlace>(place_in(item, "push of ", kContactNames)),
        begin ? std::optional<bool>{true} : std::nullopt);
    } else {
      devices_.spin(begin ? std::optional<double>{turn_rad_s} : std::nullopt);
    }
  }

  EmulatedDevices & devices_;
};

class CommissioningTest : public ::testing::Test
{
protected:
  std::vector<CheckRow> check(Assistant * person)
  {
    return Commissioning{*robot_, [this] { return robot_->time(); }, person}.run();
  }

  static CheckRow row(const std::vector<CheckRow> & rows, const std::string & item)
  {
    for (const CheckRow & each : rows) {
      if (each.item == item) {
        return each;
      }
    }
    ADD_FAILURE() << "no row " << item;
    return {};
  }

  std::unique_ptr<EmulatedRobot> robot_ =
    test::emulated_robot(test::perfect(), test::patient(test::shipped_devices()));
};

TEST_F(CommissioningTest, FindsReadsAndVerifiesEverything)
{
  Hands hands{robot_->emulated()};
  const auto rows = check(&hands);
  EXPECT_TRUE(all_well(rows));
  for (const CheckRow & each : rows) {
    const bool blind = each.item == "hand before block3_front";  // it sees block 2 at 3.5 cm
    EXPECT_TRUE(each.outcome == CheckOutcome::kPassed || blind) << each.item << ": " << each.found;
  }
  EXPECT_GE(hands.asked.size(), kRangePlaces - 1 + kContactPlaces + 1);
  EXPECT_EQ(row(rows, "reads emergency_stop").found, "open");
  EXPECT_EQ(row(rows, "turn to the left").found, "counted to the left");
}

TEST_F(CommissioningTest, SkipsSignsWithoutAPerson)
{
  const auto rows = check(nullptr);
  EXPECT_TRUE(all_well(rows));
  EXPECT_EQ(row(rows, "hand before side_left").outcome, CheckOutcome::kSkipped);
  EXPECT_EQ(row(rows, "turn to the left").outcome, CheckOutcome::kSkipped);
}

TEST_F(CommissioningTest, FindsWhatIsSwapped)
{
  Hands hands{robot_->emulated()};
  hands.instead["hand before side_left"] = "hand before side_right";
  hands.instead["push of riser_left"] = "push of riser_right";
  hands.skipped = "push of left_front";
  hands.turn_rad_s = -0.3;
  const auto rows = check(&hands);
  EXPECT_FALSE(all_well(rows));
  EXPECT_EQ(row(rows, "hand before side_left").found, "side_right saw it");
  EXPECT_EQ(row(rows, "push of riser_left").found, "riser_right closed");
  EXPECT_EQ(row(rows, "push of left_front").outcome, CheckOutcome::kSkipped);
  EXPECT_EQ(row(rows, "turn to the left").found, "counted to the right");
  EXPECT_FALSE(row(rows, "turn to the left").advice.empty());
}

TEST_F(CommissioningTest, SaysWhatIsMissingAndWhatToDo)
{
  robot_->emulated().imu().unplug();
  const auto rows = check(nullptr);
  EXPECT_FALSE(all_well(rows));
  EXPECT_EQ(row(rows, "imu").outcome, CheckOutcome::kFailed);
  EXPECT_NE(row(rows, "imu").advice.find("VN-100"), std::string::npos);
  EXPECT_EQ(row(rows, "servos").outcome, CheckOutcome::kPassed);
  EXPECT_EQ(row(rows, "readings and signs").outcome, CheckOutcome::kSkipped);
}

TEST(CheckTable, CountsItsRows)
{
  std::ostringstream out;
  print_check(
    out, {{"imu", CheckOutcome::kFailed, "silent", "its cable"},
          {"contacts", CheckOutcome::kPassed, "found", ""}});
  EXPECT_EQ(
    out.str(),
    "imu       FAILED   silent\n"
    "                   look at its cable\n"
    "contacts  passed   found\n"
    "1 passed, 1 failed, 0 skipped\n");
}

TEST(TerminalAssistant, GoesOnWithEnterAndSkipsWithS)
{
  std::istringstream in{"\ns\n"};
  std::ostringstream out;
  TerminalAssistant person{&in, out};
  EXPECT_TRUE(person.ask("push of left_front", "press it"));
  EXPECT_FALSE(person.ask("push of left_rear", "press it"));
  EXPECT_FALSE(person.ask("push of left_rear", "press it")) << "the terminal has gone";
  TerminalAssistant nobody{nullptr, out};
  EXPECT_TRUE(nobody.ask("push of left_rear", "press it"));
}

}  // namespace
}  // namespace stetro_driver
