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

#ifndef STETRO_LOCALIZER__FUSED__FUSED_MODEL_HPP_
#define STETRO_LOCALIZER__FUSED__FUSED_MODEL_HPP_

#include <array>

#include "stetro_localizer/fused/front_range_aiding.hpp"
#include "stetro_localizer/fused/fused_core.hpp"
#include "stetro_localizer/fused/side_range_aiding.hpp"
#include "stetro_localizer/params.hpp"
#include "stetro_localizer/step_model.hpp"
#include "stetro_site/flight.hpp"
#include "stetro_site/robot_geometry.hpp"

namespace stetro_localizer
{

/// One range of a pair that is watched for contradiction.
struct PairedRanger
{
  Ranger ranger;
  Place place;
  Source source;
  double sign;     ///< its innovation adds or subtracts
  double outward;  ///< d(range)/d(x) or d(range)/d(y) of a square robot
};
using RangerPair = std::array<PairedRanger, 2>;

/// What a sample means: takes a `FusedCore` from before it to after it.
/**
 * Holds the robot, the flight and the parameters, and no state: the same core and the same sample
 * give the same core again. Wheels and gyroscope tell of the interval that ends at their stamp;
 * everything else is measured at its stamp. Immutable after construction.
 */
class FusedModel
{
public:
  using Core = FusedCore;
  using Sample = stetro_localizer::Sample;

  /// Adds the places that one array of ranges has and another of the same time has not.
  /** \return whether there were any */
  static bool fill_in(Sample & kept, const Sample & sample);

  FusedModel(
    const LocalizerParams & params, const stetro_site::RobotGeometry & robot,
    const stetro_site::Flight & flight);
  FusedModel(const FusedModel &) = delete;  // cores refer to its step model
  FusedModel & operator=(const FusedModel &) = delete;

  /// A core that knows what the files say and has seen nothing.
  [[nodiscard]] FusedCore begin() const;

  /// Takes one sample, which must not be older than the core.
  void take(FusedCore & core, const Sample & sample) const;

  /// Lets the motion go on as it was until `time`; earlier times change nothing.
  void advance(FusedCore & core, Nanoseconds time) const;

  /// The gyroscope says the same again and again while the robot moves.
  [[nodiscard]] bool gyro_stuck(const FusedCore & core) const;

  /// How far the estimate may be off along `axis` by a slip that is suspected [m].
  [[nodiscard]] double suspected_slip_m(const FusedCore & core, int axis) const;

  /// How far the heading may be off by what the front pair suspects of it and of the gyroscope.
  [[nodiscard]] double suspected_turn_rad(const FusedCore & core) const;

  /// A side wall lies in reach, and long enough for the cone of its sensor.
  [[nodiscard]] bool wall_in_sight(const FusedCore & core) const;

  /// Makes the core believe that it stands on `step`; x becomes unknown within the tread.
  void locate(FusedCore & core, int step) const;

  /// What is known of the step that block 2 stands on; step 0 on the floor, or where it is unknown.
  [[nodiscard]] StepAsBuilt as_built_here(const FusedCore & core) const;

private:
  void take_one(FusedCore & core, const OdometrySample & sample) const;
  void take_one(FusedCore & core, const GyroSample & sample) const;
  void take_one(FusedCore & core, const ContactSample & sample) const;
  void take_one(FusedCore & core, const BlockSample & sample) const;
  void take_one(FusedCore & core, const RangeSample & sample) const;

  void take_speed(FusedCore & core, int index, double counted_mps, bool blocked) const;
  void take_bumpers(FusedCore & core, Side side, const ContactSample & sample) const;
  void take_riser_switch(FusedCore & core, Side side, const ContactSample & sample) const;
  [[nodiscard]] bool confirms(const RangeReading & before, const RangeReading & now) const;
  void take_side(FusedCore & core, Side side, const RangeReading & reading) const;
  void take_front(FusedCore & core, const FrontRangeAiding & aiding, const RangeReading &) const;
  void take_block3_front(FusedCore & core, const RangeReading & reading) const;
  [[nodiscard]] std::optional<SeenRiser> block3_sees(const FusedCore & core, double range_m) const;
  void note_closure(FusedCore & core, bool left, double gap_m) const;
  Outcome use_contact(
    FusedCore & core, Source source, const Expectation & gap, int axis, double variance) const;
  [[nodiscard]] bool belies_site(const ScalarEstimate & gauged, int step) const;
  [[nodiscard]] FrontCalibration front_calibration(const FusedCore & core) const;
  void begin_gauge(FusedCore & core) const;
  void hand_gauge_on(FusedCore & core) const;
  void gauge_tread_ahead(FusedCore & core, const RangeSample & sample) const;
  [[nodiscard]] bool cone_is_clear(double beam_z_m, int riser, double range_m) const;
  [[nodiscard]] StepEvidence step_evidence(const FusedCore & core, Nanoseconds time) const;
  [[nodiscard]] std::optional<double> front_m(const FusedCore & core, Nanoseconds time) const;
  void follow_step(FusedCore & core, std::optional<int> step) const;
  void note_slip(
    FusedCore & core, int axis, double innovation_m, const SourceReport & report,
    double variance_before) const;
  [[nodiscard]] bool calibrated(const FusedCore & core, int axis) const;
  [[nodiscard]] bool told_by_one(const FusedCore & core, int axis) const;
  void take_suspected_slip(FusedCore & core, int axis) const;
  void reconsider_front(FusedCore & core, const SourceReport & refused) const;
  void reconsider_side(FusedCore & core, Side side, const SourceReport & refused) const;
  void explain_surprise(FusedCore & core, int axis, double surprise_m2) const;
  void doubt(FusedCore & core, int axis, double shift_m) const;
  void doubt_heading(FusedCore & core, double difference_m) const;
  [[nodiscard]] double doubtful_m(double shift_m) const;
  void doubt_pair(FusedCore & core, const RangerPair & pair, double shift_m) const;
  void watch_pairs(FusedCore & core, const RangeSample & sample) const;
  std::optional<Slip> watch_pair(
    const FusedCore & core, SlipWatch & watch, const RangeSample & sample, const RangerPair & pair,
    Expectation model) const;
  Outcome use(
    FusedCore & core, Source source, const Expectation & expectation, double measured,
    double variance, const Corrects & corrects = Corrects::all()) const;
  Outcome use(
    FusedCore & core, Source source, const Expectation & expectation, const Innovation & innovation,
    const Corrects & corrects = Corrects::all()) const;

  [[nodiscard]] double tread_m(int step) const;
  [[nodiscard]] double edge_ahead_m(int step) const;
  [[nodiscard]] double range_variance_m2(double range_m) const;
  [[nodiscard]] Corrects side_corrects(const FusedCore & core) const;
  [[nodiscard]] double heading_variance_of_pair(double variance_m2) const;
  [[nodiscard]] Corrects front_corrects(const FusedCore & core, double range_m) const;
  [[nodiscard]] Corrects clipped_corrects(const FusedCore & core, double shift_m2) const;
  [[nodiscard]] bool wall_fills_cone(const FusedCore & core, double range_m) const;
  [[nodiscard]] bool sees_side_wall(
    const FusedCore & core, stetro_site::Place place, double range_m) const;

  LocalizerParams params_;
  stetro_site::RobotGeometry robot_;
  stetro_site::Flight flight_;
  StepModel step_model_;
  double gate_;  // nis that a sound measurement exceeds as rarely as the parameter says
  std::array<SideRangeAiding, 2> sides_;
  std::array<FrontRangeAiding, 2> fronts_;
  FrontRangeAiding block3_front_;
};

}  // namespace stetro_localizer

#endif  // STETRO_LOCALIZER__FUSED__FUSED_MODEL_HPP_
