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

#include <unistd.h>

#include <exception>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <stdexcept>
#include <string>
#include <thread>
#include <vector>

#include "accuracy/accuracy_markdown.hpp"
#include "accuracy/accuracy_report.hpp"
#include "accuracy/campaign.hpp"
#include "accuracy/fault_scenario.hpp"
#include "accuracy/options.hpp"
#include "accuracy/plot_tables.hpp"
#include "accuracy/progress.hpp"
#include "demo/child_process.hpp"
#include "installation.hpp"
#include "stetro_config/fault.hpp"

namespace stetro_bringup
{
namespace
{

using std::chrono_literals::operator""ms;

std::ofstream opened(const std::string & path)
{
  std::ofstream file(path);
  if (!file) {
    throw std::runtime_error(path + ": cannot be written");
  }
  return file;
}

std::vector<ClimbOrder> orders_of(
  const AccuracyOptions & options, const std::vector<std::string> & scenarios, int steps)
{
  std::vector<ClimbOrder> orders;
  const std::size_t columns = scenarios.empty() ? 1 : scenarios.size();
  for (std::size_t scenario = 0; scenario < columns; ++scenario) {
    for (std::uint64_t i = 0; i < options.runs; ++i) {
      ClimbOrder order;
      order.seed = options.first_seed + i;
      order.scenario = scenario;
      order.world = options.world;
      order.calibration = options.calibration;
      order.estimators = estimators_of(options);
      if (!scenarios.empty()) {
        const DrawnFaults drawn = draw_faults(scenarios[scenario], order.seed, steps);
        order.faults = drawn.text;
        order.onset = drawn.onset;
      }
      orders.push_back(order);
    }
  }
  return orders;
}

AccuracyReport empty_report(
  const AccuracyOptions & options, const std::vector<std::string> & scenarios,
  const RobotSetup & setup)
{
  const auto names = estimators_of(options);
  const int steps = setup.flight().steps();
  AccuracyReport report{
    options.runs,
    options.first_seed,
    options.world,
    options.calibration,
    setup.flight().id(),
    steps,
    names,
    {"overall", steps, names.size()},
    {}};
  for (const std::string & name : scenarios) {
    report.scenarios.emplace_back(name, steps, names.size());
  }
  return report;
}

void draw(const AccuracyOptions & options, const AccuracyReport & report)
{
  std::string names;
  for (std::size_t i = 0; i < report.estimators.size(); ++i) {
    const std::string & name = report.estimators[i];
    auto treads = opened(options.out + '/' + name + "_treads.csv");
    write_treads_csv(treads, report.overall.estimators[i]);
    auto histogram = opened(options.out + '/' + name + "_histogram.csv");
    write_histogram_csv(histogram, report.overall.estimators[i]);
    names += (names.empty() ? "" : " ") + name;
  }
  if (options.no_plots) {
    return;
  }
  const std::string log = options.out + "/gnuplot.log";
  ChildProcess gnuplot(
    {"gnuplot", "-e", "folder='" + options.out + "'; estimators='" + names + "'",
     shipped_file("../plots/accuracy.gp")},
    log);
  while (!gnuplot.ended()) {
    std::this_thread::sleep_for(10ms);
  }
  if (gnuplot.ended() != 0) {
    std::cout << "the picture could not be drawn, see " << log << '\n';
  }
}

int run(AccuracyOptions options)
{
  const Provenance provenance{command_of(options), options.commit, this_machine()};
  if (options.site.empty()) {
    options.site = shipped_file("site/papers_staircase.yaml");
  }
  if (options.robot.empty()) {
    options.robot = shipped_file("robot/stetro.yaml");
  }
  const auto scenarios = chosen_scenarios(options.faults);
  const RobotSetup setup = read_robot_setup(
    {options.site, options.robot, options.flight, options.localizer, options.errors});
  const auto orders = orders_of(options, scenarios, setup.flight().steps());
  std::filesystem::create_directories(options.out);
  std::ofstream markdown;
  if (!options.markdown.empty()) {
    markdown = opened(options.markdown);  // before the long work: a folder may be missing
  }

  AccuracyReport report = empty_report(options, scenarios, setup);
  CampaignProgress progress(std::cout, isatty(STDOUT_FILENO) == 1, orders.size());
  run_campaign(
    setup, orders, options.jobs, [&](const ClimbOrder & order, const ClimbRecord & record) {
      report.overall.add(record);
      if (!report.scenarios.empty()) {
        report.scenarios[order.scenario].add(record);
      }
      progress.done(record.simulated_s);
    });
  progress.close();
  opened(options.out + "/summary.json") << summary_json(report);
  if (markdown.is_open()) {
    markdown << summary_markdown(report, provenance);
  }
  std::cout << '\n' << summary_table(report);
  draw(options, report);
  std::cout << "\nresults in " << options.out << std::endl;
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
