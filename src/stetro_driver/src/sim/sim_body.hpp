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

#ifndef SIM__SIM_BODY_HPP_
#define SIM__SIM_BODY_HPP_

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string_view>
#include <utility>
#include <vector>

#include "sim/stair_world.hpp"
#include "sim/surroundings.hpp"
#include "stetro_driver/body_shape.hpp"

namespace stetro_driver::sim
{

/// base_link in the flight frame, seen from above.
struct BodyPose
{
  double x_m = 0.0;
  double y_m = 0.0;
  double yaw_rad = 0.0;
};

/// A small motion in base_link.
struct Displacement
{
  double x_m = 0.0;
  double y_m = 0.0;
  double yaw_rad = 0.0;
};

/// How a robot falls.
enum class Fall : std::uint8_t {
  kNone,
  kLiftedWithoutSupport,  ///< block 2 lifted unless 1 and 3 stand, or 1 or 3 unless 2 stands
  kLoweredOnNothing,      ///< the stroke ended before the block touched
  kTippedOffNosing,       ///< a block touched with its edge, its centre over nothing
  kRolledOverNosing,      ///< the centre of a standing block left its tread
};

[[nodiscard]] std::string_view to_string(Fall fall);

/// The body on its stairs: what stands, what touches, what falls. Quasi-static.
/**
 * Each step moves it a little and asks three questions. Does a block run into a riser above its
 * underside, or a bumper into a side wall? Then it is pushed back square to the surface, slides
 * along it, and a share of the push turns it flush. Does a standing block still have its tread
 * under its centre? Else it falls. Does a lowered block touch? Then it stands.
 */
class SimBody
{
public:
  /// \param lock_error_m where each lift's upper lock is, beside its stroke
  SimBody(
    const BodyShape & shape, const StairWorld & world, double squaring,
    const std::array<double, kBlocks> & lock_error_m);

  /// Takes it to another flight's frame, or to other walls; its pose there comes with place() or
  /// hand_over().
  void surround(const StairWorld & world, const Surroundings & around);

  /// The same body in the frame of the flight around it now, level on `step`: 0, or the last.
  /** \param open beside no flight: the ground is level, stairs are walls like all others */
  void hand_over(const BodyPose & pose, int step, bool open);

  /// All three blocks stand, equally high.
  [[nodiscard]] bool level() const;

  /// On a floor and beside no flight.
  [[nodiscard]] bool open() const { return open_; }

  /// Whether something is in the way where it stands.
  [[nodiscard]] bool fits() const;

  /// First surface outside the robot that a ray meets. \param direction of unit length
  [[nodiscard]] std::optional<RayHit> cast(
    const Vector3 & origin, const Vector3 & direction, double reach_m) const;

  /// Puts the robot down, every block on what is under it.
  /** \throws std::invalid_argument when it does not fit there, naming what is in the way */
  void place(const BodyPose & pose);

  /// Sets it down elsewhere, blocks as high as they are; stays where it is if it does not fit.
  void carry(const BodyPose & pose);

  /// Moves it as far as walls and risers allow.
  void move(const Displacement & displacement);

  /// Moves a lift by at most distance_m. \param block 1..3
  void lift(int block, double distance_m);
  void lower(int block, double distance_m);

  [[nodiscard]] const BodyPose & pose() const { return pose_; }
  [[nodiscard]] Fall fall() const { return fall_; }
  [[nodiscard]] int step() const { return step_; }  ///< tread block 2 stands, or last stood, on
  [[nodiscard]] double underside_m(int block) const { return underside_m_[index(block)]; }
  [[nodiscard]] bool standing(int block) const { return standing_[index(block)]; }
  [[nodiscard]] bool at_upper_lock(int block) const;
  [[nodiscard]] double upper_lock_m(int block) const;  ///< underside at the upper lock
  [[nodiscard]] double load(int block) const;          ///< share of the weight
  [[nodiscard]] const BodyShape & shape() const { return *shape_; }
  [[nodiscard]] const StairWorld & world() const { return *world_; }

  /// A point of base_link in the flight frame.
  [[nodiscard]] Vector3 to_flight(double x_m, double y_m, double z_m) const;

  /// Gap between a bumper's outer edge and its wall [m], negative when pressed in; 10 without wall.
  /** The nearest point of a straight bumper is one of its ends. \param left else right */
  [[nodiscard]] double bumper_gap_m(int block, bool left) const;

  /// Gap between a point on block 2's front edge and the riser ahead [m], square to the riser.
  /** 10 when no riser above block 2's underside is left. */
  [[nodiscard]] double switch_gap_m(double y_m) const;

  template <class Archive>
  void archive(Archive & each)
  {
    each(
      pose_.x_m, pose_.y_m, pose_.yaw_rad, underside_m_, datum_m_, standing_, step_, fall_, open_);
  }

private:
  /// A corner that has gone into a surface, and the way out.
  struct Contact
  {
    double depth_m = 0.0;
    double normal_x = 0.0;  ///< unit, out of the surface
    double normal_y = 0.0;
    double corner_x_m = 0.0;  ///< from base_link, in flight axes
    double corner_y_m = 0.0;
  };

  static std::size_t index(int block) { return static_cast<std::size_t>(block - 1); }
  [[nodiscard]] Contact deepest_contact() const;
  void offer_riser(int block, Contact & deepest) const;
  void offer_walls(int block, Contact & deepest) const;
  void offer_surroundings(Contact & deepest) const;
  [[nodiscard]] const std::vector<Wall> & walls() const;
  [[nodiscard]] Wall in_base(const Wall & wall) const;
  [[nodiscard]] bool reaches(int block, const Wall & wall) const;
  [[nodiscard]] double side_wall_gap_m(int block, bool left) const;
  [[nodiscard]] int step_under(double x_m, double y_m) const;
  [[nodiscard]] int riser_ahead(int block) const;
  void turn(double yaw_rad);
  void slide(double x_m, double y_m);
  void square_up(const Contact & contact, double pushed_m);
  void check_support();
  [[nodiscard]] double ground_under_centre_m(int block) const;
  [[nodiscard]] double ground_under_edges_m(int block) const;

  const BodyShape * shape_;
  const StairWorld * world_;
  double squaring_;
  std::array<double, kBlocks> lock_error_m_;
  BodyPose pose_{};
  std::array<double, kBlocks> underside_m_{};
  std::array<double, kBlocks> datum_m_{};  // where each block last stood
  std::array<bool, kBlocks> standing_{};
  int step_ = 0;
  Fall fall_ = Fall::kNone;
  const Surroundings * around_;
  bool open_ = false;
};

}  // namespace stetro_driver::sim

#endif  // SIM__SIM_BODY_HPP_
