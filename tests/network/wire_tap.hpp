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

#ifndef TESTS__NETWORK__WIRE_TAP_HPP_
#define TESTS__NETWORK__WIRE_TAP_HPP_

#include <string>
#include <vector>

namespace stetro_tests
{

/// An interface to a cable that ends in nothing, and a tap on it.
/**
 * For a network namespace of our own: a pair of virtual Ethernet devices, both up, the near one with
 * an address and the multicast route, as a robot's network card has. Whatever a process sends to
 * the outside passes it.
 */
class WireTap
{
public:
  /// \throws std::runtime_error saying what is not allowed or missing here
  WireTap();
  ~WireTap();
  WireTap(const WireTap &) = delete;
  WireTap & operator=(const WireTap &) = delete;

  /// The IPv4 packets that have left since the last call, as "udp 10.90.0.1 > 239.255.0.1:7400".
  std::vector<std::string> packets();

private:
  int socket_ = -1;
};

}  // namespace stetro_tests

#endif  // TESTS__NETWORK__WIRE_TAP_HPP_
