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

#ifndef STETRO_DDS__ENDPOINT_HPP_
#define STETRO_DDS__ENDPOINT_HPP_

#include <array>
#include <atomic>
#include <cstdint>
#include <string>
#include <utility>

#include "stetro_dds/qos.hpp"

namespace stetro_dds
{

/// The 16 bytes that name an endpoint on the wire: 12 of its participant, 4 of its own.
using Guid = std::array<std::uint8_t, 16>;

/// "010f1234.56789abc.def01234|00000103"
std::string to_string(const Guid & guid);

/// What publishers and subscriptions have in common.
class Endpoint
{
public:
  Endpoint(std::string topic, std::string type_name, const QosProfile & profile)
  : topic_(std::move(topic)), type_name_(std::move(type_name)), profile_(profile)
  {
  }
  virtual ~Endpoint() = default;
  Endpoint(const Endpoint &) = delete;
  Endpoint & operator=(const Endpoint &) = delete;

  [[nodiscard]] const std::string & topic() const { return topic_; }  ///< absolute ROS name
  [[nodiscard]] const std::string & type_name() const { return type_name_; }
  [[nodiscard]] const QosProfile & profile() const { return profile_; }
  [[nodiscard]] int matched() const { return matched_; }  ///< peers exchanging data with it now
  [[nodiscard]] virtual Guid guid() const = 0;

protected:
  std::atomic<int> matched_{0};

private:
  const std::string topic_;
  const std::string type_name_;
  const QosProfile profile_;
};

}  // namespace stetro_dds

#endif  // STETRO_DDS__ENDPOINT_HPP_
