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

#ifndef LINUX__LINES__LINE_PORT_HPP_
#define LINUX__LINES__LINE_PORT_HPP_

#include <bitset>
#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "stetro_driver/result.hpp"
#include "stetro_driver/time.hpp"

namespace stetro_driver::linux_io
{

/// What holds a line's level while nothing drives it.
enum class LineBias { kNone, kPullUp, kPullDown };

/// One input line of a GPIO chip.
struct LineRequest
{
  std::string chip;         ///< name, label or path
  unsigned int offset = 0;  ///< of the line in its chip
  bool active_low = true;
  LineBias bias = LineBias::kPullUp;
};

/// A line became active, or ceased to be.
struct LineEdge
{
  std::size_t line = 0;  ///< in the order requested
  bool active = false;
  Time stamp{0};  ///< CLOCK_MONOTONIC
};

constexpr std::size_t kMostLines = 32;
/// Which lines are active, in the order requested.
using LineLevels = std::bitset<kMostLines>;

/// Input lines, real or emulated.
/**
 * Active is logical: a line requested as active-low is active at 0 V. Edges may be lost, as the
 * kernel's queue of 16 loses the newest of a line that bounces: levels are the truth, edges are
 * what happened between two looks at them. Called from one thread.
 */
class LinePort
{
public:
  LinePort() = default;
  virtual ~LinePort() = default;
  LinePort(const LinePort &) = delete;
  LinePort & operator=(const LinePort &) = delete;

  /// Requests lines, at most kMostLines. \return why it cannot; then none is requested
  [[nodiscard]] virtual std::optional<IoFault> open(const std::vector<LineRequest> & lines) = 0;

  /// Gives all lines back. May be called twice.
  virtual void close() noexcept = 0;

  /// Waits for an edge of any line, and takes all there are.
  /**
   * \param patience of the machine's time
   * \param edges is emptied first; of one line in the order of time
   * \return a fault if the lines are gone; no edge is none
   */
  [[nodiscard]] virtual std::optional<IoFault> wait(
    Time patience, std::vector<LineEdge> & edges) = 0;

  /// The levels now.
  [[nodiscard]] virtual Result<LineLevels> levels() = 0;
};

}  // namespace stetro_driver::linux_io

#endif  // LINUX__LINES__LINE_PORT_HPP_
