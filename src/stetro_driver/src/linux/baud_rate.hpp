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

#ifndef LINUX__BAUD_RATE_HPP_
#define LINUX__BAUD_RATE_HPP_

#include <cstdint>

namespace stetro_driver::linux_io
{

/// Sets any speed both ways, standard or not (HerkuleX knows 666 666 bit/s).
/** In a file of its own: the kernel's header for it clashes with that of the C library. */
[[nodiscard]] bool set_baud_rate(int fd, std::uint32_t bits_per_second);

/// The speed a terminal is set to, 0 if it does not say.
[[nodiscard]] std::uint32_t baud_rate(int fd);

}  // namespace stetro_driver::linux_io

#endif  // LINUX__BAUD_RATE_HPP_
