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

// Any bytes, cut anywhere, give the same packets, and every packet survives its own wire.
// The first byte of the input says how the stream is cut.

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "linux/servo/herkulex_packet.hpp"
#include "require.hpp"

namespace
{

using stetro_driver::linux_io::encode;
using stetro_driver::linux_io::HerkulexDecoder;
using stetro_driver::linux_io::HerkulexPacket;

std::vector<HerkulexPacket> decode(const std::uint8_t * bytes, std::size_t size, std::size_t cut)
{
  HerkulexDecoder decoder;
  std::vector<HerkulexPacket> packets;
  for (std::size_t at = 0; at < size; at += cut) {
    decoder.feed(bytes + at, std::min(cut, size - at), [&](const HerkulexPacket & packet) {
      packets.push_back(packet);
    });
  }
  return packets;
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t * input, std::size_t size)
{
  if (size < 2) {
    return 0;
  }
  const std::size_t cut = 1 + input[0];
  const auto whole = decode(input + 1, size - 1, size);
  require(decode(input + 1, size - 1, cut) == whole);
  for (const HerkulexPacket & packet : whole) {
    const auto wire = encode(packet);
    require(decode(wire.bytes.data(), wire.size, 1) == std::vector<HerkulexPacket>{packet});
  }
  return 0;
}
