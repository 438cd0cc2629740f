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
#include "stetro_supervisor/mission_record.hpp"

#include <algorithm>
#include <cmath>
#include <iomanip>
#include <limits>
#include <sstream>

#include "stetro_config/kept_file.hpp"

namespace stetro_supervisor
{
namespace
{

constexpr std::size_t kMostTreads = 256;  // as MissionStatus carries

stetro_config::KeptFile file_at(const std::string & path)
{
  return {path, "stetro_mission 1", stetro_config::Seal::kCrc32};
}

template <class T>
T read_value(std::istream & in, const std::string & key)
{
  std::string found;
  T value{};
  if (!(in >> found) || found != key || !(in >> value)) {
    throw MissionFileError("mission file: '" + key + "' expected, '" + found + "' found");
  }
  return value;
}

std::string read_quoted(std::istream & in, const std::string & key)
{
  std::string found;
  std::string value;
  if (!(in >> found) || found != key || !(in >> std::quoted(value))) {
    throw MissionFileError("mission file: '" + key + "' expected, '" + found + "' found");
  }
  return value;
}

}  // namespace

void Swept::pass(double y_m)
{
  y_min_m = started ? std::min(y_min_m, y_m) : y_m;
  y_max_m = started ? std::max(y_max_m, y_m) : y_m;
  started = true;
}

double Swept::share(double width_m, double contact_width_m) const
{
  return started ? std::min(1.0, (y_max_m - y_min_m + contact_width_m) / width_m) : 0.0;
}

std::string encode(const MissionRecord & record)
{
  std::ostringstream out;
  out << std::setprecision(std::numeric_limits<double>::max_digits10);
  out << "active " << record.active << "\n"
      << "segment " << std::quoted(record.segment_id) << "\n"
      << "request " << std::quoted(record.request_id) << "\n"
      << "issuer " << std::quoted(record.issuer) << "\n"
      << "state " << to_string(record.state) << "\n"
      << "step " << record.step << "\n"
      << "leg " << to_string(record.leg) << "\n"
      << "rolled_m " << record.rolled_m << "\n"
      << "treads " << record.swept.size() << "\n";
  for (const Swept & swept : record.swept) {
    out << "swept " << swept.started << " " << swept.y_min_m << " " << swept.y_max_m << "\n";
  }
  if (!record.goal.empty()) {
    out << "goal " << std::quoted(record.goal) << "\n";
  }
  return out.str();
}

MissionRecord decode(const std::string & text)
{
  std::istringstream in{text};
  MissionRecord record;
  record.active = read_value<bool>(in, "active");
  record.segment_id = read_quoted(in, "segment");
  record.request_id = read_quoted(in, "request");
  record.issuer = read_quoted(in, "issuer");
  const auto state = state_named(read_value<std::string>(in, "state"));
  record.step = read_value<int>(in, "step");
  const auto leg = leg_named(read_value<std::string>(in, "leg"));
  record.rolled_m = read_value<double>(in, "rolled_m");
  const auto treads = read_value<std::size_t>(in, "treads");
  if (!state || !leg || treads > kMostTreads || !std::isfinite(record.rolled_m)) {
    throw MissionFileError("mission file: unknown state or leg, or a number out of bounds");
  }
  record.state = *state;
  record.leg = *leg;
  for (std::size_t i = 0; i < treads; ++i) {
    Swept swept;
    swept.started = read_value<bool>(in, "swept");
    if (!(in >> swept.y_min_m >> swept.y_max_m)) {
      throw MissionFileError("mission file: two numbers expected after 'swept'");
    }
    record.swept.push_back(swept);
  }
  if (!(in >> std::ws).eof()) {
    record.goal = read_quoted(in, "goal");
  }
  return record;
}

void save(const MissionRecord & record, const std::string & path)
{
  if (const auto why = file_at(path).replace(encode(record))) {
    throw MissionFileError("mission file: " + *why);
  }
}

std::optional<MissionRecord> load_mission(const std::string & path)
{
  using Kind = stetro_config::KeptReading::Kind;
  const auto kept = file_at(path).read();
  if (kept.kind == Kind::kDamaged) {
    throw MissionFileError("mission file: " + kept.why);
  }
  return kept.kind == Kind::kFound ? std::optional{decode(kept.lines)} : std::nullopt;
}

}  // namespace stetro_supervisor
