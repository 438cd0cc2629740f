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

#include <cmath>
#include <stdexcept>

#include "./sample_params.hpp"
#include "stetro_config/field.hpp"

namespace stetro_config
{
namespace
{

TEST(Field, IsBoundToTheStructItWasDeclaredOn)
{
  sample::Params params;
  const auto fields = fields_of(params);
  ASSERT_EQ(fields.size(), 8U);
  EXPECT_EQ(fields[1].name, "tof.near_m");
  EXPECT_EQ(fields[1].kind, Kind::kDouble);
  EXPECT_EQ(fields[1].limits, "0 to 2");
  EXPECT_EQ(fields[1].accepted, "a finite number, 0 to 2");
  EXPECT_EQ(fields[4].name, "gate.sigma");
  EXPECT_EQ(std::get<double>(fields[4].get()), 3.0);
  EXPECT_TRUE(fields[4].assign(Value{4.0}));
  EXPECT_EQ(params.gate.sigma, 4.0);
}

TEST(Field, KeepsItsValueWhenItRefusesAnother)
{
  sample::Params params;
  const auto fields = fields_of(params);
  EXPECT_FALSE(fields[1].assign(Value{2.5})) << "out of bounds";
  EXPECT_FALSE(fields[1].assign(Value{std::nan("")})) << "not a number";
  EXPECT_FALSE(fields[1].assign(Value{std::int64_t{1}})) << "another kind";
  EXPECT_EQ(params.near_m, 0.03);
}

TEST(Field, CannotBeDeclaredTwiceNorAsAGroup)
{
  FieldCollector each;
  double x = 0.0;
  each("a.b", x, Any{}, "");
  EXPECT_THROW(each("a.b", x, Any{}, ""), std::logic_error);
  EXPECT_THROW(each("a", x, Any{}, ""), std::logic_error);
  EXPECT_THROW(each("a.b.c", x, Any{}, ""), std::logic_error);
  EXPECT_NO_THROW(each("a.bc", x, Any{}, ""));
}

}  // namespace
}  // namespace stetro_config
