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

#include "profiles/profiles_table.hpp"

#include <iomanip>
#include <sstream>

#include "profiles/median.hpp"

namespace stetro_bringup
{
namespace
{

double percent(std::size_t part, std::size_t whole)
{
  return whole == 0 ? 0.0 : 100.0 * static_cast<double>(part) / static_cast<double>(whole);
}

/// The cells of a row after its name, right-aligned.
class Row
{
public:
  Row(std::ostream & out, const std::string & name) : out_(out)
  {
    out_ << std::left << std::setw(36) << name << std::right << std::fixed;
  }
  ~Row() { out_ << '\n'; }
  Row(const Row &) = delete;
  Row & operator=(const Row &) = delete;

  Row & number(double value, int decimals)
  {
    out_ << std::setprecision(decimals) << std::setw(12) << value;
    return *this;
  }
  Row & count(std::size_t value)
  {
    out_ << std::setw(12) << value;
    return *this;
  }
  Row & words(const char * value)
  {
    out_ << std::setw(12) << value;
    return *this;
  }

private:
  std::ostream & out_;
};

void print(std::ostream & out, const std::string & name, const RoomsScore & score)
{
  Row(out, name)
    .number(percent(score.within_1, score.cases), 2)
    .number(percent(score.within_01, score.cases), 2)
    .count(score.no_verdict)
    .count(score.ambiguous)
    .count(score.ambiguous_right)
    .count(score.false_accepts)
    .number(score.median_us(), 0);
}

void print(std::ostream & out, const std::string & name, const MapsScore & score)
{
  if (score.cases > 0) {
    Row(out, name)
      .count(score.cases)
      .number(percent(score.solved, score.cases), 2)
      .count(score.no_verdict)
      .count(score.ambiguous)
      .count(score.free_direction_shown)
      .count(score.false_accepts)
      .number(median(score.us), 0);
  }
}

void print_rooms(std::ostream & out, const ProfilesReport & report)
{
  Row(out, "rooms of 100 x 100 units")
    .words("< 1 %")
    .words("< 0.1 %")
    .words("no verdict")
    .words("ambiguous")
    .words("right")
    .words("false")
    .words("median us");
  for (const RoomsTable & table : report.rooms) {
    print(out, table.kind.name + " published", table.published);
    print(out, table.kind.name + " trusted", table.trusted);
  }
}

void print_maps(std::ostream & out, const ProfilesReport & report)
{
  Row(out, "maps")
    .words("cases")
    .words("< 5 cm %")
    .words("no verdict")
    .words("ambiguous")
    .words("free shown")
    .words("false")
    .words("median us");
  for (const MapsTable & table : report.maps) {
    print(out, table.name + " published", table.published);
    print(out, table.name + " trusted, determined", table.determined);
    print(out, table.name + " trusted, elsewhere", table.elsewhere);
    print(out, table.name + " rough world, determined", table.rough_determined);
    print(out, table.name + " rough world, elsewhere", table.rough_elsewhere);
  }
}

void print_radii(std::ostream & out, const ProfilesReport & report)
{
  Row(out, "spectral radius of a centroid step")
    .words("guarded")
    .words("below 1 %")
    .words("published")
    .words("below 1 %");
  for (const MapsTable & table : report.maps) {
    Row(out, table.name)
      .number(table.guarded_radius.median, 2)
      .number(100.0 * table.guarded_radius.share_below_1, 0)
      .number(table.published_radius.median, 2)
      .number(100.0 * table.published_radius.share_below_1, 0);
  }
}

void print_logs(std::ostream & out, const ProfilesReport & report)
{
  Row(out, "recorded scans")
    .words("cases")
    .words("right %")
    .words("no verdict")
    .words("ambiguous")
    .words("by ends")
    .words("> 25 cm")
    .words("median us");
  for (const LogTable & table : report.logs) {
    const LogSummary sum = summary_of(table);
    Row(out, table.name + " published")
      .count(sum.cases)
      .number(percent(sum.published_right, sum.cases), 2)
      .count(0)
      .count(0)
      .count(0)
      .count(sum.published_far_off)
      .number(sum.published_median_us, 0);
    Row(out, table.name + " trusted")
      .count(sum.cases)
      .number(percent(sum.right, sum.cases), 2)
      .count(sum.no_verdict)
      .count(sum.ambiguous)
      .count(sum.by_ends)
      .count(sum.false_accepts)
      .number(sum.median_us, 0);
  }
}

}  // namespace

std::string profiles_table(const ProfilesReport & report)
{
  std::ostringstream out;
  if (!report.rooms.empty()) {
    print_rooms(out, report);
  }
  if (!report.maps.empty()) {
    print_maps(out, report);
    print_radii(out, report);
  }
  if (!report.logs.empty()) {
    print_logs(out, report);
  }
  return out.str();
}

}  // namespace stetro_bringup
