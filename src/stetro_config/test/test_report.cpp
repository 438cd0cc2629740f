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

#include "./sample_params.hpp"
#include "stetro_config/loader.hpp"
#include "stetro_config/report.hpp"

namespace stetro_config
{
namespace
{

TEST(Report, PrintsWhatIsInForce)
{
  sample::Params params;
  params.near_m = 0.05;
  EXPECT_EQ(
    to_yaml(params, 2),
    "  estimator: \"fused\"  # which one runs\n"
    "  tof:\n"
    "    near_m: 0.05  # closer is not read [m]\n"
    "    far_m: 1.2  # farther is not read [m]\n"
    "  debug: false  # a | b\n"
    "  gate:\n"
    "    sigma: 3.0  # gate [standard deviations]\n"
    "    rejects: 5  # rejects in a row before a warning\n"
    "  offsets_m: [0.0, 0.0]  # left and right [m]\n"
    "  sensors: [\"side_left\", \"side_right\"]  # which are used\n");
}

TEST(Report, PrintsWhatLoadsBackTheSame)
{
  sample::Params params;
  params.far_m = 1.0 / 3.0;
  params.gate.rejects = 7;
  params.sensors = {"a: b", "#"};
  Loader<sample::Params> loader;
  loader.read_map(YAML::Load(to_yaml(params)), "printed");
  EXPECT_EQ(to_yaml(loader.finish()), to_yaml(params));
}

TEST(Report, WritesTheReferenceTable)
{
  const std::string table = reference_table<sample::Params>();
  EXPECT_EQ(
    table.substr(0, table.find("| `tof.far_m`")),
    "| name | type | default | accepted | meaning |\n"
    "|---|---|---|---|---|\n"
    "| `estimator` | string | `\"fused\"` | one of paper, fused | which one runs |\n"
    "| `tof.near_m` | double | `0.03` | 0 to 2 | closer is not read [m] |\n");
  EXPECT_NE(table.find("| `debug` | bool | `false` | any | a \\| b |\n"), std::string::npos);
}

}  // namespace
}  // namespace stetro_config
