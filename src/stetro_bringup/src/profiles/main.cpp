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

#include <algorithm>
#include <chrono>
#include <cstdint>
#include <exception>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <stdexcept>
#include <string>
#include <thread>
#include <utility>
#include <vector>

#include "CLI/CLI.hpp"
#include "demo/child_process.hpp"
#include "installation.hpp"
#include "profiles/logs_suite.hpp"
#include "profiles/maps_suite.hpp"
#include "profiles/profile_pictures.hpp"
#include "profiles/profiles_json.hpp"
#include "profiles/profiles_table.hpp"
#include "profiles/rooms_suite.hpp"

namespace stetro_bringup
{
namespace
{

using std::chrono_literals::operator""ms;

const std::vector<std::string> kTables{
  "rooms",      "rooms_noisy", "rooms_unmapped", "rooms_heading_unknown",
  "rooms_even", "real_maps",   "real_logs"};

struct ProfilesOptions
{
  std::size_t rooms = 2000;  ///< cases of each table of rooms
  std::size_t poses = 1000;  ///< cases on each map
  std::uint64_t seed = 1;
  std::vector<std::string> tables;  ///< names; none: all
  std::string recorded;             ///< folder of the recordings; empty: no real maps, no logs
  std::string out = "out/profiles";
  bool no_plots = false;
};

void declare_options(CLI::App & app, ProfilesOptions & options)
{
  app.add_option("--rooms", options.rooms, "cases of each table of rooms")
    ->check(CLI::Range(1, 1'000'000))
    ->capture_default_str();
  app.add_option("--poses", options.poses, "cases on each recorded map")
    ->check(CLI::Range(1, 1'000'000))
    ->capture_default_str();
  app.add_option("--seed", options.seed, "all that is drawn is drawn from it")
    ->capture_default_str();
  app
    .add_option(
      "--tables", options.tables,
      "which: rooms, rooms_noisy, rooms_unmapped, rooms_heading_unknown, rooms_even, real_maps, "
      "real_logs; all if not given")
    ->delimiter(',')
    ->check(CLI::IsMember(kTables));
  app.add_option(
    "--recorded", options.recorded,
    "folder of the recorded maps and scans; without it real_maps and real_logs are left out");
  app.add_option("--out", options.out, "folder of the results")->capture_default_str();
  app.add_flag("--no-plots", options.no_plots, "tables for the pictures, but no pictures");
}

bool is_asked(const ProfilesOptions & options, const std::string & name)
{
  const auto & asked = options.tables;
  return asked.empty() || std::find(asked.begin(), asked.end(), name) != asked.end();
}

/// Says how far a table is, on a terminal.
class Ticker
{
public:
  explicit Ticker(std::string name) : name_(std::move(name)), terminal_(isatty(STDOUT_FILENO) == 1)
  {
  }

  void tick()
  {
    if (++cases_ % 50 == 0 && terminal_) {
      std::cout << '\r' << name_ << ": " << cases_ << std::flush;
    }
  }

  void done() const
  {
    std::cout << (terminal_ ? "\r" : "") << name_ << ": " << cases_ << " cases done\n";
  }

private:
  std::string name_;
  bool terminal_;
  std::size_t cases_ = 0;
};

void run_all_rooms(const ProfilesOptions & options, ProfilesReport & report)
{
  for (const RoomsKind & kind : kinds_of_rooms()) {
    if (is_asked(options, kind.name)) {
      Ticker ticker(kind.name);
      report.rooms.push_back(
        run_rooms(kind, options.rooms, options.seed, [&ticker] { ticker.tick(); }));
      ticker.done();
    }
  }
}

void draw(const ProfilePictures & pictures)
{
  const auto joined = [](const std::vector<std::string> & names) {
    std::string all;
    for (const std::string & name : names) {
      all += (all.empty() ? "" : " ") + name;
    }
    return all;
  };
  const std::string settings = "folder='" + pictures.folder + "'; maps='" + joined(pictures.maps) +
                               "'; logs='" + joined(pictures.logs) +
                               "'; convergence=" + (pictures.convergence ? "1" : "0");
  const std::string log = pictures.folder + "/gnuplot.log";
  ChildProcess gnuplot({"gnuplot", "-e", settings, shipped_file("../plots/profiles.gp")}, log);
  while (!gnuplot.ended()) {
    std::this_thread::sleep_for(10ms);
  }
  if (gnuplot.ended() != 0) {
    std::cout << "the pictures could not be drawn, see " << log << '\n';
  }
}

void run_recorded(
  const ProfilesOptions & options, ProfilesReport & report, ProfilePictures & pictures)
{
  if (is_asked(options, "real_maps")) {
    Ticker ticker("real_maps");
    const auto floors = recorded_floors(options.recorded);
    report.maps = run_maps(floors, options.poses, options.seed, [&ticker] { ticker.tick(); });
    ticker.done();
    pictures.add_maps(floors);
    pictures.add_convergence(report.maps);
  }
  if (is_asked(options, "real_logs")) {
    Ticker ticker("real_logs");
    const auto logs = recorded_logs(options.recorded);
    for (const RecordedLog & log : logs) {
      report.logs.push_back(run_log(log, options.seed, [&ticker] { ticker.tick(); }));
    }
    ticker.done();
    pictures.add_logs(logs, options.seed);
  }
}

int run(const ProfilesOptions & options)
{
  std::filesystem::create_directories(options.out);
  const std::string path = options.out + "/summary.json";
  std::ofstream summary(path);
  if (!summary) {
    throw std::runtime_error(path + ": cannot be written");
  }
  ProfilesReport report;
  report.seed = options.seed;
  run_all_rooms(options, report);
  ProfilePictures pictures;
  pictures.folder = options.out;
  if (!options.recorded.empty()) {
    run_recorded(options, report, pictures);
  }
  summary << profiles_json(report) << std::flush;
  std::cout << '\n' << profiles_table(report) << "\nresults in " << options.out << std::endl;
  if (!options.recorded.empty() && !options.no_plots) {
    draw(pictures);
  }
  return 0;
}

}  // namespace
}  // namespace stetro_bringup

int main(int argc, char ** argv)
{
  CLI::App app{"Checks poses by the centre of mass of the profile and says how well that does."};
  stetro_bringup::ProfilesOptions options;
  stetro_bringup::declare_options(app, options);
  try {
    app.parse(argc, argv);
    return stetro_bringup::run(options);
  } catch (const CLI::ParseError & error) {
    return app.exit(error);
  } catch (const std::exception & error) {
    std::cerr << "stetro_profiles: " << error.what() << '\n';
    return 1;
  }
}
