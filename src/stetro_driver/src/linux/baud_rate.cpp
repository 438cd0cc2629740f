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

#include "linux/baud_rate.hpp"

#include <asm/termbits.h>
#include <sys/ioctl.h>

namespace stetro_driver::linux_io
{

bool set_baud_rate(int fd, std::uint32_t bits_per_second)
{
  termios2 line{};
  if (ioctl(fd, TCGETS2, &line) != 0) {
    return false;
  }
  line.c_cflag &= ~static_cast<tcflag_t>(CBAUD | CIBAUD);
  line.c_cflag |= BOTHER;
  line.c_ispeed = bits_per_second;
  line.c_ospeed = bits_per_second;
  return ioctl(fd, TCSETS2, &line) == 0;
}

std::uint32_t baud_rate(int fd)
{
  termios2 line{};
  return ioctl(fd, TCGETS2, &line) == 0 ? line.c_ospeed : 0;
}

}  // namespace stetro_driver::linux_io
