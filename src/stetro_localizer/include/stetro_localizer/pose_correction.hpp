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

#ifndef STETRO_LOCALIZER__POSE_CORRECTION_HPP_
#define STETRO_LOCALIZER__POSE_CORRECTION_HPP_

#include <cstdint>
#include <string>

#include "stetro_localizer/samples.hpp"
#include "stetro_site/frame_transform.hpp"
#include "stetro_site/pose.hpp"

namespace stetro_localizer
{

/// A pose on a floor that was found by another road than the localizer's.
struct PoseCorrection
{
  Nanoseconds stamp{0};    ///< of the scan that it was found in
  std::string floor_id;    ///< also the frame of the pose
  stetro_site::Pose pose;  ///< base_link in the floor's frame
  stetro_site::Covariance covariance = stetro_site::Covariance::Zero();
  std::uint32_t reset_counter = 0;  ///< of the estimate that it was compared with
};

}  // namespace stetro_localizer

#endif  // STETRO_LOCALIZER__POSE_CORRECTION_HPP_
