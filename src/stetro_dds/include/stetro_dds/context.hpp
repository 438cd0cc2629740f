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

#ifndef STETRO_DDS__CONTEXT_HPP_
#define STETRO_DDS__CONTEXT_HPP_

#include <chrono>
#include <cstdint>
#include <functional>
#include <memory>
#include <string>
#include <vector>

namespace stetro_dds
{

class Participant;

/// Who may be talked to.
enum class NetworkScope {
  kLocalhost,  ///< this computer only; no packet leaves it
  kSubnet      ///< every interface, multicast discovery, and the static peers
};

/// Which ROS 2 shares the domain: it decides the GID size and the style of localhost discovery.
/**
 * kHumble: 24-byte GIDs, sockets bound to 127.0.0.1. kIron and kJazzy: 16-byte GIDs, unicast
 * discovery towards 127.0.0.1 but sockets on every interface, because that is how these
 * distributions do it and the two styles do not find each other. All participants of a domain
 * must use one value.
 */
enum class RosDistro { kHumble, kIron, kJazzy };

struct ContextOptions
{
  std::uint32_t domain_id = 0;  ///< 0..101 are free of the ephemeral ports
  NetworkScope scope = NetworkScope::kLocalhost;
  RosDistro distro = RosDistro::kHumble;
  std::vector<std::string> static_peers{};  ///< IPv4 addresses, used with kSubnet
  bool intra_process = true;  ///< endpoints of one process exchange samples without the network

  /// What ROS_DOMAIN_ID, ROS_DISTRO and the three variables of ROS 2 discovery say.
  /**
   * Those are ROS_LOCALHOST_ONLY, ROS_AUTOMATIC_DISCOVERY_RANGE and ROS_STATIC_PEERS; without
   * them the scope is kLocalhost: the wider one is asked for, never assumed.
   * \throws stetro_config::ConfigError naming the variable, its value and what is accepted
   */
  static ContextOptions from_environment();
};

/// One participant in one DDS domain. A process has one, shared by its nodes.
/**
 * Every quality of service is built in code: profile files and the environment variables of the
 * DDS implementation are ignored with a warning, because a broken one would open all interfaces.
 *
 * Its threads take no signals. Destroy it after its nodes.
 */
class Context
{
public:
  /// \throws std::runtime_error if the domain id is out of range or no participant can be created
  explicit Context(const ContextOptions & options = ContextOptions::from_environment());
  ~Context();
  Context(const Context &) = delete;
  Context & operator=(const Context &) = delete;

  [[nodiscard]] const ContextOptions & options() const { return options_; }

  /// Blocks until `condition` holds, looking again whenever an endpoint gains or loses a peer.
  /** \return whether it held before the time was up */
  bool wait_for(const std::function<bool()> & condition, std::chrono::nanoseconds timeout) const;

  /// The middleware side, for this package's own use.
  [[nodiscard]] Participant & participant() { return *participant_; }

private:
  ContextOptions options_;
  std::unique_ptr<Participant> participant_;
};

}  // namespace stetro_dds

#endif  // STETRO_DDS__CONTEXT_HPP_
