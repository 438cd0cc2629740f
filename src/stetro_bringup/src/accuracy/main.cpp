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

#include <cmath>
#include <cstdio>
#include <exception>
#include <filesystem>
#include <iostream>
#include <map>
#include <string>
#include <vector>

#include "accuracy/campaign.hpp"
#include "accuracy/error_distribution.hpp"
#include "accuracy/options.hpp"
#include "stetro_config/fault.hpp"

namespace stetro_bringup
{
namespace
{

std::string shipped_file(const std::string & name)
{
  const auto prefix = std::filesystem::canonical("/proc/self/exe").parent_path().parent_path();
  return (prefix / "share" / "stetro_bringup" / "config" / name).string();
}

struct Quantity
{
  const char * name;
  double TreadErrors::*error;
  double scale;
  const char * unit;
};

int run(AccuracyOptions options)
{
  if (options.site.empty()) {
    options.site = shipped_file("site/papers_staircase.yaml");
  }
  if (options.robot.empty()) {
    options.robot = shipped_file("robot/stetro.yaml");
  }
  const RobotSetup setup = read_robot_setup(options.site, options.robot, options.flight);
  const auto names = estimators_of(options);
  std::vector<ClimbOrder> orders;
  for (std::uint64_t i = 0; i < options.runs; ++i) {
    ClimbOrder order;
    order.seed = options.first_seed + i;
    order.world = options.world;
    order.calibration = options.calibration;
    order.estimators = names;
    orders.push_back(order);
  }
  const std::vector<Quantity> quantities{
    {"x", &TreadErrors::x_m, 1e3, "mm"},
    {"x_behind", &TreadErrors::x_behind_m, 1e3, "mm"},
    {"y", &TreadErrors::y_m, 1e3, "mm"},
    {"z", &TreadErrors::z_m, 1e3, "mm"},
    {"heading", &TreadErrors::heading_rad, 180.0 / M_PI, "deg"},
    {"to_riser", &TreadErrors::heading_to_riser_rad, 180.0 / M_PI, "deg"},
    {"flight_x", &TreadErrors::flight_x_m, 1e3, "mm"},
    {"flight_z", &TreadErrors::flight_z_m, 1e3, "mm"}};
  std::vector<std::map<std::string, ErrorDistribution>> all(names.size());
  run_campaign(setup, orders, options.jobs, [&](const ClimbOrder &, const ClimbRecord & record) {
    std::printf(
      "seed %s: %s %s step %d, %.0f s\n", std::to_string(record.seed).c_str(),
      to_string(record.end), record.detail.c_str(), record.last_step, record.simulated_s);
    for (std::size_t e = 0; e < names.size(); ++e) {
      for (const ScoredEstimate & sample : record.scores[e].samples) {
        for (const Quantity & q : quantities) {
          if (!sample.first_tread && std::isfinite(sample.errors.*q.error)) {
            all[e][q.name].add(sample.errors.*q.error);
          }
        }
      }
    }
  });
  for (std::size_t e = 0; e < names.size(); ++e) {
    for (const Quantity & q : quantities) {
      const ErrorDistribution & d = all[e][q.name];
      std::printf(
        "%s %-10s rmse %8.3f mean %8.3f std %8.3f p95 %8.3f p99.9 %8.3f max %8.3f %s (%zu)\n",
        names[e].c_str(), q.name, q.scale * d.rmse(), q.scale * d.mean(),
        q.scale * d.standard_deviation(), q.scale * d.percentile(0.95),
        q.scale * d.percentile(0.999), q.scale * d.max(), q.unit, d.count());
    }
  }
  return 0;
}

}  // namespace
}  // namespace stetro_bringup

int main(int argc, char ** argv)
{
  CLI::App app{"Climbs many simulated staircases and says how well the estimators did."};
  stetro_bringup::AccuracyOptions options;
  stetro_bringup::add_options(app, options);
  try {
    app.parse(argc, argv);
    return stetro_bringup::run(options);
  } catch (const CLI::ParseError & error) {
    return app.exit(error);
  } catch (const std::exception & error) {
    std::cerr << "stetro_accuracy: " << error.what() << '\n';
    return 1;
  }
}
