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

#ifndef STETRO_DRIVER__STAIR_SHAPE_HPP_
#define STETRO_DRIVER__STAIR_SHAPE_HPP_

#include <vector>

namespace stetro_driver
{

/// One flight as a list of measures: step i is riser_m[i-1] high and tread_m[i-1] deep.
struct StairShape
{
  std::vector<double> riser_m;
  std::vector<double> tread_m;
  double width_foot_m = 0.0;  ///< wall to wall at the first riser
  double width_top_m = 0.0;   ///< wall to wall at the end of the last tread
  bool right_walled = true;   ///< false: an open side, over which a robot falls
  bool left_walled = true;
  double wall_overrun_m = 1.0;  ///< how far the side walls go on past both ends
};

}  // namespace stetro_driver

#endif  // STETRO_DRIVER__STAIR_SHAPE_HPP_
