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
#include "stetro_bringup/trace.hpp"

#include <cmath>
#include <cstdio>
#include <ostream>

namespace stetro_bringup
{
namespace
{

void put(std::ostream & out, const StairSample & sample)
{
  out << ',' << sample.step;
  for (const double value :
       {sample.x_m, sample.y_m, sample.z_m, sample.heading_rad, sample.tread_x_m,
        sample.tread_y_m}) {
    put_field(out, value);
  }
}

constexpr const char * kPoseColumns[] = {"step",        "x_m",       "y_m",      "z_m",
                                         "heading_rad", "tread_x_m", "tread_y_m"};

}  // namespace

void put_field(std::ostream & out, double value)
{
  out << ',';
  if (std::isnan(value)) {
    return;  // unknown
  }
  if (std::isinf(value)) {
    out << (value > 0 ? "inf" : "-inf");
    return;
  }
  std::array<char, 64> text{};
  std::snprintf(text.data(), text.size(), "%.6f", value);
  out << text.data();
}

TraceWriter::TraceWriter(std::ostream & out) : out_(out)
{
  out_ << "stamp_ns";
  for (const char * prefix : {"", "true_"}) {
    for (const char * column : kPoseColumns) {
      out_ << ',' << prefix << column;
    }
  }
  out_ << ",sigma_x_m,sigma_y_m,sigma_z_m,sigma_heading_rad,integrity,reasons";
  for (const char * sensor : kTraceSensors) {
    out_ << ',' << sensor << "_m," << sensor << "_outcome";
  }
  out_ << ",segment,true_segment\n";
}

void TraceWriter::write(const TraceRow & row)
{
  out_ << row.estimate.stamp.count();
  put(out_, row.estimate);
  if (row.truth) {
    put(out_, *row.truth);
  } else {
    out_ << std::string(std::size(kPoseColumns), ',');
  }
  for (const double sigma : {row.sigma.x_m, row.sigma.y_m, row.sigma.z_m, row.sigma.heading_rad}) {
    put_field(out_, sigma);
  }
  out_ << ',' << row.integrity << ',' << row.reasons;
  for (const char * sensor : kTraceSensors) {
    const auto found = row.sensors.find(sensor);
    if (found == row.sensors.end()) {
      out_ << ",,";
      continue;
    }
    put_field(out_, found->second.range_m);
    out_ << ',' << found->second.outcome;
  }
  out_ << ',' << row.estimate.segment << ',' << (row.truth ? row.truth->segment : "") << '\n';
}

}  // namespace stetro_bringup
