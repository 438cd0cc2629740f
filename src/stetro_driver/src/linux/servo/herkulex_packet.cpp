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

#include "linux/servo/herkulex_packet.hpp"

#include <algorithm>

namespace stetro_driver::linux_io
{
namespace
{

constexpr std::uint8_t kMark = 0xFF;  // twice, in front of every packet

// Where things stand in a packet.
constexpr std::size_t kSizeAt = 2;
constexpr std::size_t kIdAt = 3;
constexpr std::size_t kCommandAt = 4;
constexpr std::size_t kChecksum1At = 5;
constexpr std::size_t kChecksum2At = 6;

// Equation (1) over a whole packet.
std::uint8_t checksum1_of(const std::uint8_t * bytes, std::size_t size)
{
  auto sum = static_cast<std::uint8_t>(bytes[kSizeAt] ^ bytes[kIdAt] ^ bytes[kCommandAt]);
  for (std::size_t i = HerkulexPacket::kHeader; i < size; ++i) {
    sum = static_cast<std::uint8_t>(sum ^ bytes[i]);
  }
  return sum & 0xFE;
}

// Equation (2).
std::uint8_t checksum2_of(std::uint8_t checksum1)
{
  return static_cast<std::uint8_t>(~checksum1) & 0xFE;
}

}  // namespace

bool operator==(const HerkulexPacket & a, const HerkulexPacket & b)
{
  return a.id() == b.id() && a.command() == b.command() && a.size() == b.size() &&
         std::equal(a.payload(), a.payload() + a.size(), b.payload());
}

HerkulexBytes encode(const HerkulexPacket & packet)
{
  HerkulexBytes to;
  to.size = HerkulexPacket::kHeader + packet.size();
  to.bytes[0] = kMark;
  to.bytes[1] = kMark;
  to.bytes[kSizeAt] = static_cast<std::uint8_t>(to.size);
  to.bytes[kIdAt] = packet.id();
  to.bytes[kCommandAt] = packet.command();
  std::copy_n(packet.payload(), packet.size(), to.bytes.data() + HerkulexPacket::kHeader);
  to.bytes[kChecksum1At] = checksum1_of(to.bytes.data(), to.size);
  to.bytes[kChecksum2At] = checksum2_of(to.bytes[kChecksum1At]);
  return to;
}

std::optional<HerkulexPacket> HerkulexDecoder::next()
{
  while (size_ > 0) {
    const Look found = look();
    if (found == Look::kIncomplete) {
      return std::nullopt;
    }
    if (found == Look::kFalseStart) {
      ++dropped_bytes_;
      drop_front(1);
      continue;
    }
    const std::size_t whole = buffer_[kSizeAt];
    HerkulexPacket packet{buffer_[kIdAt], buffer_[kCommandAt]};
    for (std::size_t i = HerkulexPacket::kHeader; i < whole; ++i) {
      packet.append(buffer_[i]);
    }
    drop_front(whole);
    return packet;
  }
  return std::nullopt;
}

HerkulexDecoder::Look HerkulexDecoder::look()
{
  if (buffer_[0] != kMark || (size_ > 1 && buffer_[1] != kMark)) {
    return Look::kFalseStart;
  }
  if (size_ <= kSizeAt) {
    return Look::kIncomplete;
  }
  const std::size_t whole = buffer_[kSizeAt];
  const bool impossible = whole < HerkulexPacket::kHeader || whole > HerkulexPacket::kLongest ||
                          (size_ > kIdAt && buffer_[kIdAt] > HerkulexPacket::kBroadcast);
  if (impossible) {
    return Look::kFalseStart;
  }
  if (size_ < whole) {
    return Look::kIncomplete;
  }
  const std::uint8_t expected = checksum1_of(buffer_.data(), whole);
  if (buffer_[kChecksum1At] != expected || buffer_[kChecksum2At] != checksum2_of(expected)) {
    ++bad_checksums_;
    return Look::kFalseStart;
  }
  return Look::kComplete;
}

void HerkulexDecoder::drop_front(std::size_t count)
{
  std::copy(buffer_.data() + count, buffer_.data() + size_, buffer_.data());
  size_ -= count;
}

}  // namespace stetro_driver::linux_io
