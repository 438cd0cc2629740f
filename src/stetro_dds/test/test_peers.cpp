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

#include <gtest/gtest.h>

#include <string>

#include "peers.hpp"

namespace stetro_dds
{
namespace
{

using Role = PeerEndpoint::Role;

PeerEndpoint endpoint(Role role)
{
  PeerEndpoint result;
  result.role = role;
  result.type_name = "a::msg::dds_::B_";
  result.dds_topic = "rt/b";
  return result;
}

/// The word before the colon: which policy is to blame.
std::string blame(const PeerEndpoint & writer, const PeerEndpoint & reader)
{
  const auto why = mismatch(writer, reader);
  return why ? why->substr(0, why->find(':')) : "";
}

TEST(Mismatch, IsNoneBetweenTheLikesOfUs)
{
  EXPECT_FALSE(mismatch(endpoint(Role::kWriter), endpoint(Role::kReader)));
}

TEST(Mismatch, NamesThePolicyToBlame)
{
  const auto writer = endpoint(Role::kWriter);
  const auto reader = endpoint(Role::kReader);
  const auto changed = [](PeerEndpoint peer, auto change) {
    change(peer);
    return peer;
  };
  const auto best_effort =
    changed(writer, [](auto & p) { p.reliability = Reliability::kBestEffort; });
  EXPECT_EQ(blame(best_effort, reader), "reliability");
  const auto latched =
    changed(reader, [](auto & p) { p.durability = Durability::kTransientLocal; });
  EXPECT_EQ(blame(writer, latched), "durability");
  EXPECT_EQ(blame(writer, changed(reader, [](auto & p) { p.deadline = true; })), "deadline");
  EXPECT_EQ(blame(writer, changed(reader, [](auto & p) { p.liveliness = true; })), "liveliness");
  EXPECT_EQ(blame(changed(writer, [](auto & p) { p.exclusive = true; }), reader), "ownership");
  EXPECT_EQ(blame(changed(writer, [](auto & p) { p.partitioned = true; }), reader), "partition");
}

TEST(Mismatch, SeesWhatTheMiddlewareKeepsToItself)
{
  auto writer = endpoint(Role::kWriter);
  writer.keyed = true;
  EXPECT_EQ(blame(writer, endpoint(Role::kReader)), "key");
  writer.type_name = "a::msg::dds_::C_";
  EXPECT_EQ(blame(writer, endpoint(Role::kReader)), "type");
}

TEST(Peers, AreRememberedByTopicAndRoleUntilTheyLeave)
{
  Peers peers;
  auto writer = endpoint(Role::kWriter);
  writer.guid[0] = 1;
  peers.add(writer);
  EXPECT_EQ(peers.on("rt/b", Role::kWriter).size(), 1U);
  EXPECT_TRUE(peers.on("rt/b", Role::kReader).empty());
  EXPECT_TRUE(peers.on("rt/c", Role::kWriter).empty());
  const auto before = peers.revision();
  peers.remove(writer.guid);
  EXPECT_GT(peers.revision(), before);
  EXPECT_TRUE(peers.on("rt/b", Role::kWriter).empty());
}

TEST(GuidText, ShowsPrefixAndEntity)
{
  Guid guid{};
  guid[0] = 1;
  guid[1] = 15;
  guid[15] = 3;
  EXPECT_EQ(to_string(guid), "010f0000.00000000.00000000|00000003");
}

}  // namespace
}  // namespace stetro_dds
