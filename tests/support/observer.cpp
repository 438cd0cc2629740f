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

#include "stetro_tests/observer.hpp"

#include "stetro_tests/deadline.hpp"

namespace stetro_tests
{

stetro_dds::ContextOptions context_options(const LoopbackDomain & domain)
{
  stetro_dds::ContextOptions options;
  options.domain_id = domain.id();
  return options;
}

Observer::Observer(const LoopbackDomain & domain, std::string name)
: context_(context_options(domain)), node_(context_, node_options(std::move(name)))
{
}

Observer::~Observer()
{
  executor_.stop();
  if (spinning_.joinable()) {
    spinning_.join();
  }
}

stetro_dds::NodeOptions Observer::node_options(std::string name)
{
  stetro_dds::NodeOptions options;
  options.name = std::move(name);
  options.ns = "/stetro";
  return options;
}

void Observer::start()
{
  executor_.add(node_);
  spinning_ = std::thread([this] { executor_.spin(); });
}

std::vector<std::string> Observer::wait_matched(std::chrono::nanoseconds limit)
{
  node_.wait_matched({}, Deadline(limit).remaining());
  return node_.unmatched();
}

}  // namespace stetro_tests
