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

#ifndef STETRO_CONFIG__RULE_HPP_
#define STETRO_CONFIG__RULE_HPP_

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <string>
#include <vector>

#include "stetro_config/value.hpp"

/// \file
/// Rules say which values a key accepts, to the program and in words.
/**
 * A rule is any type with `bool accepts(const T &) const` for the field's type T, and
 * `std::string words() const` that continues "a finite number, ...". NaN and infinity never reach
 * a rule. Numbers compare as doubles, so bounds of integers are exact up to 2^53.
 */

namespace stetro_config
{

/// Every value of the type.
struct Any
{
  template <class T>
  [[nodiscard]] bool accepts(const T &) const
  {
    return true;
  }
  [[nodiscard]] std::string words() const { return ""; }
};

/// The closed interval [lo, hi].
struct Within
{
  double lo;
  double hi;
  [[nodiscard]] bool accepts(double value) const { return lo <= value && value <= hi; }
  [[nodiscard]] bool accepts(std::int64_t value) const
  {
    return accepts(static_cast<double>(value));
  }
  [[nodiscard]] std::string words() const { return to_text(lo) + " to " + to_text(hi); }
};

/// lo or more.
struct AtLeast
{
  double lo;
  [[nodiscard]] bool accepts(double value) const { return lo <= value; }
  [[nodiscard]] bool accepts(std::int64_t value) const
  {
    return accepts(static_cast<double>(value));
  }
  [[nodiscard]] std::string words() const { return "at least " + to_text(lo); }
};

/// More than lo, which itself is refused.
struct MoreThan
{
  double lo;
  [[nodiscard]] bool accepts(double value) const { return lo < value; }
  [[nodiscard]] bool accepts(std::int64_t value) const
  {
    return accepts(static_cast<double>(value));
  }
  [[nodiscard]] std::string words() const { return "more than " + to_text(lo); }
};

/// One of the given texts, e.g. `OneOf{"paper", "fused"}`.
struct OneOf
{
  template <class... Texts>
  explicit OneOf(Texts... texts) : choices{std::string(texts)...}
  {
  }
  [[nodiscard]] bool accepts(const std::string & value) const
  {
    return std::find(choices.begin(), choices.end(), value) != choices.end();
  }
  [[nodiscard]] std::string words() const;

  std::vector<std::string> choices;
};

/// A text or list that is not empty.
struct NonEmpty
{
  template <class T>
  [[nodiscard]] bool accepts(const T & value) const
  {
    return !value.empty();
  }
  [[nodiscard]] std::string words() const { return "not empty"; }
};

/// A name that can be a frame, a topic or a file: a lower-case letter, then letters, digits, `_`.
struct Identifier
{
  [[nodiscard]] bool accepts(const std::string & value) const;
  [[nodiscard]] std::string words() const;
};

/// A list with `least` to `most` elements, each accepted by a rule.
template <class Rule>
struct Each
{
  Rule rule;
  std::size_t least = 0;
  std::size_t most = std::numeric_limits<std::size_t>::max();

  template <class T>
  [[nodiscard]] bool accepts(const std::vector<T> & list) const
  {
    return least <= list.size() && list.size() <= most &&
           std::all_of(list.begin(), list.end(), [&](const T & x) { return rule.accepts(x); });
  }
  [[nodiscard]] std::string words() const
  {
    std::string text = count_words();
    const std::string each = rule.words();
    if (!each.empty()) {
      text += (text.empty() ? "each " : ", each ") + each;
    }
    return text;
  }

private:
  [[nodiscard]] std::string count_words() const
  {
    if (least == most) {
      return std::to_string(least) + " of them";
    }
    std::string text = least > 0 ? "at least " + std::to_string(least) + " of them" : "";
    if (most != std::numeric_limits<std::size_t>::max()) {
      text += (text.empty() ? "at most " : ", at most ") + std::to_string(most) + " of them";
    }
    return text;
  }
};

template <class Rule, class... Counts>
Each(Rule, Counts...) -> Each<Rule>;

/// What a key accepts, for a fault: "a finite number, 0.0001 to 0.1".
template <class Rule>
[[nodiscard]] std::string accepted_words(Kind kind, const Rule & rule)
{
  const std::string words = rule.words();
  return words.empty() ? describe(kind) : describe(kind) + ", " + words;
}

}  // namespace stetro_config

#endif  // STETRO_CONFIG__RULE_HPP_
