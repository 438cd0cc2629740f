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

#include "nlohmann/json.hpp"
#include "profiles/median.hpp"

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

Json figures(const MapsScore & score)
{
  Json at = {
    {"cases", score.cases},
    {"solved", share(score.solved, score.cases)},
    {"no_verdict", score.no_verdict},
    {"ambiguous", score.ambiguous},
    {"free_direction_shown", score.free_direction_shown},
    {"by_ends", score.by_ends},
    {"false_accepts", score.false_accepts},
    {"median_us", median(score.us)},
  };
  for (const auto & [reason, count] : score.reasons) {
    at["reasons"][reason] = count;
  }
  return at;
}

Json figures(const RadiusFigures & radius)
{
  return {{"median", radius.median}, {"share_below_1", radius.share_below_1}};
}

Json figures(const MapsTable & table)
{
  Json at;
  at["free_area_m2"] = table.free_area_m2;
  at["determined_share"] = table.determined_share;
  at["spectral_radius"]["guarded"] = figures(table.guarded_radius);
  at["spectral_radius"]["published"] = figures(table.published_radius);
  at["published"] = figures(table.published);
  at["trusted"] = figures(table.determined);
  at["trusted"]["elsewhere"] = figures(table.elsewhere);
  if (table.rough_determined.cases + table.rough_elsewhere.cases > 0) {
    at["trusted_rough_world"] = figures(table.rough_determined);
    at["trusted_rough_world"]["elsewhere"] = figures(table.rough_elsewhere);
  }
  return at;
}

Json far_off(const LogCase & one)
{
  return {
    {"scan", one.number},     {"error_m", one.error_m}, {"error_rad", one.error_rad},
    {"sigma_m", one.sigma_m}, {"by_ends", one.by_ends}, {"turning_rad_s", one.turning_rad_s},
  };
}

Json figures(const LogTable & table)
{
  const LogSummary sum = summary_of(table);
  Json trusted = {
    {"solved", share(sum.right, sum.cases)},
    {"right_or_no_verdict", share(sum.right + sum.no_verdict + sum.ambiguous, sum.cases)},
    {"verdicts", sum.verdicts},
    {"no_verdict", sum.no_verdict},
    {"ambiguous", sum.ambiguous},
    {"by_ends", sum.by_ends},
    {"false_accepts", sum.false_accepts},
    {"median_error_m", sum.median_error_m},
    {"worst_error_m", sum.worst_error_m},
    {"median_error_rad", sum.median_error_rad},
    {"median_us", sum.median_us},
  };
  for (const auto & [reason, count] : sum.reasons) {
    trusted["reasons"][reason] = count;
  }
  trusted["accepted_beyond_25_cm"] = Json::array();
  for (const LogCase & one : table.cases) {
    if (table.is_verdict(one) && one.error_m > kFarOff) {
      trusted["accepted_beyond_25_cm"].push_back(far_off(one));
    }
  }
  return {
    {"cases", sum.cases},
    {"published",
     {{"solved", share(sum.published_right, sum.cases)},
      {"false_accepts", sum.published_far_off},
      {"median_error_m", sum.published_median_error_m}}},
    {"trusted", trusted},
  };
}

}  // namespace

std::string profiles_json(const ProfilesReport & report)
{
  Json root;
  for (const RoomsTable & table : report.rooms) {
    Json & at = root[table.kind.name];
    at["cases"] = table.trusted.cases;
    at["seed"] = report.seed;
    at["published"] = figures(table.published);
    // The published search is judged by 1 unit: it stops where its steps are marginal.
    at["published"]["solved"] = share(table.published.within_1, table.published.cases);
    at["published"]["solved_fine"] = share(table.published.within_01, table.published.cases);
    at["trusted"] = figures(table.trusted);
  }
  for (const MapsTable & table : report.maps) {
    root["real_maps"][table.name] = figures(table);
    root["real_maps"][table.name]["seed"] = report.seed;
  }
  for (const LogTable & table : report.logs) {
    root["real_logs"][table.name] = figures(table);
    root["real_logs"][table.name]["seed"] = report.seed;
  }
  return root.dump(2) + '\n';
}

}  // namespace stetro_bringup
