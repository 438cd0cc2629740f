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

#ifndef STETRO_MSGS__BOUNDS_HPP_
#define STETRO_MSGS__BOUNDS_HPP_

#include <algorithm>
#include <array>
#include <cstddef>
#include <string>
#include <type_traits>
#include <vector>

#include "fastrtps/utils/fixed_size_string.hpp"

namespace stetro_msgs
{

/// Whether no sequence in a message, however deep, is longer than its IDL allows.
/**
 * The generated code reads and writes any length (Fast CDR 1.0 does not know the bound), a ROS 2
 * reader throws the sample away. Ask before writing and after reading. `message` is any message of
 * this package; include its header "stetro_msgs/<Type>.hpp".
 */
template <class Message>
[[nodiscard]] bool within_bounds(const Message & message);

/// Whether a bounded string in a message, however deep, is filled to its last byte.
/**
 * The C++ type of string<N> cuts in silence what is longer, on assignment and on reading, so a
 * string that fills its bound may be the stump of a longer one. Two ids that differ only behind
 * the bound become equal that way: refuse a full id where identity matters.
 */
template <class Message>
[[nodiscard]] bool fills_a_string(const Message & message);

namespace detail
{

template <class T>
struct IsFixedString : std::false_type
{
};
template <std::size_t N>
struct IsFixedString<eprosima::fastrtps::fixed_string<N>> : std::true_type
{
};

template <class T>
struct IsList : std::false_type
{
};
template <class T>
struct IsList<std::vector<T>> : std::true_type
{
};
template <class T, std::size_t N>
struct IsList<std::array<T, N>> : std::true_type
{
};

/// A message has members to visit; numbers and strings have none.
template <class T>
constexpr bool kIsMessage = std::is_class_v<T> && !std::is_same_v<T, std::string> &&
                            !IsFixedString<T>::value && !IsList<T>::value;

template <class T>
bool within(const T & value, std::size_t bound)
{
  if constexpr (IsList<T>::value) {
    if (bound != 0 && value.size() > bound) {
      return false;
    }
    if constexpr (kIsMessage<typename T::value_type>) {
      return std::all_of(
        value.begin(), value.end(), [](const auto & item) { return within_bounds(item); });
    }
  } else if constexpr (kIsMessage<T>) {
    return within_bounds(value);
  }
  return true;
}

template <class T>
bool fills(const T & value, std::size_t bound)
{
  if constexpr (IsFixedString<T>::value) {
    return value.size() >= bound;
  } else if constexpr (IsList<T>::value) {
    if constexpr (kIsMessage<typename T::value_type>) {
      return std::any_of(
        value.begin(), value.end(), [](const auto & item) { return fills_a_string(item); });
    }
  } else if constexpr (kIsMessage<T>) {
    return fills_a_string(value);
  }
  return false;
}

}  // namespace detail

template <class Message>
bool within_bounds(const Message & message)
{
  bool result = true;
  for_each_member(message, [&result](const char *, const auto & value, std::size_t bound) {
    result = result && detail::within(value, bound);
  });
  return result;
}

template <class Message>
bool fills_a_string(const Message & message)
{
  bool result = false;
  for_each_member(message, [&result](const char *, const auto & value, std::size_t bound) {
    result = result || detail::fills(value, bound);
  });
  return result;
}

}  // namespace stetro_msgs

#endif  // STETRO_MSGS__BOUNDS_HPP_
