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

// Any bytes, cut anywhere, give the same frames and the same counts.
// The first byte of the input says how the stream is cut.

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "linux/imu/vn100_stream.hpp"
#include "require.hpp"

namespace
{

using stetro_driver::linux_io::AsciiSentence;
using stetro_driver::linux_io::BinaryPacket;
using stetro_driver::linux_io::Vn100Frame;
using stetro_driver::linux_io::Vn100Stream;

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

std::vector<std::string> frames_in(
  const std::uint8_t * bytes, std::size_t size, std::size_t cut, Vn100Stream & stream)
{
  std::vector<std::string> frames;
  for (std::size_t at = 0; at < size; at += cut) {
    stream.feed(
      bytes + at, std::min(cut, size - at), [&](const Vn100Frame & frame, std::size_t age) {
        require(age > 0);
        frames.push_back(words_of(frame));
      });
  }
  return frames;
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t * input, std::size_t size)
{
  if (size < 2) {
    return 0;
  }
  Vn100Stream whole;
  Vn100Stream cut;
  const auto expected = frames_in(input + 1, size - 1, size, whole);
  require(frames_in(input + 1, size - 1, 1U + input[0], cut) == expected);
  require(cut.counts().frames == whole.counts().frames);
  require(cut.counts().lost_bytes == whole.counts().lost_bytes);
  require(cut.counts().bad_checksums == whole.counts().bad_checksums);
  return 0;
}
