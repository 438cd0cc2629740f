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

#include <nlohmann/json.hpp>

#include "stetro_bringup/summary.hpp"

namespace stetro_bringup
{

TEST(Summary, HasTheKeysThatScriptsRead)
{
  ClimbErrors errors;
  errors.y_error_m.add(0.03);
  const auto summary = nlohmann::json::parse(summary_json(ClimbOutcome{}, errors));
  for (const char * key :
       {"completed", "final_step", "integrity", "seed", "estimator", "y_rmse_m", "x_rmse_m",
        "heading_rmse_rad", "closure_error_mean_m", "closure_error_std_m", "wall_time_s",
        "faults"}) {
    EXPECT_TRUE(summary.contains(key)) << key;
  }
  EXPECT_NEAR(summary["y_rmse_m"].get<double>(), 0.03, 1e-12);
  EXPECT_TRUE(summary["x_rmse_m"].is_null()) << "nothing was measured, so nothing is claimed";
}

TEST(Summary, CountsAClimbOnlyOnTheLastStepTrustedAndWithoutFault)
{
  ClimbOutcome good;
  good.completed = true;
  good.final_step = 16;
  good.integrity = "OK";
  EXPECT_TRUE(succeeded(good, 16));
  EXPECT_FALSE(succeeded(good, 17));
  auto outcome = good;
  outcome.completed = false;
  EXPECT_FALSE(succeeded(outcome, 16));
  outcome = good;
  outcome.integrity = "DEGRADED";
  EXPECT_FALSE(succeeded(outcome, 16));
  outcome = good;
  outcome.faults = {"bumper stuck"};
  EXPECT_FALSE(succeeded(outcome, 16));
}

}  // namespace stetro_bringup
