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

#ifndef STETRO_SITE__FIT_HPP_
#define STETRO_SITE__FIT_HPP_

#include <string>

#include "stetro_config/fault.hpp"
#include "stetro_site/robot.hpp"
#include "stetro_site/robot_geometry.hpp"
#include "stetro_site/site.hpp"

namespace stetro_site
{

/// Every reason why a robot cannot work a site (D2); none if it can.
/**
 * For each flight, with W its width, R_w the contact width, s the separation of the side sensors:
 *   - W > R_w: it fits between the sides;
 *   - 2 * reliable range + s >= W: everywhere one side at least is in range (D1-5);
 *   - stroke >= highest riser + margin: a block can be lifted onto every step;
 *   - shortest tread >= two blocks: blocks 2 and 3 stand on one tread while block 1 is above.
 * The robot's own contradictions, `check(const RobotGeometry &, Faults &)`, are added.
 */
[[nodiscard]] stetro_config::Faults check_fit(const Site & site, const RobotGeometry & robot);

/// A site, and a robot that fits it.
struct Deployment
{
  Site site;
  Robot robot;
};

/// Reads both files. \throws stetro_config::ConfigError with every fault of both and of their fit
[[nodiscard]] Deployment load_deployment(
  const std::string & site_path, const std::string & robot_path);

}  // namespace stetro_site

#endif  // STETRO_SITE__FIT_HPP_
