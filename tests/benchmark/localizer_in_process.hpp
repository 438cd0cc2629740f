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

#ifndef TESTS__BENCHMARK__LOCALIZER_IN_PROCESS_HPP_
#define TESTS__BENCHMARK__LOCALIZER_IN_PROCESS_HPP_

#include <cstdint>
#include <memory>

namespace bench
{

/// The real localizer node and its executor's thread, in this process, with its shipped parameters.
class LocalizerInProcess
{
public:
  explicit LocalizerInProcess(std::uint32_t domain_id);
  ~LocalizerInProcess();
  LocalizerInProcess(const LocalizerInProcess &) = delete;
  LocalizerInProcess & operator=(const LocalizerInProcess &) = delete;

private:
  struct Parts;
  std::unique_ptr<Parts> parts_;
};

}  // namespace bench

#endif  // TESTS__BENCHMARK__LOCALIZER_IN_PROCESS_HPP_
