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

#ifndef STETRO_LOCALIZER__FUSED__AS_BUILT_RECORD_HPP_
#define STETRO_LOCALIZER__FUSED__AS_BUILT_RECORD_HPP_

#include <cstdint>
#include <vector>

#include "stetro_localizer/fused/fused_core.hpp"
#include "stetro_localizer/staircase_as_built.hpp"

namespace stetro_localizer
{

/// The steps that block 2 has left behind, each with the best that was known of it.
/**
 * It follows the core that no late sample changes any more, so that a change of the step which is
 * taken back leaves nothing here; the last moments are in the core itself. A robot that is located
 * anew may have been on other steps than it thought, and begins anew.
 */
class AsBuiltRecord
{
public:
  explicit AsBuiltRecord(int steps) : steps_(static_cast<std::size_t>(steps)) {}

  /// Takes what a settled core has left behind. Does not allocate.
  void follow(const FusedCore & settled);

  /// The steps known so far, rising.
  /** \param now the newest core \param here what it knows of the step under block 2 */
  [[nodiscard]] std::vector<StepAsBuilt> steps(
    const FusedCore & now, const StepAsBuilt & here) const;

private:
  std::vector<StepAsBuilt> steps_;  // [step - 1]
  std::uint32_t jumps_ = 0;         // of the core that was followed last
};

}  // namespace stetro_localizer

#endif  // STETRO_LOCALIZER__FUSED__AS_BUILT_RECORD_HPP_
