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

#include <algorithm>
#include <random>
#include <string>
#include <vector>

#include "linux/imu/vn100_stream.hpp"

namespace stetro_driver::linux_io
{
namespace
{

using Bytes = std::vector<std::uint8_t>;

/// What a frame says, to compare it.
std::string words_of(const Vn100Frame & frame)
{
  if (const auto * sentence = std::get_if<AsciiSentence>(&frame)) {
    std::string words(sentence->type);
    for (std::size_t i = 0; i < sentence->count; ++i) {
      words += "," + std::string(sentence->fields[i]);
    }
    return words;
  }
  const auto uptime = std::get<BinaryPacket>(frame).uptime;
  return uptime ? std::to_string(uptime->count()) : "a packet";
}

/// Fed in portions of a given greatest size, or of random ones.
std::vector<std::string> frames_in(
  const Bytes & bytes, std::size_t portion, Vn100Stream & stream, std::mt19937 * random = nullptr)
{
  std::vector<std::string> frames;
  for (std::size_t at = 0; at < bytes.size();) {
    std::size_t size = std::min(portion, bytes.size() - at);
    if (random) {
      size = std::uniform_int_distribution<std::size_t>{1, size}(*random);
    }
    stream.feed(bytes.data() + at, size, [&](const Vn100Frame & frame, std::size_t) {
      frames.push_back(words_of(frame));
    });
    at += size;
  }
  return frames;
}

void append(Bytes & to, const std::string & text) { to.insert(to.end(), text.begin(), text.end()); }
void append(Bytes & to, const Bytes & more) { to.insert(to.end(), more.begin(), more.end()); }

Bytes packet(std::int64_t number)
{
  return to_binary({{}, {0.0, 0.0, 0.1}, {0.0, 0.0, -9.8}, Time{number}});
}

TEST(Vn100Stream, FindsSentencesAmongPackets)
{
  Bytes bytes = packet(1);
  append(bytes, "$VNWRG,06,0*6C\r\n");
  append(bytes, packet(2));
  Vn100Stream stream;
  EXPECT_EQ(
    frames_in(bytes, bytes.size(), stream), (std::vector<std::string>{"1", "WRG,06,0", "2"}));
  EXPECT_EQ(stream.counts().frames, 3u);
  EXPECT_EQ(stream.counts().lost_bytes, 0u);
}

TEST(Vn100Stream, SaysHowManyBytesCameSinceAFrameBegan)
{
  Bytes bytes = packet(1);
  append(bytes, packet(2));
  append(bytes, Bytes(7, 0));
  std::vector<std::size_t> ages;
  Vn100Stream stream;
  stream.feed(
    bytes.data(), bytes.size(), [&](const Vn100Frame &, std::size_t age) { ages.push_back(age); });
  EXPECT_EQ(ages, (std::vector<std::size_t>{115, 61}));
}

TEST(Vn100Stream, AFrameThatBeginsInsideABrokenOneIsFound)
{
  Bytes bytes = packet(1);
  bytes.resize(20);  // the rest was lost
  append(bytes, packet(2));
  append(bytes, "$VNYMR,+100.9");
  append(bytes, "$VNRRG,5*46\r\n");
  append(bytes, packet(3));
  Vn100Stream stream;
  EXPECT_EQ(frames_in(bytes, 5, stream), (std::vector<std::string>{"2", "RRG,5", "3"}));
  EXPECT_EQ(stream.counts().lost_bytes, 20u + 13u);
  EXPECT_EQ(stream.counts().bad_checksums, 1u);
}

TEST(Vn100Stream, JoinsInTheMiddleOfALine)
{
  Bytes bytes;
  append(bytes, "-00.000018,+00.001122,-00.000551*69\r\n$VNRRG,5*46\r\n");
  Vn100Stream stream;
  EXPECT_EQ(frames_in(bytes, 100, stream), std::vector<std::string>{"RRG,5"});
}

/// Packets and sentences, some of them hurt, with noise between that is rich in false starts.
Bytes random_traffic(std::mt19937 & random)
{
  std::uniform_int_distribution<int> byte{0, 255};
  std::uniform_int_distribution<int> chance{0, 9};
  Bytes bytes;
  for (int i = 0; i < 40; ++i) {
    Bytes next;
    if (chance(random) < 5) {
      next = packet(byte(random));
    } else {
      append(next, to_ascii("VNRRG,08," + std::to_string(byte(random))));
    }
    if (chance(random) < 3) {
      std::uint8_t & hurt = next[static_cast<std::size_t>(byte(random)) % next.size()];
      hurt = static_cast<std::uint8_t>(hurt ^ (1 << (byte(random) % 8)));
    }
    if (chance(random) < 2) {
      next.erase(next.begin() + byte(random) % static_cast<int>(next.size()));
    }
    append(bytes, next);
    if (chance(random) < 4) {
      const std::uint8_t start[] = {0xFA, '$', 0x01, 'V', 'N', 0x31};
      for (int n = byte(random) % 30; n > 0; --n) {
        bytes.push_back(
          chance(random) < 5 ? start[byte(random) % 6] : static_cast<std::uint8_t>(byte(random)));
      }
    }
  }
  append(bytes, Bytes(kLongestVn100Frame, 0));  // what was begun is decided
  return bytes;
}

// Property: any split of the bytes gives the same frames and the same counts.
TEST(Vn100Stream, AnySplitGivesTheSameFrames)
{
  std::mt19937 random{20260313};
  for (int round = 0; round < 100; ++round) {
    const Bytes bytes = random_traffic(random);
    Vn100Stream whole;
    const auto expected = frames_in(bytes, bytes.size(), whole);
    EXPECT_GT(expected.size(), 5u);
    for (const std::size_t portion : {1u, 2u, 7u, 53u, 300u}) {
      Vn100Stream stream;
      EXPECT_EQ(frames_in(bytes, portion, stream), expected) << round << ", by " << portion;
      EXPECT_EQ(stream.counts().lost_bytes, whole.counts().lost_bytes);
      EXPECT_EQ(stream.counts().bad_checksums, whole.counts().bad_checksums);
    }
    Vn100Stream stream;
    EXPECT_EQ(frames_in(bytes, 200, stream, &random), expected) << round << ", at random";
  }
}

}  // namespace
}  // namespace stetro_driver::linux_io
