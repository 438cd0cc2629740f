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

#ifndef LINUX__TOF__TOF_ARRAY_HPP_
#define LINUX__TOF__TOF_ARRAY_HPP_

#include <array>
#include <memory>
#include <string>

#include "linux/device_clock.hpp"
#include "linux/tof/sysfs_attribute.hpp"
#include "linux/tof/tof_address.hpp"
#include "linux/tof/tof_reader.hpp"
#include "linux/tof/vl53l0x_reading.hpp"
#include "stetro_config/rule.hpp"
#include "stetro_driver/sensor_frame.hpp"

namespace stetro_driver::linux_io
{

/// Where the robot's range sensors are, and how fast they must answer.
struct TofArrayConfig
{
  std::string sysfs_root = "/sys";
  double period_s = 0.035;
  double longest_s = 0.070;
  /// In the order of RangePlace; the bus addresses that docs/hardware/range_sensors.md gives out.
  std::array<std::string, kRangePlaces> sensors{"i2c:1-0030", "i2c:1-0031", "i2c:1-0032",
                                                "i2c:1-0033", "i2c:1-0034", "i2c:1-0035",
                                                "i2c:1-0036", "i2c:1-0037"};
};

template <class Visitor>
void visit(TofArrayConfig & c, Visitor && each)
{
  using stetro_config::Within;
  each("sysfs_root", c.sysfs_root, stetro_config::NonEmpty{}, "where the kernel shows its devices");
  each(
    "period_s", c.period_s, Within{0.01, 0.2}, "one measurement; silent after three of them [s]");
  each("longest_s", c.longest_s, Within{0.01, 1.0}, "a measurement that took longer is late [s]");
  for (std::size_t i = 0; i < kRangePlaces; ++i) {
    each(
      std::string(kRangeNames[i]), c.sensors[i], IsTofAddress{},
      "label:NAME, i2c:BUS-ADDRESS, path:DIRECTORY of this sensor, or none");
  }
}

/// The robot's VL53L0X: each is read by a thread of its own, about 28 times a second.
/**
 * One thread for all would wait for one after the other and get 4 readings a second of each of
 * eight. Between measurements the bus is free, so sensors on one bus do not wait for each other.
 */
class TofArray
{
public:
  /// \param files outlives the array
  /// \throws HardwareError naming each sensor whose address is none
  TofArray(
    const TofArrayConfig & config, const TofLimits & limits, const AttributeSource & files,
    const DeviceClock & clock);

  /// Finds all sensors, checks that each is a VL53L0X, and waits for an answer of each.
  /** \throws HardwareError naming every sensor that is missing, another's, or does not answer; then
   * nothing is left open, and it may be tried again */
  void start();

  /// Stops all threads and closes all sensors; may be started again.
  void stop() noexcept;

  /// Whether there is such a sensor. One that is not fitted reads kFault, which is no fault.
  [[nodiscard]] bool fitted(RangePlace place) const noexcept { return reader(place) != nullptr; }

  /// The newest of a sensor as of `now`; waits for nothing, allocates nothing. From one thread.
  [[nodiscard]] TofLatest latest(RangePlace place, Time now);

  /// Health and statistics, from any thread. \pre fitted(place)
  [[nodiscard]] TofReport report(RangePlace place) const { return reader(place)->report(); }

private:
  [[nodiscard]] TofReader * reader(RangePlace place) const noexcept
  {
    return readers_[static_cast<std::size_t>(place)].get();
  }
  /// What is wrong, a line a sensor; empty: nothing.
  [[nodiscard]] std::string open_all();
  [[nodiscard]] std::string await_all();
  /// Two readers of one sensor would spoil each other's measurements.
  [[nodiscard]] std::string sensors_given_twice() const;

  std::array<std::unique_ptr<TofReader>, kRangePlaces> readers_{};
};

}  // namespace stetro_driver::linux_io

#endif  // LINUX__TOF__TOF_ARRAY_HPP_
