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

#include "sim/random_stream.hpp"

#include <cmath>

namespace stetro_driver::sim
{
namespace
{

constexpr double kTwoPi = 6.28318530717958647692;

std::uint64_t mixed(std::uint64_t word)
{
  word = (word ^ (word >> 30U)) * 0xbf58476d1ce4e5b9ULL;
  word = (word ^ (word >> 27U)) * 0x94d049bb133111ebULL;
  return word ^ (word >> 31U);
}

}  // namespace

RandomStream::RandomStream(std::uint64_t seed, std::string_view name)
{
  std::uint64_t hash = 0xcbf29ce484222325ULL;  // FNV-1a
  for (const char letter : name) {
    hash = (hash ^ static_cast<unsigned char>(letter)) * 0x100000001b3ULL;
  }
  state_ = mixed(mixed(seed + 0x9e3779b97f4a7c15ULL) ^ hash);
}

std::uint64_t RandomStream::next()
{
  state_ += 0x9e3779b97f4a7c15ULL;
  return mixed(state_);
}

double RandomStream::uniform() { return static_cast<double>(next() >> 11U) * 0x1.0p-53; }

double RandomStream::uniform(double low, double high) { return low + (high - low) * uniform(); }

double RandomStream::normal(double std_dev)
{
  const double radius = std::sqrt(-2.0 * std::log(1.0 - uniform()));
  return std_dev * radius * std::cos(kTwoPi * uniform());
}

double RandomStream::normal_within(double std_dev, double limit)
{
  if (std_dev <= 0.0 || limit <= 0.0) {
    return 0.0;
  }
  double value = normal(std_dev);
  while (std::abs(value) > limit) {
    value = normal(std_dev);
  }
  return value;
}

Wander::Wander(double std_dev, double time_constant_s, RandomStream & random)
: std_dev_(std_dev), time_constant_s_(time_constant_s), value_(random.normal(std_dev))
{
}

double Wander::step(double dt_s, RandomStream & random)
{
  const double kept = std::exp(-dt_s / time_constant_s_);
  value_ = kept * value_ + random.normal(std_dev_ * std::sqrt(1.0 - kept * kept));
  return value_;
}

}  // namespace stetro_driver::sim
