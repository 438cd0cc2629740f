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

#ifndef EMULATOR__EMULATED_LINES_HPP_
#define EMULATOR__EMULATED_LINES_HPP_

#include <condition_variable>
#include <deque>
#include <map>
#include <mutex>
#include <optional>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "linux/device_clock.hpp"
#include "linux/lines/line_port.hpp"

namespace stetro_driver::emulator
{

/// A line by its chip and its offset in it.
using LineName = std::pair<std::string, unsigned int>;

/// GPIO lines without a kernel: somebody drives their levels, the driver sees levels and edges.
/**
 * Levels are electrical here and turned into active or inactive as the driver asked. A line that
 * nobody drives floats to where its bias pulls it: that is an open switch, and a broken wire.
 * Edges queue up as in the kernel's first interface: 16 a line, then the newest are dropped.
 *
 * Times are of the device clock, so an emulation that runs faster bounces faster. The driver's side
 * (LinePort) is called from one thread, everything else from any.
 */
class EmulatedLines : public linux_io::LinePort
{
public:
  explicit EmulatedLines(const linux_io::DeviceClock & clock);

  // The world's side.
  /// Drives a line to a level.
  void drive(const LineName & line, bool high);
  /// Lets go of a line.
  void release(const LineName & line);

  // What can go wrong.
  /// From now on a change of level comes with so many changes there and back, 0.2 ms apart.
  void set_bounces(int bounces);
  /// Edges of a line are lost, all of them; its level is right.
  void lose_edges(const LineName & line, bool lost);
  /// A line stays at a level, whatever drives it; nothing: it is whole again.
  void stick(const LineName & line, std::optional<bool> high);
  /// A loose wire: the line changes its level every millisecond.
  void set_chatter(const LineName & line, bool chatters);
  /// The chip is gone (ENODEV), or back; lines that were requested before are not.
  void set_plugged(const std::string & chip, bool plugged);
  /// Another chip in the place of one: it has so many lines.
  void replace(const std::string & chip, unsigned int lines);
  /// Another program has the line (EBUSY), or gave it back.
  void set_taken(const LineName & line, bool taken);
  /// Whoever waits or reads gets no answer until this ends.
  void set_hanging(bool hanging);

  // The driver's side.
  [[nodiscard]] std::optional<IoFault> open(
    const std::vector<linux_io::LineRequest> & lines) override;
  void close() noexcept override;
  [[nodiscard]] std::optional<IoFault> wait(
    Time patience, std::vector<linux_io::LineEdge> & edges) override;
  [[nodiscard]] Result<linux_io::LineLevels> levels() override;

private:
  using Lock = std::unique_lock<std::mutex>;

  struct Change
  {
    Time at{0};  ///< CLOCK_MONOTONIC
    bool high = false;
  };
  /// What drives a line, and what is yet to come.
  struct Wire
  {
    std::optional<bool> driven{};
    std::optional<bool> stuck{};
    std::deque<Change> coming{};
    bool high = false;  ///< now
    bool edges_lost = false;
    bool chatters = false;
  };
  /// A line that was requested.
  struct Requested
  {
    linux_io::LineRequest request;
    std::deque<linux_io::LineEdge> queue{};
  };

  void change(const LineName & name, bool bounce);
  [[nodiscard]] bool rest_level(const LineName & name, const Wire & wire) const;
  /// Lets happen what is due, in the order of time of each line.
  void advance(Time now);
  void put_edge(const LineName & name, const Wire & wire, Time at);
  [[nodiscard]] Time next_change(Time limit) const;
  [[nodiscard]] std::optional<IoFault> gone() const;
  [[nodiscard]] std::optional<IoFault> refusal(const linux_io::LineRequest & line) const;
  void unplug(const std::string & chip);
  void wait_while_hanging(Lock & lock);

  linux_io::DeviceClock clock_;
  mutable std::mutex mutex_{};
  std::condition_variable changed_{};
  std::map<LineName, Wire> wires_{};
  std::vector<Requested> requested_{};
  std::optional<std::string> lost_{};  // a chip that went while its lines were requested
  std::set<std::string> unplugged_{};
  std::map<std::string, unsigned int> sizes_{};  // of chips with few lines
  std::set<LineName> taken_{};
  int bounces_ = 0;
  bool hanging_ = false;
};

}  // namespace stetro_driver::emulator

#endif  // EMULATOR__EMULATED_LINES_HPP_
