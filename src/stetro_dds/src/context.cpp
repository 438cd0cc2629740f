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

#include "stetro_dds/context.hpp"

#include <arpa/inet.h>
#include <spdlog/spdlog.h>

#include <array>
#include <cerrno>
#include <cstdlib>
#include <functional>
#include <memory>
#include <optional>
#include <sstream>
#include <string>
#include <string_view>
#include <vector>

#include "participant.hpp"
#include "stetro_config/fault.hpp"

namespace stetro_dds
{

namespace
{

/// A set and non-empty variable: ROS 2 takes empty for unset.
std::optional<std::string> variable(const char * name)
{
  const char * value = std::getenv(name);
  return value != nullptr && *value != '\0' ? std::optional<std::string>{value} : std::nullopt;
}

[[noreturn]] void refuse(
  const std::string & name, const std::string & value, const std::string & accepted)
{
  throw stetro_config::ConfigError({{"environment", 0, name, value, accepted}});
}

std::uint32_t domain_id()
{
  const auto text = variable("ROS_DOMAIN_ID");
  if (!text) {
    return 0;
  }
  char * end = nullptr;
  errno = 0;
  const auto id = std::strtoul(text->c_str(), &end, 0);
  if (*end != '\0' || errno != 0 || id > 232 || text->find('-') != std::string::npos) {
    refuse("ROS_DOMAIN_ID", *text, "0 to 232");
  }
  return static_cast<std::uint32_t>(id);
}

/// Distributions after those known have kept Iron's layout.
RosDistro distro()
{
  const std::string name = variable("ROS_DISTRO").value_or("humble");
  if (name == "humble" || name == "galactic" || name == "foxy") {
    return RosDistro::kHumble;
  }
  return name == "iron" ? RosDistro::kIron : RosDistro::kJazzy;
}

NetworkScope scope()
{
  if (variable("ROS_LOCALHOST_ONLY").value_or("0") == "1") {
    return NetworkScope::kLocalhost;
  }
  const std::string range = variable("ROS_AUTOMATIC_DISCOVERY_RANGE").value_or("LOCALHOST");
  if (range == "SUBNET") {
    return NetworkScope::kSubnet;
  }
  if (range != "LOCALHOST" && range != "SYSTEM_DEFAULT") {
    refuse("ROS_AUTOMATIC_DISCOVERY_RANGE", range, "SUBNET, LOCALHOST or SYSTEM_DEFAULT");
  }
  return NetworkScope::kLocalhost;
}

std::vector<std::string> static_peers(NetworkScope scope)
{
  const std::string text = variable("ROS_STATIC_PEERS").value_or("");
  std::vector<std::string> peers;
  std::istringstream words(text);
  for (std::string peer; std::getline(words, peer, ';');) {
    in_addr address{};
    if (::inet_pton(AF_INET, peer.c_str(), &address) != 1) {
      refuse("ROS_STATIC_PEERS", text, "IPv4 addresses separated by semicolons");
    }
    peers.push_back(peer);
  }
  if (!peers.empty() && scope == NetworkScope::kLocalhost) {
    refuse("ROS_STATIC_PEERS", text, "nothing unless ROS_AUTOMATIC_DISCOVERY_RANGE is SUBNET");
  }
  return peers;
}

std::string_view name_of(RosDistro distro)
{
  constexpr std::array<std::string_view, 3> kNames{"humble", "iron", "jazzy"};
  return kNames.at(static_cast<std::size_t>(distro));
}

}  // namespace

ContextOptions ContextOptions::from_environment()
{
  ContextOptions options;
  options.domain_id = stetro_dds::domain_id();
  options.distro = stetro_dds::distro();
  options.scope = stetro_dds::scope();
  options.static_peers = stetro_dds::static_peers(options.scope);
  return options;
}

namespace
{

// Later distributions look for peers on this computer but listen on every interface.
const char * reach_of(const ContextOptions & options)
{
  if (options.scope == NetworkScope::kSubnet) {
    return "the subnet";
  }
  return options.distro == RosDistro::kHumble
           ? "this computer only"
           : "peers of this computer, open to others as its ROS 2 is";
}

}  // namespace

Context::Context(const ContextOptions & options)
: options_(options), participant_(std::make_unique<Participant>(options_))
{
  spdlog::info(
    "domain {}, {}, ROS 2 {}", options_.domain_id, reach_of(options_), name_of(options_.distro));
}

Context::~Context() = default;

bool Context::wait_for(
  const std::function<bool()> & condition, std::chrono::nanoseconds timeout) const
{
  return participant_->wait_for(condition, timeout);
}

}  // namespace stetro_dds
