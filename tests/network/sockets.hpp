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

#ifndef TESTS__NETWORK__SOCKETS_HPP_
#define TESTS__NETWORK__SOCKETS_HPP_

#include <sys/types.h>

#include <string>
#include <vector>

namespace stetro_tests
{

/// A socket of a process, as the kernel lists it.
struct OpenSocket
{
  std::string protocol;  ///< udp, udp6, tcp, tcp6, raw, raw6 or packet
  std::string address;   ///< what it is bound to, such as 127.0.0.1; hexadecimal for IPv6
  int port;
};

/// Every internet or packet socket that the process holds open.
std::vector<OpenSocket> sockets_of(pid_t pid);

}  // namespace stetro_tests

#endif  // TESTS__NETWORK__SOCKETS_HPP_
