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

#ifndef STETRO_DRIVER__PACER_HPP_
#define STETRO_DRIVER__PACER_HPP_

#include <array>
#include <cstddef>
#include <cstdint>

#include "stetro_driver/time.hpp"

namespace stetro_driver
{

/// Whom simulated time waits for.
enum class Peer : std::uint8_t {
  kLocalizer,   ///< heard through its poses
  kSupervisor,  ///< heard through its accepted commands
};
constexpr std::size_t kPeers = 2;

/// How simulated time passes against the steady clock.
struct PacerLimits
{
  double speed = 1.0;          ///< simulated seconds in a steady second
  bool throttle = true;        ///< wait for peers that fall behind
  Time lag_limit{80'000'000};  ///< a peer's newest stamp may be so old, in simulated time
  Time patience{200'000'000};  ///< the longest wait for a peer, in steady time
};

/// Decides when the next tick of simulated time may come.
/**
 *   Following --(stamp older than lag_limit)--->  Awaited    no tick until it is heard
 *   Awaited   --(heard)----------------------->   Following
 *   Awaited   --(patience is over)------------>   Lost       ticks go on, at real time at most
 *   Lost      --(heard)----------------------->   Following
 *
 * A peer that was never heard is not waited for. Pure: it reads no clock. One thread.
 */
class Pacer
{
public:
  /// \throws std::invalid_argument naming the limit, its value and what is accepted
  Pacer(const PacerLimits & limits, Time tick);

  /// A message of a peer came. \param stamp its simulated time \param now present simulated time
  /** Stamps of the future and old ones count as a sign of life, not as progress. */
  void hear(Peer peer, Time stamp, Time now);

  /// How long to wait from `steady` until a tick may come; zero: now.
  /** While a peer is awaited: what is left of our patience. Ask again when it spoke. */
  [[nodiscard]] Time wait(Time now, Time steady);

  /// A tick was made at `steady`.
  void ticked(Time steady);

  [[nodiscard]] bool lost(Peer peer) const { return at(peer).lost; }
  [[nodiscard]] std::uint64_t waits() const { return waits_; }    ///< times a peer was awaited
  [[nodiscard]] std::uint64_t losses() const { return losses_; }  ///< times patience ended

private:
  struct Watch
  {
    bool heard = false;
    bool lost = false;
    bool awaited = false;
    Time newest{0};
    Time awaited_since{0};
  };
  [[nodiscard]] const Watch & at(Peer peer) const
  {
    return watches_[static_cast<std::size_t>(peer)];
  }
  [[nodiscard]] Time patience_left(Watch & watch, Time now, Time steady);

  PacerLimits limits_;
  Time tick_;
  std::array<Watch, kPeers> watches_{};
  Time due_{0};  // steady time of the next tick
  Time last_tick_{0};
  std::uint64_t waits_ = 0;
  std::uint64_t losses_ = 0;
};

}  // namespace stetro_driver

#endif  // STETRO_DRIVER__PACER_HPP_
