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

#include "stetro_localizer/stored_state.hpp"

#include <array>
#include <charconv>
#include <cmath>
#include <cstdint>
#include <map>
#include <sstream>
#include <system_error>

namespace stetro_localizer
{
namespace
{

std::string exact(double number)
{
  std::array<char, 32> text{};
  const auto end = std::to_chars(text.data(), text.data() + text.size(), number).ptr;
  return {text.data(), end};
}

// One list of the numbers, for both directions. Each(name, number).
template <class State, class Each>
void each_number(State & state, Each && each)
{
  const auto scalar = [&each](const std::string & name, auto & estimate) {
    each(name + ".value", estimate.value);
    each(name + ".variance", estimate.variance);
  };
  const auto range = [&](const std::string & name, auto & offset) {
    scalar(name, offset.offset);
    each(name + ".calibrated_at_m", offset.calibrated_at_m);
  };
  range("side_left", state.calibration.left);
  range("side_right", state.calibration.right);
  range("front_difference", state.calibration.front_difference);
  scalar("gyro_bias", state.calibration.gyro_bias);
  if (state.fused) {
    for (std::size_t i = 0; i < FusedCalibration::kSize; ++i) {
      each("fused.value." + std::to_string(i), state.fused->value[i]);
      for (std::size_t j = 0; j < FusedCalibration::kSize; ++j) {
        each(
          "fused.covariance." + std::to_string(i) + '.' + std::to_string(j),
          state.fused->covariance[i][j]);
      }
    }
  }
  if (state.step) {
    each("step.lift_off_offset_m", state.step->lift_off_offset_m);
    each("step.lift_off_reference_m", state.step->lift_off_reference_m);
    for (std::size_t i = 0; i < 3; ++i) {
      each("step.height_m." + std::to_string(i + 1), state.step->pattern.height_m[i]);
    }
  }
}

std::string bearing_text(const BlockPattern & pattern)
{
  std::string text;
  for (const bool bears : pattern.bearing) {
    text += bears ? '1' : '0';
  }
  return text;
}

template <class Number>
bool read_number(const std::string & text, Number & number)
{
  const char * end = text.data() + text.size();
  const auto result = std::from_chars(text.data(), end, number);
  return result.ec == std::errc{} && result.ptr == end;
}

using Lines = std::map<std::string, std::string>;

Lines lines_of(const std::string & text)
{
  Lines lines;
  std::istringstream stream(text);
  for (std::string line; std::getline(stream, line);) {
    const std::size_t space = line.find(' ');
    lines[line.substr(0, space)] = space == std::string::npos ? "" : line.substr(space + 1);
  }
  return lines;
}

bool read_step(const Lines & lines, StoredState & state)
{
  const auto index = lines.find("step.index");
  if (index == lines.end()) {
    return true;  // the step was unknown
  }
  const auto bearing = lines.find("step.bearing");
  if (bearing == lines.end() || bearing->second.size() != 3) {
    return false;
  }
  state.step.emplace();
  for (std::size_t i = 0; i < 3; ++i) {
    state.step->pattern.bearing[i] = bearing->second[i] == '1';
  }
  return read_number(index->second, state.step->step);
}

}  // namespace

std::string to_text(const StoredState & state)
{
  // The key is older than floors.
  std::string text = "flight_id " + state.segment_id + "\n";
  text += "reset_counter " + std::to_string(state.reset_counter) + "\n";
  if (state.step) {
    text += "step.index " + std::to_string(state.step->step) + "\n";
    text += "step.bearing " + bearing_text(state.step->pattern) + "\n";
  }
  each_number(state, [&text](const std::string & name, double number) {
    text += name + " " + exact(number) + "\n";
  });
  return text;
}

std::optional<StoredState> parse_stored_state(const std::string & text, std::string & why)
{
  const Lines lines = lines_of(text);
  StoredState state;
  const auto flight = lines.find("flight_id");
  const auto resets = lines.find("reset_counter");
  bool whole = flight != lines.end() && resets != lines.end() &&
               read_number(resets->second, state.reset_counter) && read_step(lines, state);
  if (lines.count("fused.value.0") > 0) {
    state.fused.emplace();
  }
  each_number(state, [&](const std::string & name, double & number) {
    const auto line = lines.find(name);
    whole =
      whole && line != lines.end() && read_number(line->second, number) && std::isfinite(number);
  });
  if (!whole) {
    why = "a line is missing or is not what it should be";
    return std::nullopt;
  }
  state.segment_id = flight->second;
  return state;
}

}  // namespace stetro_localizer
