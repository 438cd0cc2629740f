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

#ifndef SAMPLE_PARAMS_HPP_
#define SAMPLE_PARAMS_HPP_

#include <cstdint>
#include <string>
#include <vector>

#include "stetro_config/fault.hpp"
#include "stetro_config/field.hpp"

namespace sample
{

struct GateParams
{
  double sigma = 3.0;
  std::int64_t rejects = 5;
};

template <class Visitor>
void visit(GateParams & p, Visitor && each)
{
  each("sigma", p.sigma, stetro_config::Within{1.0, 10.0}, "gate [standard deviations]");
  each("rejects", p.rejects, stetro_config::AtLeast{1}, "rejects in a row before a warning");
}

/// One field of every kind, a group in the list, a group with a list of its own, limits that cross.
struct Params
{
  std::string estimator = "fused";
  double near_m = 0.03;
  double far_m = 1.2;
  bool debug = false;
  GateParams gate;
  std::vector<double> offsets_m{0.0, 0.0};
  std::vector<std::string> sensors{"side_left", "side_right"};
};

template <class Visitor>
void visit(Params & p, Visitor && each)
{
  using stetro_config::Any, stetro_config::Each, stetro_config::NonEmpty, stetro_config::OneOf;
  using stetro_config::Within;
  each("estimator", p.estimator, OneOf{"paper", "fused"}, "which one runs");
  each("tof.near_m", p.near_m, Within{0.0, 2.0}, "closer is not read [m]");
  each("tof.far_m", p.far_m, Within{0.0, 2.0}, "farther is not read [m]");
  each("debug", p.debug, Any{}, "a | b");
  visit(p.gate, stetro_config::Group{"gate", each});
  each("offsets_m", p.offsets_m, Each{Within{-0.1, 0.1}, 2, 2}, "left and right [m]");
  each("sensors", p.sensors, Each{NonEmpty{}}, "which are used");
}

inline void check(const Params & p, stetro_config::Faults & faults)
{
  if (p.near_m >= p.far_m) {
    faults.refuse(
      "tof.near_m", stetro_config::to_text(p.near_m),
      "less than tof.far_m, " + stetro_config::to_text(p.far_m));
  }
}

}  // namespace sample

#endif  // SAMPLE_PARAMS_HPP_
