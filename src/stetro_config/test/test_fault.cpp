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

#include <sstream>

#include "stetro_config/fault.hpp"

namespace stetro_config
{
namespace
{

TEST(Fault, PrintsPlaceNameValueAndWhatIsAccepted)
{
  std::ostringstream out;
  out << Fault{"stairs.yaml", 7, "riser_m", "9", "0.05 to 0.25"};
  EXPECT_EQ(out.str(), "stairs.yaml:7: riser_m: value '9' refused, accepted: 0.05 to 0.25");
}

TEST(Fault, LeavesOutWhatIsEmpty)
{
  EXPECT_EQ(to_string({"a.yaml", 0, "k", "v", "w"}), "a.yaml: k: value 'v' refused, accepted: w");
  EXPECT_EQ(to_string({"a.yaml", 2, "", "v", "w"}), "a.yaml:2: value 'v' refused, accepted: w");
  EXPECT_EQ(to_string({"", 0, "k", kMissing, "w"}), "k: missing, accepted: w");
}

TEST(Faults, ThrowOnceWithAllOfThemInOrderOfFileAndLine)
{
  Faults faults;
  EXPECT_NO_THROW(faults.throw_if_any());
  faults.add({"b.yaml", 1, "x", "1", "2"});
  faults.add({"a.yaml", 9, "y", "1", "2"});
  faults.add({"a.yaml", 3, "z", "1", "2"});
  try {
    faults.throw_if_any();
    FAIL() << "nothing thrown";
  } catch (const ConfigError & error) {
    ASSERT_EQ(error.faults().size(), 3U);
    EXPECT_EQ(
      std::string{error.what()},
      "3 faults in the configuration:\n"
      "  a.yaml:3: z: value '1' refused, accepted: 2\n"
      "  a.yaml:9: y: value '1' refused, accepted: 2\n"
      "  b.yaml:1: x: value '1' refused, accepted: 2");
  }
}

}  // namespace
}  // namespace stetro_config
