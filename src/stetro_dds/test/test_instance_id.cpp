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

#include <cstdint>
#include <set>

#include "stetro_dds/instance_id.hpp"

namespace stetro_dds
{
namespace
{

TEST(InstanceId, IsAnotherOneEachTimeAndNeverUnknown)
{
  std::set<std::uint64_t> drawn;
  for (int i = 0; i < 1000; ++i) {
    drawn.insert(draw_instance_id());
  }
  EXPECT_EQ(drawn.size(), 1000u);
  EXPECT_EQ(drawn.count(0), 0u);
}

}  // namespace
}  // namespace stetro_dds
