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

#ifndef STETRO_LOCALIZER__LATERAL_HPP_
#define STETRO_LOCALIZER__LATERAL_HPP_

#include <array>
#include <cstdint>
#include <optional>

#include "stetro_localizer/carried_average.hpp"
#include "stetro_localizer/measurement/bumper_contact.hpp"
#include "stetro_localizer/measurement/side_range.hpp"
#include "stetro_localizer/outcome.hpp"
#include "stetro_localizer/params.hpp"
#include "stetro_localizer/range_offset.hpp"
#include "stetro_localizer/samples.hpp"
#include "stetro_localizer/side_selection.hpp"
#include "stetro_site/robot_geometry.hpp"

namespace stetro_localizer
{

/// What y needs to know of the rest: the heading, and the stairs here.
struct LateralView
{
  double yaw_rad = 0.0;
  double yaw_variance = 0.0;  ///< [rad^2]
  double width_m = 0.0;       ///< between the side walls here [m]
  bool wall_left = true;      ///< the flight is walled on the left
  bool wall_right = true;     ///< the flight is walled on the right
};

/// y, the distance from the right wall: S-A and S-B eq. (1), y part, and what stands in for it.
/**
 * Each side range is averaged, freed from its offset and turned into y; SideSelection chooses. When
 * neither side sees its wall the wheels carry the last y on and the variance grows. At each bumper
 * contact y is known without a range, and the offset of that side's range is learned from it.
 */
class Lateral
{
public:
  Lateral(const LateralParams & params, const stetro_site::RobotGeometry & robot);

  /// Moves by the wheels, along y of the flight. A closed bumper's wall stops it.
  void travel(double dy_m);

  /// Takes one reading of a side range.
  Verdict add_range(
    Side side, const RangeReading & reading, const LateralView & view, SourceReport & report);

  /// Chooses among the sides and updates y; call it after the ranges of a cycle.
  void choose(Nanoseconds now, const LateralView & view);

  /// Takes the bumpers of one side.
  /**
   * A contact is used when it begins, and used anew in its place when both ends have closed.
   * \param before where y stood is written here when a contact begins: for eq. (3)
   */
  Verdict add_bumpers(
    Side side, const std::array<Switch, 3> & bumpers, Nanoseconds now, const LateralView & view,
    SourceReport & report, std::optional<double> & before);

  /// Starts from a y that was told.
  void reset(double y_m, double variance_m2);

  [[nodiscard]] std::optional<double> y_m() const;
  [[nodiscard]] double variance_m2(const LateralView & view) const;
  [[nodiscard]] double slope_yaw() const { return fix_.slope_yaw; }  ///< dy/dpsi [m/rad]

  [[nodiscard]] bool measured() const { return measured_; }  ///< a side range is in y
  [[nodiscard]] bool closes() const { return closes_; }      ///< both sides agree, if both see
  [[nodiscard]] std::uint32_t restarts() const { return restarts_; }  ///< y was measured anew
  [[nodiscard]] std::uint32_t calibrations() const { return calibrations_; }

  [[nodiscard]] const RangeOffset & offset(Side side) const { return beam(side).offset; }
  void set_offset(Side side, const RangeOffset & offset) { beam(side).offset = offset; }

private:
  struct Beam
  {
    SideRange model;
    CarriedAverage average;
    RangeOffset offset;
    RangeOffset before_contact{};  // the offset when the contact began
    Nanoseconds last_stamp{0};     // of the last reading taken
    bool closed = false;           // a bumper on this side is closed
    bool touching = false;         // and it is believed
    bool squared = false;          // front and rear are, so that the heading does not matter
  };

  [[nodiscard]] Beam make_beam(Side side, const stetro_site::Mounting & mounting) const;
  [[nodiscard]] Beam & beam(Side side) { return side == Side::kLeft ? left_ : right_; }
  [[nodiscard]] const Beam & beam(Side side) const { return side == Side::kLeft ? left_ : right_; }
  [[nodiscard]] double carrier(Side side) const;
  [[nodiscard]] std::optional<CarriedAverage::Mean> mean(Side side, Nanoseconds now) const;
  [[nodiscard]] std::optional<SideFix> fix_of(
    Side side, Nanoseconds now, const LateralView & view) const;
  [[nodiscard]] bool in_reach(Side side, const LateralView & view) const;
  [[nodiscard]] double expected_m(Side side, const LateralView & view) const;
  [[nodiscard]] bool in_gate(
    Side side, double range_m, const LateralView & view, SourceReport & report) const;
  void settle(const LateralFix & fix);
  bool learn_offset(
    Side side, const ContactFix & contact, Nanoseconds now, const LateralView & view);

  LateralParams params_;
  TofNoise noise_;
  Beam left_;
  Beam right_;
  BumperContact contact_;
  double reliable_range_m_;  // beyond it a range is not reliable [m]
  SideSelection selection_;
  bool known_ = false;
  bool measured_ = false;
  bool searching_ = false;  // the next measurement is believed whatever was predicted
  bool closes_ = true;
  LateralFix fix_{};
  double travelled_m_ = 0.0;      // along y, by the wheels
  double fix_travelled_m_ = 0.0;  // the same when y was fixed
  double way_since_fix_m_ = 0.0;  // there and back
  std::uint32_t restarts_ = 0;
  std::uint32_t calibrations_ = 0;
};

}  // namespace stetro_localizer

#endif  // STETRO_LOCALIZER__LATERAL_HPP_
