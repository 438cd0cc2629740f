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

#include "accuracy/moment.hpp"

#include <string>
#include <vector>

#include "accuracy/closed_loop.hpp"

namespace stetro_bringup
{
namespace
{

using stetro_localizer::Source;

std::vector<Source> side_and_front_sources()
{
  std::vector<Source> sources;
  for (std::size_t i = 0; i < stetro_localizer::kSourceCount; ++i) {
    const std::string name = stetro_localizer::to_string(static_cast<Source>(i));
    if (name.rfind("side_", 0) == 0 || name.rfind("front_", 0) == 0) {
      sources.push_back(static_cast<Source>(i));
    }
  }
  return sources;
}

}  // namespace

Moment moment_of(const ClosedLoop & loop, std::size_t estimator)
{
  Moment now;
  now.time = loop.time();
  now.elapsed_s = loop.elapsed_s();
  now.accepted = loop.accepted();
  now.state = loop.climb().state();
  now.truth = loop.truth();
  now.estimate = loop.estimator(estimator).estimate();
  now.refreshed = loop.refreshed(estimator);
  if (now.refreshed) {
    now.in_sight = in_sight_of(loop.estimator(estimator).reports());
    now.truth_at_stamp = loop.truths().at(now.estimate.stamp);
  }
  return now;
}

std::uint32_t in_sight_of(const stetro_localizer::SourceReports & reports)
{
  static const std::vector<Source> kSources = side_and_front_sources();
  std::uint32_t in_sight = 0;
  for (const Source source : kSources) {
    in_sight = in_sight << 1U | (stetro_localizer::saw_target(reports[source].outcome) ? 1U : 0U);
  }
  return in_sight;
}

}  // namespace stetro_bringup
