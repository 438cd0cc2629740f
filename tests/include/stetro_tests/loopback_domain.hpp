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

#ifndef STETRO_TESTS__LOOPBACK_DOMAIN_HPP_
#define STETRO_TESTS__LOOPBACK_DOMAIN_HPP_

#include <cstdint>
#include <string>

#include "stetro_tests/process.hpp"

namespace stetro_tests
{

/// A DDS domain that this process and its children have to themselves.
/**
 * The first one also moves the process into a network namespace of its own, where that is allowed:
 * there only a loopback exists, so whatever a peer binds to (Cyclone DDS binds every address),
 * nothing can leave this computer and nobody else can join. Construct it before any thread.
 *
 * The id is held by a lock on a file, which the kernel drops when the process ends.
 */
class LoopbackDomain
{
public:
  /// \throws std::runtime_error if every id is taken
  LoopbackDomain();
  ~LoopbackDomain();
  LoopbackDomain(const LoopbackDomain &) = delete;
  LoopbackDomain & operator=(const LoopbackDomain &) = delete;

  [[nodiscard]] std::uint32_t id() const { return id_; }

  /// What a child needs in its environment to join.
  [[nodiscard]] Process::Environment environment() const;

private:
  std::uint32_t id_ = 0;
  int lock_ = -1;
};

/// Moves this process into a network namespace with nothing but a loopback, once.
/** \return empty if it is in one, else why not */
std::string enter_network_of_its_own();

}  // namespace stetro_tests

#endif  // STETRO_TESTS__LOOPBACK_DOMAIN_HPP_
