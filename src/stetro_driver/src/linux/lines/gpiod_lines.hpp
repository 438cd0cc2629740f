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

#ifndef LINUX__LINES__GPIOD_LINES_HPP_
#define LINUX__LINES__GPIOD_LINES_HPP_

#include <poll.h>

#include <map>
#include <memory>
#include <string>
#include <vector>

#include "linux/lines/line_port.hpp"

struct gpiod_chip;
struct gpiod_line;

namespace stetro_driver::linux_io
{

/// Lines of the kernel's GPIO character devices, through libgpiod 1.6.
/** That library speaks the first version of the kernel's interface: one descriptor a line, a queue
 * of 16 edges that drops the newest, no debouncing. Its own second version has another interface:
 * everything of libgpiod stays behind this class. */
class GpiodLines : public LinePort
{
public:
  GpiodLines() = default;
  ~GpiodLines() override { close(); }

  [[nodiscard]] std::optional<IoFault> open(const std::vector<LineRequest> & lines) override;
  void close() noexcept override;
  [[nodiscard]] std::optional<IoFault> wait(Time patience, std::vector<LineEdge> & edges) override;
  [[nodiscard]] Result<LineLevels> levels() override;

private:
  struct CloseChip
  {
    void operator()(gpiod_chip * chip) const noexcept;  ///< and gives its lines back
  };

  [[nodiscard]] std::optional<IoFault> request(const LineRequest & line);
  [[nodiscard]] std::optional<IoFault> drain(std::size_t line, std::vector<LineEdge> & edges);

  std::map<std::string, std::unique_ptr<gpiod_chip, CloseChip>> chips_{};
  std::vector<gpiod_line *> lines_{};  // the chips'
  std::vector<pollfd> polled_{};       // one a line
  std::vector<std::string> names_{};   // for faults
};

}  // namespace stetro_driver::linux_io

#endif  // LINUX__LINES__GPIOD_LINES_HPP_
