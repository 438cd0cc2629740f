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

#ifndef EMULATOR__PTY_HPP_
#define EMULATOR__PTY_HPP_

#include <cstddef>
#include <cstdint>
#include <string>

namespace stetro_driver::emulator
{

/// The device's end of a serial cable: a pseudo-terminal under a name that stays.
/**
 * Raw before the first byte, so that nothing is echoed. It keeps the host's end open once, so that
 * the host may close and open it. Nothing blocks. Used by one thread.
 */
class Pty
{
public:
  /// \param link path of the symbolic link that the host opens; replaced if there is one
  /** \throws std::system_error */
  explicit Pty(std::string link);
  ~Pty();
  Pty(const Pty &) = delete;
  Pty & operator=(const Pty &) = delete;

  /// Pulls the cable: the host's open file hangs up and the link is gone. Twice is once.
  void unplug() noexcept;

  /// Plugs it in again: another pseudo-terminal under the same link. \throws std::system_error
  void plug();

  [[nodiscard]] bool plugged() const { return master_ >= 0; }

  /// The speed the host has set [bit/s]; 0 while unplugged.
  [[nodiscard]] std::uint32_t baud() const;

  /// What the host has sent. \return how many bytes, 0: nothing
  [[nodiscard]] std::size_t read(std::uint8_t * to, std::size_t room);

  /// Sends to the host. Bytes that find no room are lost, as on a wire nobody listens to.
  void write(const std::uint8_t * from, std::size_t size);

  /// For poll(); -1 while unplugged.
  [[nodiscard]] int fd() const { return master_; }
  [[nodiscard]] const std::string & link() const { return link_; }

private:
  std::string link_;
  int master_ = -1;
  int slave_ = -1;
};

}  // namespace stetro_driver::emulator

#endif  // EMULATOR__PTY_HPP_
