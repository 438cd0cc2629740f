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

#include "emulator/emulated_tof.hpp"

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstdio>
#include <cstring>
#include <string_view>

namespace stetro_driver::emulator
{
namespace
{

using std::chrono::milliseconds;

constexpr Time kMeasurement = milliseconds{33};       // default timing budget, DS11555 section 3.6
constexpr Time kSlowMeasurement = milliseconds{90};   // the kernel's driver still waits for it
constexpr Time kKernelsPatience = milliseconds{100};  // then it gives up
constexpr std::array<std::string_view, 7> kGarbage{"",       "123",         "0123\n", "-5\n",
                                                   "9999\n", "1\xf7\x80\n", "12 \n"};

}  // namespace

EmulatedTof::EmulatedTof(const linux_io::DeviceClock & clock) : clock_(clock) {}

void EmulatedTof::see(int millimetres)
{
  const std::lock_guard lock{mutex_};
  millimetres_ = millimetres;
}

void EmulatedTof::set_trouble(TofTrouble trouble)
{
  const std::lock_guard lock{mutex_};
  trouble_ = trouble;
  changed_.notify_all();
}

void EmulatedTof::set_bound(bool bound)
{
  const std::lock_guard lock{mutex_};
  bound_ = bound;
  changed_.notify_all();
}

std::uint64_t EmulatedTof::reads() const
{
  const std::lock_guard lock{mutex_};
  return reads_;
}

std::uint64_t EmulatedTof::overlaps() const
{
  const std::lock_guard lock{mutex_};
  return overlaps_;
}

ssize_t EmulatedTof::read(char * to, std::size_t room) noexcept
{
  Lock lock{mutex_};
  ++reads_;
  overlaps_ += readers_ > 0 ? 1 : 0;
  ++readers_;
  int millimetres = 0;
  const int failed = measure(lock, millimetres);
  --readers_;
  return failed != 0 ? failed : print(millimetres, to, room);
}

int EmulatedTof::measure(Lock & lock, int & millimetres)
{
  const Time half = (trouble_ == TofTrouble::kSlow ? kSlowMeasurement : kMeasurement) / 2;
  if (const int failed = last(lock, half); failed != 0) {
    return failed;
  }
  millimetres = millimetres_;
  if (const int failed = last(lock, half); failed != 0) {
    return failed;
  }
  if (trouble_ != TofTrouble::kSilent) {
    return 0;
  }
  const int failed = last(lock, kKernelsPatience - 2 * half);
  return failed != 0 ? failed : -ETIMEDOUT;
}

int EmulatedTof::last(Lock & lock, Time duration)
{
  const Time real = clock_.real(duration);
  changed_.wait_for(lock, real, [this] { return error() != 0; });
  return error();
}

int EmulatedTof::error() const noexcept
{
  if (!bound_) {
    return -ENODEV;
  }
  switch (trouble_) {
    case TofTrouble::kNoReply:
      return -EREMOTEIO;
    case TofTrouble::kBadBus:
      return -EIO;
    default:
      return 0;
  }
}

ssize_t EmulatedTof::print(int millimetres, char * to, std::size_t room) noexcept
{
  std::array<char, 16> digits{};
  std::snprintf(digits.data(), digits.size(), "%d\n", millimetres);
  std::string_view text{digits.data()};
  if (trouble_ == TofTrouble::kGarbled) {
    text = kGarbage[garbled_++ % kGarbage.size()];
  }
  const std::size_t size = std::min(room, text.size());
  std::memcpy(to, text.data(), size);
  return static_cast<ssize_t>(size);
}

}  // namespace stetro_driver::emulator
