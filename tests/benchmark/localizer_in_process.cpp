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

#include "benchmark/localizer_in_process.hpp"

#include <thread>

#include "stetro_dds/executor.hpp"
#include "stetro_localizer/localizer_node.hpp"
#include "stetro_tests/stack.hpp"

namespace bench
{

namespace
{

stetro_dds::ContextOptions in_domain(std::uint32_t domain_id)
{
  stetro_dds::ContextOptions options;
  options.domain_id = domain_id;
  return options;
}

stetro_dds::NodeOptions named_localizer()
{
  stetro_dds::NodeOptions options;
  options.name = "localizer";
  options.ns = "/stetro";
  return options;
}

stetro_localizer::LocalizerParams shipped_params()
{
  stetro_localizer::LocalizerParams params;
  params.site_file = stetro_tests::papers_staircase();
  params.robot_file = stetro_tests::papers_robot();
  return params;
}

}  // namespace

struct LocalizerInProcess::Parts
{
  explicit Parts(std::uint32_t domain_id)
  : context(in_domain(domain_id)), node(context, named_localizer(), shipped_params())
  {
    executor.add(node.node());
    spinning = std::thread([this] { executor.spin(); });
  }

  ~Parts()
  {
    executor.stop();
    spinning.join();
  }

  stetro_dds::Context context;
  stetro_localizer::LocalizerNode node;
  stetro_dds::Executor executor;
  std::thread spinning;
};

LocalizerInProcess::LocalizerInProcess(std::uint32_t domain_id)
: parts_(std::make_unique<Parts>(domain_id))
{
}

LocalizerInProcess::~LocalizerInProcess() = default;

}  // namespace bench
