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

#ifndef SIM__RANDOM_STREAM_HPP_
#define SIM__RANDOM_STREAM_HPP_

#include <cstdint>
#include <string_view>

namespace stetro_driver::sim
{

/// A stream of random numbers of its own: what one sensor draws never shifts another's.
/**
 * SplitMix64 (Steele, Lea and Flood, Fast splittable pseudorandom number generators, OOPSLA 2014):
 * one word of state, so that a snapshot of forty streams is forty words, and the same bits with
 * every standard library.
 */
class RandomStream
{
public:
  RandomStream() = default;

  /// \param seed of the world \param name of the stream; equal names draw equal numbers
  RandomStream(std::uint64_t seed, std::string_view name);

  [[nodiscard]] std::uint64_t next();

  /// Evenly in [0, 1).
  [[nodiscard]] double uniform();

  /// Evenly in [low, high).
  [[nodiscard]] double uniform(double low, double high);

  /// Normal, mean 0, by Box and Muller without keeping the second number.
  [[nodiscard]] double normal(double std_dev);

  /// Normal, drawn again until it lies within +-limit.
  [[nodiscard]] double normal_within(double std_dev, double limit);

  template <class Archive>
  void archive(Archive & each)
  {
    each(state_);
  }

private:
  std::uint64_t state_ = 0;
};

/// A value that wanders around zero: first-order Gauss-Markov.
class Wander
{
public:
  Wander() = default;

  /// Starts in its stationary distribution.
  Wander(double std_dev, double time_constant_s, RandomStream & random);

  /// Advances by dt and returns the value.
  double step(double dt_s, RandomStream & random);

  [[nodiscard]] double value() const { return value_; }

  template <class Archive>
  void archive(Archive & each)
  {
    each(value_);
  }

private:
  double std_dev_ = 0.0;
  double time_constant_s_ = 1.0;
  double value_ = 0.0;
};

}  // namespace stetro_driver::sim

#endif  // SIM__RANDOM_STREAM_HPP_
