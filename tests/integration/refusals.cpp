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

#include "integration/refusals.hpp"

namespace stetro_tests
{

std::int64_t refused_count(
  const diagnostic_msgs::msg::DiagnosticArray & diagnostics, const std::string & node,
  const std::string & topic)
{
  std::int64_t result = -1;
  for (const auto & status : diagnostics.status()) {
    if (status.name().find(node + ":") == std::string::npos) {
      continue;
    }
    for (const auto & pair : status.values()) {
      if (pair.key() == topic + " refused" || pair.key() == topic + " malformed") {
        result = (result < 0 ? 0 : result) + std::stoll(pair.value());
      }
    }
  }
  return result;
}

}  // namespace stetro_tests
