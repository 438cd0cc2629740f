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

#ifndef LINUX__SERVO__HERKULEX_PACKET_HPP_
#define LINUX__SERVO__HERKULEX_PACKET_HPP_

#include <array>
#include <cstddef>
#include <cstdint>
#include <initializer_list>
#include <optional>

namespace stetro_driver::linux_io
{

/// Requests of the HerkuleX protocol. A reply carries its request plus kReply.
enum class HerkulexCommand : std::uint8_t {
  kEepWrite = 1,
  kEepRead = 2,
  kRamWrite = 3,
  kRamRead = 4,
  kIJog = 5,  ///< every servo with a time of its own
  kSJog = 6,  ///< all arrive together
  kStat = 7,
  kRollback = 8,
  kReboot = 9,
};

/// One packet: FF FF, size, id, command, two checksums, payload.
/**
 *   checksum1 = (size xor id xor command xor payload...) and FE                           (1)
 *   checksum2 = not checksum1 and FE                                                      (2)
 *
 * The size counts all of it, 7 to 223. Words are little-endian. Holds its bytes itself: packets
 * are made and read without allocating.
 */
class HerkulexPacket
{
public:
  static constexpr std::uint8_t kReply = 0x40;
  static constexpr std::uint8_t kBroadcast = 0xFE;
  static constexpr std::uint8_t kHighestId = 0xFD;
  static constexpr std::size_t kHeader = 7;
  static constexpr std::size_t kLongest = 223;

  HerkulexPacket() = default;
  HerkulexPacket(std::uint8_t id, std::uint8_t command) : id_(id), command_(command) {}
  HerkulexPacket(std::uint8_t id, HerkulexCommand command)
  : HerkulexPacket(id, static_cast<std::uint8_t>(command))
  {
  }

  [[nodiscard]] std::uint8_t id() const { return id_; }
  [[nodiscard]] std::uint8_t command() const { return command_; }
  [[nodiscard]] bool is(HerkulexCommand command) const
  {
    return command_ == static_cast<std::uint8_t>(command);
  }
  [[nodiscard]] bool replies_to(HerkulexCommand command) const
  {
    return command_ == static_cast<std::uint8_t>(command) + kReply;
  }

  [[nodiscard]] std::size_t size() const { return payload_size_; }
  [[nodiscard]] std::uint8_t operator[](std::size_t i) const { return payload_[i]; }
  [[nodiscard]] const std::uint8_t * payload() const { return payload_.data(); }
  [[nodiscard]] std::size_t room() const { return payload_.size() - payload_size_; }

  /// Appends to the payload; only while there is room().
  void append(std::uint8_t value) { payload_[payload_size_++] = value; }
  void append(std::initializer_list<std::uint8_t> values)
  {
    for (const std::uint8_t value : values) {
      append(value);
    }
  }
  void append_word(std::uint16_t value)
  {
    append({static_cast<std::uint8_t>(value & 0xFF), static_cast<std::uint8_t>(value >> 8)});
  }

  /// A word of the payload whose low byte is at i.
  [[nodiscard]] std::uint16_t word(std::size_t i) const
  {
    return static_cast<std::uint16_t>(payload_[i] | (payload_[i + 1] << 8));
  }

private:
  std::uint8_t id_ = 0;
  std::uint8_t command_ = 0;
  std::size_t payload_size_ = 0;
  std::array<std::uint8_t, kLongest - kHeader> payload_{};
};

[[nodiscard]] bool operator==(const HerkulexPacket & a, const HerkulexPacket & b);

/// A packet as it goes over the wire.
struct HerkulexBytes
{
  std::array<std::uint8_t, HerkulexPacket::kLongest> bytes{};
  std::size_t size = 0;
};

[[nodiscard]] HerkulexBytes encode(const HerkulexPacket & packet);

/// Finds packets in a stream of bytes, whatever else is in it and however it is cut.
/**
 * After a header or a checksum that is wrong the search goes on one byte behind the false start: a
 * packet that begins inside is not lost. Bytes that belong to no packet are counted.
 */
class HerkulexDecoder
{
public:
  /// Takes bytes and gives every packet they complete to `sink(const HerkulexPacket &)`.
  template <class Sink>
  void feed(const std::uint8_t * from, std::size_t size, Sink && sink)
  {
    for (std::size_t i = 0; i < size; ++i) {
      buffer_[size_++] = from[i];  // always room: what remains below is shorter than a packet
      while (const auto packet = next()) {
        sink(*packet);
      }
    }
  }

  /// Forgets a packet that has begun.
  void reset() { size_ = 0; }

  [[nodiscard]] std::uint64_t bad_checksums() const { return bad_checksums_; }
  [[nodiscard]] std::uint64_t dropped_bytes() const { return dropped_bytes_; }

private:
  enum class Look { kIncomplete, kComplete, kFalseStart };

  [[nodiscard]] std::optional<HerkulexPacket> next();
  [[nodiscard]] Look look();
  void drop_front(std::size_t count);

  std::array<std::uint8_t, HerkulexPacket::kLongest> buffer_{};
  std::size_t size_ = 0;
  std::uint64_t bad_checksums_ = 0;
  std::uint64_t dropped_bytes_ = 0;
};

}  // namespace stetro_driver::linux_io

#endif  // LINUX__SERVO__HERKULEX_PACKET_HPP_
