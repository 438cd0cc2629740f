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

// Writes every message with a value of its own in every field, as the bytes of its payload and as
// what a reader has to find in them. Readers in other languages check themselves against it.
// usage: write_payloads FILE.json

#include <cmath>
#include <exception>
#include <fstream>
#include <iostream>
#include <string>

#include "distinct_values.hpp"
#include "nlohmann/json.hpp"
#include "payload.hpp"
#include "stetro_msgs/all_messages.hpp"

namespace
{

using nlohmann::json;

/// JSON has neither 64-bit integers nor NaN: both become text.
template <class T>
json to_json(const T & value)
{
  if constexpr (std::is_floating_point_v<T>) {
    return std::isfinite(value) ? json(value) : json(std::to_string(value));
  } else if constexpr (std::is_integral_v<T> && sizeof(T) == 8) {
    return std::to_string(value);
  } else if constexpr (std::is_arithmetic_v<T>) {
    return value;
  } else if constexpr (stetro_msgs::detail::IsList<T>::value) {
    auto list = json::array();
    for (const auto & item : value) {
      list.push_back(to_json(item));
    }
    return list;
  } else if constexpr (stetro_msgs::detail::kIsMessage<T>) {
    auto object = json::object();
    for_each_member(value, [&object](const char * name, const auto & member, std::size_t) {
      object[name] = to_json(member);
    });
    return object;
  } else {
    return std::string{value.c_str()};
  }
}

json samples()
{
  auto list = json::array();
  stetro_msgs::for_each_message_type([&list](const char * file, auto type) {
    using Message = typename decltype(type)::type;
    const auto message = stetro_msgs::DistinctValues{true}.make<Message>();
    list.push_back(
      {{"file", file},
       {"dds_type", stetro_msgs::SupportOf<Message>{}.getName()},
       {"payload", stetro_msgs::to_hex(message)},
       {"value", to_json(message)}});
  });
  return list;
}

}  // namespace

int main(int argc, char ** argv)
try {
  if (argc != 2) {
    std::cerr << "usage: write_payloads FILE.json\n";
    return 2;
  }
  std::ofstream out{argv[1]};
  out << samples().dump(1) << '\n';
  return out.good() ? 0 : 1;
} catch (const std::exception & error) {
  std::cerr << "write_payloads: " << error.what() << '\n';
  return 1;
}
