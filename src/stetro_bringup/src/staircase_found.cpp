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
#include "stetro_bringup/staircase_found.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <cstdlib>

namespace stetro_bringup
{
namespace
{

/// The whole of `text` is so many numbers.
template <std::size_t Count>
bool read(const std::string & text, std::array<double, Count> & numbers)
{
  const char * at = text.c_str();
  for (double & number : numbers) {
    char * end = nullptr;
    number = std::strtod(at, &end);
    if (end == at) {
      return false;
    }
    at = end;
  }
  return *at == '\0';
}

bool ends_with(const std::string & text, const std::string & end)
{
  return text.size() >= end.size() && text.compare(text.size() - end.size(), end.size(), end) == 0;
}

void note_step(StaircaseFound & staircase, const std::string & key, const std::string & value)
{
  int step = 0;
  std::array<char, 16> measure{};
  if (std::sscanf(key.c_str(), "step %d: %15[a-z]", &step, measure.data()) != 2) {
    return;
  }
  std::array<double, 4> found{};
  std::array<double, 3> deviation{};
  if (ends_with(key, ": tread, sigma, width, sigma [m]") && read(value, found)) {
    staircase.steps.push_back({step, found[0], found[1], found[2], found[3]});
  } else if (ends_with(key, ", sigma, site file [m]") && read(value, deviation)) {
    staircase.deviations.push_back(
      {step, measure.data(), deviation[0], deviation[1], deviation[2]});
  }
}

}  // namespace

std::size_t StaircaseFound::treads_measured() const
{
  return static_cast<std::size_t>(std::count_if(
    steps.begin(), steps.end(), [](const StepFound & one) { return std::isfinite(one.tread_m); }));
}

void note(StaircaseFound & staircase, const std::string & key, const std::string & value)
{
  std::array<double, 1> number{};
  if (key == "largest deviation [m]" && read(value, number)) {
    staircase.largest_deviation_m = number[0];
  } else if (key == "largest deviation of") {
    staircase.largest_deviation_of = value;
  } else {
    note_step(staircase, key, value);
  }
}

}  // namespace stetro_bringup
