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

#ifndef STETRO_LOCALIZER__STEP_BELIEF_HPP_
#define STETRO_LOCALIZER__STEP_BELIEF_HPP_

#include <array>
#include <cstddef>

namespace stetro_localizer
{

/// A step and how probable it is.
struct StepProbability
{
  int step = 0;
  double probability = 0.0;
};

/// Probabilities of the step index: a window around the most probable one, and what is not in it.
/**
 * A lift cycle moves by one tread, so that few steps ever have a share. What leaves the window, and
 * what no tread explains, is `elsewhere`. Fixed size, trivially copyable.
 */
class StepBelief
{
public:
  static constexpr int kWidth = 9;

  /// Certain of one step.
  static StepBelief at(int step)
  {
    StepBelief belief;
    belief.first_ = step - kWidth / 2;
    belief.share_[kWidth / 2] = 1.0;
    return belief;
  }

  /// Without any share, around the most probable step of another.
  static StepBelief around(const StepBelief & other)
  {
    StepBelief belief;
    belief.first_ = other.best().step - kWidth / 2;
    return belief;
  }

  [[nodiscard]] int first() const { return first_; }
  [[nodiscard]] int last() const { return first_ + kWidth - 1; }
  [[nodiscard]] double of(int step) const
  {
    return step < first_ || step > last() ? 0.0 : share_[static_cast<std::size_t>(step - first_)];
  }
  [[nodiscard]] double elsewhere() const { return elsewhere_; }

  void add(int step, double share)
  {
    (step < first_ || step > last() ? elsewhere_
                                    : share_[static_cast<std::size_t>(step - first_)]) += share;
  }
  void add_elsewhere(double share) { elsewhere_ += share; }
  void scale(int step, double factor)
  {
    if (step >= first_ && step <= last()) {
      share_[static_cast<std::size_t>(step - first_)] *= factor;
    }
  }

  /// Sum of all shares in the window.
  [[nodiscard]] double within() const
  {
    double sum = 0.0;
    for (const double share : share_) {
      sum += share;
    }
    return sum;
  }
  /// Makes the shares add up to one. \return false if there was none
  bool normalise()
  {
    const double sum = within() + elsewhere_;
    if (!(sum > 0.0)) {
      return false;
    }
    for (double & share : share_) {
      share /= sum;
    }
    elsewhere_ /= sum;
    return true;
  }

  [[nodiscard]] StepProbability best() const { return best_but(last() + 1); }
  /// The second most probable step.
  [[nodiscard]] StepProbability runner_up() const { return best_but(best().step); }

private:
  [[nodiscard]] StepProbability best_but(int excluded) const
  {
    StepProbability best{excluded == first_ ? first_ + 1 : first_, -1.0};
    for (int step = first_; step <= last(); ++step) {
      if (step != excluded && of(step) > best.probability) {
        best = {step, of(step)};
      }
    }
    return best;
  }

  std::array<double, kWidth> share_{};
  double elsewhere_ = 0.0;
  int first_ = 0;
};

}  // namespace stetro_localizer

#endif  // STETRO_LOCALIZER__STEP_BELIEF_HPP_
