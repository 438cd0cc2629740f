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

#ifndef DEMO__BUILDING_PLAN_HPP_
#define DEMO__BUILDING_PLAN_HPP_

#include <iosfwd>
#include <optional>

#include "stetro_bringup/trace.hpp"
#include "stetro_site/pose.hpp"
#include "stetro_site/site.hpp"

namespace stetro_bringup
{

/// Lines of floors' walls and flights' treads in `map`, an empty line between two.
void write_walls(std::ostream & out, const stetro_site::Site & site);

/// The way through a building in `map`, a row an estimate.
class PathWriter
{
public:
  /// \param out stays the caller's and must outlive the writer
  explicit PathWriter(std::ostream & out);
  void write(
    const TraceRow & row, const std::optional<stetro_site::Pose> & estimate,
    const std::optional<stetro_site::Pose> & truth);

private:
  std::ostream & out_;
};

}  // namespace stetro_bringup

#endif  // DEMO__BUILDING_PLAN_HPP_
