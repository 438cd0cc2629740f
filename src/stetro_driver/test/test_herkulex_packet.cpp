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

#include <gtest/gtest.h>

#include <cstring>
#include <random>
#include <sstream>
#include <string>
#include <vector>

#include "linux/servo/herkulex_packet.hpp"

namespace stetro_driver::linux_io
{
namespace
{

using Bytes = std::vector<std::uint8_t>;
using Packets = std::vector<HerkulexPacket>;

Bytes from_hex(const std::string & text)
{
  std::istringstream words{text};
  Bytes bytes;
  for (int value = 0; words >> std::hex >> value;) {
    bytes.push_back(static_cast<std::uint8_t>(value));
  }
  return bytes;
}

Bytes on_wire(const HerkulexPacket & packet)
{
  const HerkulexBytes encoded = encode(packet);
  return {encoded.bytes.begin(), encoded.bytes.begin() + static_cast<std::ptrdiff_t>(encoded.size)};
}

Packets decode(HerkulexDecoder & decoder, const Bytes & bytes)
{
  Packets packets;
  decoder.feed(bytes.data(), bytes.size(), [&](const auto & packet) { packets.push_back(packet); });
  return packets;
}

// Packets of the maker's manual, as bytes, and what each says.
struct Example
{
  const char * meaning;
  const char * wire;
  int id;
  int command;
  const char * payload;
};

constexpr Example kManual[] = {
  {"read the LED", "FF FF 09 FD 04 C4 3A 35 01", 0xFD, 4, "35 01"},
  {"its reply", "FF FF 0C FD 44 C2 3C 35 01 01 00 42", 0xFD, 0x44, "35 01 01 00 42"},
  {"torque on", "FF FF 0A FD 03 A0 5E 34 01 60", 0xFD, 3, "34 01 60"},
  {"clear the errors", "FF FF 0B FD 03 C6 38 30 02 00 00", 0xFD, 3, "30 02 00 00"},
  {"read the position", "FF FF 09 FD 04 C8 36 3A 02", 0xFD, 4, "3A 02"},
  {"its reply", "FF FF 0D FD 44 B2 4C 3A 02 1F 62 00 42", 0xFD, 0x44, "3A 02 1F 62 00 42"},
  {"jog to 512", "FF FF 0C FD 05 32 CC 00 02 04 FD 3C", 0xFD, 5, "00 02 04 FD 3C"},
  {"reboot", "FF FF 07 FD 09 F2 0C", 0xFD, 9, ""},
  {"status of all", "FF FF 07 FE 07 FE 00", 0xFE, 7, ""},
};

TEST(HerkulexPacket, DecodesAndEncodesTheExamplesOfTheManual)
{
  for (const Example & example : kManual) {
    HerkulexDecoder decoder;
    const Packets packets = decode(decoder, from_hex(example.wire));
    ASSERT_EQ(packets.size(), 1U) << example.meaning;
    const HerkulexPacket & packet = packets.front();
    EXPECT_EQ(packet.id(), example.id) << example.meaning;
    EXPECT_EQ(packet.command(), example.command) << example.meaning;
    const Bytes payload{packet.payload(), packet.payload() + packet.size()};
    EXPECT_EQ(payload, from_hex(example.payload)) << example.meaning;
    EXPECT_EQ(on_wire(packet), from_hex(example.wire)) << example.meaning;
    EXPECT_EQ(decoder.dropped_bytes(), 0U) << example.meaning;
  }
}

TEST(HerkulexPacket, KeepsWordsLittleEndian)
{
  HerkulexPacket packet{1, HerkulexCommand::kIJog};
  packet.append_word(0x621F);
  EXPECT_EQ(packet[0], 0x1F);
  EXPECT_EQ(packet[1], 0x62);
  EXPECT_EQ(packet.word(0), 0x621F);
}

// Noise that the decoder has to see through: half of it marks, small sizes and ids.
Bytes noise(std::mt19937 & random, std::size_t most)
{
  Bytes bytes(random() % (most + 1));
  for (auto & byte : bytes) {
    byte = static_cast<std::uint8_t>(random() % 2 == 0 ? 0xFF : random() % 16);
  }
  return bytes;
}

HerkulexPacket random_packet(std::mt19937 & random)
{
  HerkulexPacket packet{
    static_cast<std::uint8_t>(random() % 0xFF), static_cast<std::uint8_t>(random())};
  for (std::size_t left = random() % 217; left > 0; --left) {
    packet.append(static_cast<std::uint8_t>(random() % 3 == 0 ? 0xFF : random()));
  }
  return packet;
}

// Property: what is decoded does not depend on how the stream was cut.
TEST(HerkulexPacket, AnySplitOfAStreamGivesTheSamePackets)
{
  std::mt19937 random{20260401};
  for (int round = 0; round < 200; ++round) {
    Bytes stream;
    for (int i = 0; i < 5; ++i) {
      const Bytes before = noise(random, 20);
      stream.insert(stream.end(), before.begin(), before.end());
      const Bytes packet = on_wire(random_packet(random));
      stream.insert(stream.end(), packet.begin(), packet.end());
    }
    HerkulexDecoder whole;
    const Packets expected = decode(whole, stream);
    HerkulexDecoder cut;
    Packets packets;
    for (std::size_t at = 0; at < stream.size();) {
      const std::size_t count = std::min<std::size_t>(1 + random() % 40, stream.size() - at);
      const Bytes piece{
        stream.begin() + static_cast<std::ptrdiff_t>(at),
        stream.begin() + static_cast<std::ptrdiff_t>(at + count)};
      const Packets more = decode(cut, piece);
      packets.insert(packets.end(), more.begin(), more.end());
      at += count;
    }
    EXPECT_EQ(packets, expected) << "round " << round;
    EXPECT_EQ(cut.dropped_bytes(), whole.dropped_bytes()) << "round " << round;
  }
}

TEST(HerkulexPacket, EveryPacketSurvivesItsWire)
{
  std::mt19937 random{20260402};
  HerkulexDecoder decoder;
  for (int round = 0; round < 2000; ++round) {
    const HerkulexPacket packet = random_packet(random);
    EXPECT_EQ(decode(decoder, on_wire(packet)), Packets{packet}) << "round " << round;
  }
  EXPECT_EQ(decoder.dropped_bytes(), 0U);
}

TEST(HerkulexPacket, FindsAPacketInsideAFalseStart)
{
  // A header that promises 32 bytes, and whole packets among them.
  Bytes stream = from_hex("FF FF 20 01 44 00 00");
  const Bytes stat = from_hex("FF FF 07 FE 07 FE 00");
  for (int i = 0; i < 4; ++i) {
    stream.insert(stream.end(), stat.begin(), stat.end());
  }
  HerkulexDecoder decoder;
  const Packets packets = decode(decoder, stream);
  ASSERT_EQ(packets.size(), 4U);
  EXPECT_EQ(decoder.bad_checksums(), 1U);
  EXPECT_EQ(decoder.dropped_bytes(), 7U);
}

TEST(HerkulexPacket, RefusesEveryFlippedBit)
{
  const Bytes good = from_hex("FF FF 0D FD 44 B2 4C 3A 02 1F 62 00 42");
  for (std::size_t bit = 0; bit < 8 * good.size(); ++bit) {
    Bytes bad = good;
    bad[bit / 8] = static_cast<std::uint8_t>(bad[bit / 8] ^ (1 << (bit % 8)));
    HerkulexDecoder decoder;
    for (const HerkulexPacket & packet : decode(decoder, bad)) {
      // The checksums mask bit 0: a flip there is seen in them only, and passes in the rest.
      EXPECT_EQ(bit % 8, 0U) << "bit " << bit << " of command " << int{packet.command()};
    }
  }
}

TEST(HerkulexPacket, GoesOnAfterAPacketThatLostAByte)
{
  Bytes stream = from_hex("FF FF 0C FD 44 C2 35 01 01 00 42");  // the second checksum is missing
  const Bytes next = from_hex("FF FF 0C FD 44 C2 3C 35 01 01 00 42");
  stream.insert(stream.end(), next.begin(), next.end());
  HerkulexDecoder decoder;
  EXPECT_EQ(decode(decoder, stream).size(), 1U);
}

}  // namespace
}  // namespace stetro_driver::linux_io
