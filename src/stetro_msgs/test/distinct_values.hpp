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

#ifndef DISTINCT_VALUES_HPP_
#define DISTINCT_VALUES_HPP_

#include <cmath>
#include <cstdint>
#include <limits>
#include <string>
#include <type_traits>
#include <vector>

#include "stetro_msgs/bounds.hpp"

namespace stetro_msgs
{

/// Gives every field of a message a value of its own, so that no two can be mistaken.
class DistinctValues
{
public:
  /// \param special whether some reals become NaN and infinite, as ranges on the wire do
  explicit DistinctValues(bool special = false) : special_{special} {}

  template <class Message>
  Message make()
  {
    Message message;
    fill(message, 0);
    return message;
  }

private:
  template <class T>
  void fill(T & value, std::size_t bound)
  {
    if constexpr (std::is_same_v<T, bool>) {
      value = ++count_ % 2 == 1;
    } else if constexpr (std::is_floating_point_v<T>) {
      value = real<T>();
    } else if constexpr (std::is_arithmetic_v<T>) {
      fill_integer(value);
    } else if constexpr (detail::IsList<T>::value) {
      fill_list(value, bound);
    } else if constexpr (detail::kIsMessage<T>) {
      for_each_member(value, [this](const char *, auto & member, std::size_t member_bound) {
        this->fill(member, member_bound);
      });
    } else {
      value = std::string{"h\u00f6he_"} + std::to_string(++count_);
    }
  }

  /// Large enough to use every byte of the type, odd enough to be negative where it may.
  template <class T>
  void fill_integer(T & value)
  {
    ++count_;
    const auto high = static_cast<std::uint64_t>(count_) << (8 * (sizeof(T) - 1));
    value = static_cast<T>(high + static_cast<std::uint64_t>(3 * count_));
    value = std::is_signed_v<T> && count_ % 2 == 1 ? static_cast<T>(-value) : value;
  }

  /// Multiples of 1/8 are exact as float and as double.
  template <class T>
  T real()
  {
    ++count_;
    if (special_ && count_ % 7 == 3) {
      return count_ % 2 == 0 ? std::numeric_limits<T>::infinity()
                             : -std::numeric_limits<T>::infinity();
    }
    if (special_ && count_ % 11 == 5) {
      return std::numeric_limits<T>::quiet_NaN();
    }
    return static_cast<T>(count_) + static_cast<T>(0.125);
  }

  template <class List>
  void fill_list(List & list, std::size_t bound)
  {
    if constexpr (std::is_same_v<List, std::vector<typename List::value_type>>) {
      list.resize(bound == 0 ? 3 : bound);
    }
    for (auto & item : list) {
      fill(item, 0);
    }
  }

  bool special_;
  int count_ = 0;
};

}  // namespace stetro_msgs

#endif  // DISTINCT_VALUES_HPP_
