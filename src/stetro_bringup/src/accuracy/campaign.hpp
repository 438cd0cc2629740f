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

#ifndef ACCURACY__CAMPAIGN_HPP_
#define ACCURACY__CAMPAIGN_HPP_

#include <functional>
#include <vector>

#include "accuracy/climb.hpp"

namespace stetro_bringup
{

/// Makes climbs, several at a time, and hands them on in the order in which they were ordered.
/**
 * Each climb lives in one thread and shares nothing but the setup, which nobody writes: what comes
 * out does not depend on the number of threads.
 *
 * \param jobs threads; 0: as many as the machine has cores
 * \param take called with one finished climb after the other, from one thread at a time
 * \throws what a climb throws, after the others under way have ended
 */
void run_campaign(
  const RobotSetup & setup, const std::vector<ClimbOrder> & orders, unsigned jobs,
  const std::function<void(const ClimbOrder &, const ClimbRecord &)> & take);

}  // namespace stetro_bringup

#endif  // ACCURACY__CAMPAIGN_HPP_
