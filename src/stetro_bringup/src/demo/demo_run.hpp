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
#ifndef DEMO__DEMO_RUN_HPP_
#define DEMO__DEMO_RUN_HPP_

#include <chrono>
#include <fstream>
#include <optional>
#include <string>
#include <vector>

#include "demo_node.hpp"
#include "demo_options.hpp"
#include "journey_files.hpp"
#include "progress.hpp"
#include "stetro_bringup/climb_report.hpp"
#include "stetro_bringup/journey_report.hpp"
#include "stetro_bringup/recorder.hpp"
#include "stetro_bringup/summary.hpp"
#include "stetro_bringup/trace.hpp"
#include "stetro_dds/context.hpp"
#include "stetro_site/fit.hpp"

namespace stetro_bringup
{

/// One climb or journey from the request to the report: asks, records, shows, writes.
class DemoRun
{
public:
  /// \param task a run that ends elsewhere than at its goal has not succeeded
  /// \throws std::runtime_error if the results cannot be written
  DemoRun(
    stetro_dds::Context & context, const DemoOptions & options, const Task & task,
    const stetro_site::Deployment & deployment);

  [[nodiscard]] stetro_dds::Node & node() { return demo_.node(); }

  /// Asks for the task and shows how far it is; call it again and again.
  /** \return whether it goes on */
  bool goes_on();

  /// Whether the localizer is still to say what staircase it found; hear it before the report.
  [[nodiscard]] bool awaits_staircase() const;

  /// Tells that the run cannot go on, for example because a process has died.
  void give_up(const std::string & reason);

  /// Writes the results, draws them and prints the report.
  ClimbOutcome report();

private:
  [[nodiscard]] ClimbOutcome outcome() const;
  [[nodiscard]] double wall_time_s() const;
  [[nodiscard]] double simulated_time_s() const;
  void take(const TraceRow & row, bool standing);
  void ask();
  void draw(const std::string & plot) const;

  const DemoOptions & options_;
  const Task task_;
  const std::chrono::steady_clock::time_point started_;
  std::ofstream trace_file_;
  TraceWriter trace_;
  ClimbReport report_;
  JourneyReport journey_;
  std::optional<JourneyFiles> files_;  // of a journey
  Recorder recorder_;
  DemoNode demo_;
  Progress progress_;
  std::vector<std::string> troubles_;
  std::chrono::nanoseconds asked_{0};
  std::chrono::steady_clock::time_point over_;  // when goes_on() said so
};

}  // namespace stetro_bringup

#endif  // DEMO__DEMO_RUN_HPP_
