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
#include <cstdint>
#include <exception>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <stdexcept>
#include <string>
#include <vector>

#include "CLI/CLI.hpp"
#include "profiles/profiles_json.hpp"
#include "profiles/rooms_suite.hpp"

namespace stetro_bringup
{
namespace
{

struct ProfilesOptions
{
  std::size_t rooms = 2000;  ///< cases of each table
  std::uint64_t seed = 1;
  std::vector<std::string> tables;  ///< names; none: all
  std::string out = "out/profiles";
};

void add_options(CLI::App & app, ProfilesOptions & options)
{
  app.add_option("--rooms", options.rooms, "cases of each table")
    ->check(CLI::Range(1, 1'000'000))
    ->capture_default_str();
  app.add_option("--seed", options.seed, "the rooms are drawn from it")->capture_default_str();
  app
    .add_option(
      "--tables", options.tables,
      "which: rooms, rooms_noisy, rooms_unmapped, rooms_heading_unknown, rooms_even; all if not "
      "given")
    ->delimiter(',')
    ->check(CLI::IsMember(
      {"rooms", "rooms_noisy", "rooms_unmapped", "rooms_heading_unknown", "rooms_even"}));
  app.add_option("--out", options.out, "folder of the results")->capture_default_str();
}

bool is_asked(const ProfilesOptions & options, const std::string & name)
{
  const auto & asked = options.tables;
  return asked.empty() || std::find(asked.begin(), asked.end(), name) != asked.end();
}

int run(const ProfilesOptions & options)
{
  std::filesystem::create_directories(options.out);
  const std::string path = options.out + "/summary.json";
  std::ofstream summary(path);
  if (!summary) {
    throw std::runtime_error(path + ": cannot be written");
  }
  const bool terminal = isatty(STDOUT_FILENO) == 1;
  std::vector<RoomsTable> tables;
  for (const RoomsKind & kind : kinds_of_rooms()) {
    if (!is_asked(options, kind.name)) {
      continue;
    }
    std::size_t cases = 0;
    tables.push_back(run_rooms(kind, options.rooms, options.seed, [&] {
      if (++cases % 50 == 0 && terminal) {
        std::cout << '\r' << kind.name << ": " << cases << " of " << options.rooms << std::flush;
      }
    }));
    std::cout << (terminal ? "\r" : "") << kind.name << ": " << cases << " cases done\n";
  }
  summary << profiles_json(tables, options.seed);
  std::cout << '\n' << profiles_table(tables) << "\nresults in " << options.out << std::endl;
  return 0;
}

}  // namespace
}  // namespace stetro_bringup

int main(int argc, char ** argv)
{
  CLI::App app{"Checks poses by the centre of mass of the profile and says how well that does."};
  stetro_bringup::ProfilesOptions options;
  stetro_bringup::add_options(app, options);
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
