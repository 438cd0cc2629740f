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

#ifndef NODE__FLOOR_TOPICS_HPP_
#define NODE__FLOOR_TOPICS_HPP_

#include <cstdint>
#include <memory>
#include <string>

#include "convert_floor.hpp"
#include "stamp_guard.hpp"
#include "stetro_dds/diagnostics.hpp"
#include "stetro_dds/node.hpp"
#include "stetro_dds/stamp.hpp"
#include "stetro_site/site.hpp"

namespace stetro_supervisor
{

/// The topics of the second opinion: hears `scan`, tells `profile_check` and `pose_correction`.
/** Made only where a floor is drawn: elsewhere nobody could say anything. Its node's thread. */
class FloorTopics
{
public:
  /// \param site outlives it \param scan where the last one is kept; outlives it
  FloorTopics(
    stetro_dds::Node & node, const stetro_site::Site & site, Time future_tolerance,
    std::shared_ptr<const Scan> & scan);

  void tell(const CheckReport & report);

  void report(stetro_dds::DiagnosticReport & report) const;

private:
  stetro_dds::Node & node_;
  const stetro_site::Site & site_;
  StampGuard stamps_;
  std::uint64_t checks_ = 0;
  std::uint64_t corrections_ = 0;
  std::string last_ = "none";  // verdict, in words
  stetro_dds::Publisher<stetro_msgs::msg::ProfileCheck> & check_;
  stetro_dds::Publisher<stetro_msgs::msg::PoseCorrection> & correction_;
};

}  // namespace stetro_supervisor

#endif  // NODE__FLOOR_TOPICS_HPP_
