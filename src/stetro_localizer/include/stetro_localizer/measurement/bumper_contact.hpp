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

#ifndef STETRO_LOCALIZER__MEASUREMENT__BUMPER_CONTACT_HPP_
#define STETRO_LOCALIZER__MEASUREMENT__BUMPER_CONTACT_HPP_

#include <array>
#include <optional>

#include "stetro_localizer/measurement/side_range.hpp"

namespace stetro_localizer
{

/// Where the bumpers are, and how exactly they close.
struct BumperParams
{
  double contact_width_m = 0.23;  ///< R_w over the bumpers, not the body's 0.20 m (D1-1) [m]
  std::array<double, 3> block_x_m{0.15, 0.0, -0.15};  ///< block centres in `base_link` [m]
  double block_length_m = 0.15;                       ///< a bumper spans its block [m]
  double sigma_m = 0.001;                             ///< closing distance of a bumper [m]
};

/// y of `base_link` at a contact.
struct ContactFix
{
  double y_m;          ///< distance from the right wall [m]
  double variance_m2;  ///< from the bumper and the heading [m^2]
  double lever_m;      ///< lever arm |l| of the bumper's touching end [m]
};

/// What a closed bumper says of y: an absolute reference, for it needs no range.
/**
 * The robot's centre is then at (R_w/2) cos psi + |l| sin |psi| from that wall, with the lever arm
 * |l| of the bumper end that touches (D1-2, D1-4). With the front bumper closed and the rear one
 * open that is the foremost end, the other way round the rearmost; otherwise the end that the
 * heading leans towards the wall. 22.5 cm of lever arm are 3.9 mm for each degree. With both ends
 * closed the robot is square to the wall whatever the heading was believed to be: y is R_w/2, and
 * the doubt is the bumpers' alone, sigma^2 for the distance and half of it for the squareness.
 * Immutable after construction.
 */
class BumperContact
{
public:
  /// \throws std::invalid_argument naming the field
  explicit BumperContact(const BumperParams & params);

  /// \param closed the three bumpers of that side, front to rear
  /// \param width_m distance W between the side walls here [m]
  /// \return nothing if none of them is closed
  [[nodiscard]] std::optional<ContactFix> fix(
    Side side, const std::array<bool, 3> & closed, double yaw_rad, double yaw_variance,
    double width_m) const;

private:
  // x of the bumper end that touches, in base_link.
  [[nodiscard]] std::optional<double> touching_x_m(
    const std::array<bool, 3> & closed, bool front_leans) const;

  BumperParams params_;
};

}  // namespace stetro_localizer

#endif  // STETRO_LOCALIZER__MEASUREMENT__BUMPER_CONTACT_HPP_
