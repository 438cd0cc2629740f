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

#ifndef STETRO_DRIVER__REALTIME_HPP_
#define STETRO_DRIVER__REALTIME_HPP_

#include <cstdint>
#include <string>

#include "stetro_config/field.hpp"
#include "stetro_config/rule.hpp"

namespace stetro_driver::linux_io
{

/// What the control loop asks of the kernel, so that it wakes up in time.
struct RealtimeConfig
{
  std::int64_t priority = 0;
  bool lock_memory = false;
  std::int64_t cpu = -1;
};

template <class Visitor>
void visit(RealtimeConfig & p, Visitor && each)
{
  using stetro_config::Within;
  each(
    "priority", p.priority, Within{0, 99},
    "of SCHED_FIFO for the control loop; 0: scheduled as any process");
  each("lock_memory", p.lock_memory, stetro_config::Any{}, "keep all of its memory in RAM");
  each("cpu", p.cpu, Within{-1, 1023}, "the loop runs on this one only; -1: on any");
}

/// What became of one wish.
enum class WishOutcome : std::uint8_t { kNotAsked, kGranted, kRefused };

struct RealtimeReport
{
  WishOutcome priority = WishOutcome::kNotAsked;
  WishOutcome memory = WishOutcome::kNotAsked;
  WishOutcome cpu = WishOutcome::kNotAsked;
  std::string words;  ///< one line for the log, with what to do about a refusal

  [[nodiscard]] bool refused() const
  {
    return priority == WishOutcome::kRefused || memory == WishOutcome::kRefused ||
           cpu == WishOutcome::kRefused;
  }
};

/// Asks for the calling thread, and for the whole process's memory.
/** A refusal is told and not fatal: at some ten centimetres a second the robot runs without. Called
 * when threads and buffers exist, so that they are locked too; threads made later inherit it. */
[[nodiscard]] RealtimeReport ask_for_realtime(const RealtimeConfig & config);

}  // namespace stetro_driver::linux_io

#endif  // STETRO_DRIVER__REALTIME_HPP_
