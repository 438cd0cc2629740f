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

#ifndef STETRO_DRIVER__RESULT_HPP_
#define STETRO_DRIVER__RESULT_HPP_

#include <cassert>
#include <optional>
#include <stdexcept>
#include <string>
#include <utility>

namespace stetro_driver
{

/// What kind of trouble the hardware is in.
enum class IoFaultKind {
  kNotConfigured,  ///< asked before configure()
  kNotActive,      ///< asked to move without power
  kEmergencyStop,  ///< the emergency stop is latched
  kFallen,         ///< the robot lost its support: nothing it does helps
  kSilent,         ///< a device does not answer
  kBadAnswer,      ///< a device answers nonsense
  kBadCommand,     ///< asked for something that makes no sense
  kWrongSteering,  ///< the wheels do not stand in the direction of the motion
  kTime,           ///< asked for a time that is not the present one
};

/// Something went wrong between us and a device.
struct IoFault
{
  IoFaultKind kind = IoFaultKind::kSilent;
  std::string detail;  ///< device, what happened, in words for a log
};

/// Thrown when hardware cannot be opened: the robot is wired wrongly and does not start.
class HardwareError : public std::runtime_error
{
public:
  using std::runtime_error::runtime_error;
};

/// A value, or the fault that stood in its way.
template <class Value>
class [[nodiscard]] Result
{
public:
  Result(Value value)  // NOLINT(runtime/explicit): `return value;` is the point
  : value_(std::move(value))
  {
  }
  Result(IoFault fault)  // NOLINT(runtime/explicit): `return IoFault{...};` is the point
  : fault_(std::move(fault))
  {
  }

  [[nodiscard]] bool ok() const { return value_.has_value(); }
  explicit operator bool() const { return ok(); }

  /// The value; only when ok().
  [[nodiscard]] const Value & value() const
  {
    assert(value_);
    return *value_;
  }

  /// The fault; only when not ok().
  [[nodiscard]] const IoFault & fault() const
  {
    assert(fault_);
    return *fault_;
  }

private:
  std::optional<Value> value_;
  std::optional<IoFault> fault_;
};

}  // namespace stetro_driver

#endif  // STETRO_DRIVER__RESULT_HPP_
