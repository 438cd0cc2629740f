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

#ifndef ACCURACY__STEP_WATCH_HPP_
#define ACCURACY__STEP_WATCH_HPP_

#include <cstdint>
#include <optional>
#include <vector>

#include "accuracy/moment.hpp"

namespace stetro_bringup
{

/// How a miscount ended.
enum class MiscountEnd {
  kUnnoticed,  ///< it had not when the climb was over
  kNoticed,    ///< integrity was not OK
  kCorrected,  ///< the step was right again before integrity left OK
};

/// A wrong step, from its beginning to its end.
struct Miscount
{
  std::uint64_t climbs = 0;  ///< times that block 2 was lifted before anybody noticed
  MiscountEnd end = MiscountEnd::kUnnoticed;
};

/// The steps of one climb.
struct StepTally
{
  std::uint64_t checks = 0;      ///< times that block 2 was about to be lifted
  std::uint64_t wrong = 0;       ///< of these, with a wrong step
  std::uint64_t undetected = 0;  ///< of these, with integrity OK
  std::uint64_t on_stairs = 0;   ///< checks from the end of the first tread on
  std::vector<Miscount> miscounts;
};

/// Compares the counted step with the true one: where it matters, and for how long it is wrong.
/**
 * It matters when block 2 is about to be lifted. A lift that goes on after a stop is the same one.
 *
 * A miscount is a wrong step that has lasted for longer than a touch-down takes to be counted, half
 * a second, or that meets a lift. It ends when the step has been right for as long: a count that
 * runs ahead agrees with the truth for a moment at each touch-down. No step at all is a miscount
 * only when it meets a lift.
 */
class StepWatch
{
public:
  /// A tick of the climb. Times rise from call to call.
  void watch(const Moment & now);

  /// Block 2 has not yet been lifted on the stairs.
  [[nodiscard]] bool first_tread() const { return first_tread_; }

  /// Everything seen. Call it once, at the end.
  [[nodiscard]] StepTally take();

private:
  [[nodiscard]] bool begins_lift(stetro_supervisor::State state);
  void check(const Moment & now);
  void end_miscount();

  StepTally tally_;
  bool first_tread_ = true;
  stetro_supervisor::State working_in_ = stetro_supervisor::State::kIdle;  ///< standing aside
  bool wrong_ = false;
  stetro_driver::Time since_{0};  ///< the step has been right, or wrong, from then on
  std::optional<Miscount> miscount_;
};

}  // namespace stetro_bringup

#endif  // ACCURACY__STEP_WATCH_HPP_
