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

// A text is a reading exactly if the kernel would print it: the number back and a newline.

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <unordered_set>

#include "linux/tof/vl53l0x_reading.hpp"
#include "require.hpp"

namespace
{

/// Whether the kernel would print this: one of 8192 texts.
bool printed(std::string_view text)
{
  static const std::unordered_set<std::string> kAll = [] {
    std::unordered_set<std::string> all;
    for (int number = 0; number <= 8191; ++number) {
      all.insert(std::to_string(number) + "\n");
    }
    return all;
  }();
  return kAll.count(std::string(text)) != 0;
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t * input, std::size_t size)
{
  const std::string_view text{reinterpret_cast<const char *>(input), size};
  const auto parsed = stetro_driver::linux_io::parse_millimetres(text);
  const bool back = parsed && std::to_string(*parsed) + "\n" == text;
  require(parsed.has_value() == printed(text));
  require(back == parsed.has_value());
  return 0;
}
