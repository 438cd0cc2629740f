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

#include "profiles/profiles_json.hpp"

#include <algorithm>
#include <iomanip>
#include <sstream>

#include "nlohmann/json.hpp"

namespace stetro_bringup
{
namespace
{

using Json = nlohmann::ordered_json;

double share(std::size_t part, std::size_t whole)
{
  return whole == 0 ? 0.0 : static_cast<double>(part) / static_cast<double>(whole);
}

Json figures(const RoomsScore & score)
{
  return {
    {"solved", share(score.within_01, score.cases)},
    {"solved_1_unit", share(score.within_1, score.cases)},
    {"no_verdict", score.no_verdict},
    {"ambiguous", score.ambiguous},
    {"ambiguous_right", score.ambiguous_right},
    {"false_accepts", score.false_accepts},
    {"searched", score.searched},
    {"median_us", score.median_us()},
  };
}

void print(std::ostream & out, const std::string & name, const RoomsScore & score)
{
  out << std::left << std::setw(34) << name << std::right << std::fixed << std::setprecision(2)
      << std::setw(9) << 100.0 * share(score.within_1, score.cases) << std::setw(9)
      << 100.0 * share(score.within_01, score.cases) << std::setw(12) << score.no_verdict
      << std::setw(11) << score.ambiguous << std::setw(8) << score.ambiguous_right << std::setw(8)
      << score.false_accepts << std::setprecision(0) << std::setw(11) << score.median_us() << '\n';
}

}  // namespace

std::string profiles_json(const std::vector<RoomsTable> & tables, std::uint64_t seed)
{
  Json root;
  for (const RoomsTable & table : tables) {
    Json & at = root[table.kind.name];
    at["cases"] = table.trusted.cases;
    at["seed"] = seed;
    at["published"] = figures(table.published);
    // The published search is judged by 1 unit: it stops where its steps are marginal.
    at["published"]["solved"] = share(table.published.within_1, table.published.cases);
    at["published"]["solved_fine"] = share(table.published.within_01, table.published.cases);
    at["trusted"] = figures(table.trusted);
  }
  return root.dump(2) + '\n';
}

std::string profiles_table(const std::vector<RoomsTable> & tables)
{
  std::ostringstream out;
  out << std::left << std::setw(34) << "rooms of 100 x 100 units" << std::right << std::setw(9)
      << "< 1 %" << std::setw(9) << "< 0.1 %" << std::setw(12) << "no verdict" << std::setw(11)
      << "ambiguous" << std::setw(8) << "right" << std::setw(8) << "false" << std::setw(11)
      << "median us" << '\n';
  for (const RoomsTable & table : tables) {
    print(out, table.kind.name + " published", table.published);
    print(out, table.kind.name + " trusted", table.trusted);
  }
  return out.str();
}

}  // namespace stetro_bringup
