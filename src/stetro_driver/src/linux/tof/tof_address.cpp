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

#include "linux/tof/tof_address.hpp"

#include <algorithm>
#include <array>
#include <filesystem>
#include <string_view>
#include <system_error>
#include <utility>
#include <vector>

namespace stetro_driver::linux_io
{
namespace
{

namespace fs = std::filesystem;

constexpr std::array<std::pair<std::string_view, TofAddress::By>, 3> kWays{{
  {"label:", TofAddress::By::kLabel},
  {"i2c:", TofAddress::By::kI2cName},
  {"path:", TofAddress::By::kPath},
}};

/// Bus in decimal, a dash, four hexadecimal digits: as the kernel names I2C devices.
bool is_i2c_name(const std::string & text)
{
  const auto dash = text.find('-');
  const auto all = [](const std::string & part, std::string_view of) {
    return !part.empty() && part.find_first_not_of(of) == std::string::npos;
  };
  return dash != std::string::npos && all(text.substr(0, dash), "0123456789") &&
         text.size() - dash == 5 && all(text.substr(dash + 1), "0123456789abcdef");
}

bool matches(const AttributeSource & files, const fs::path & device, const TofAddress & address)
{
  if (address.by == TofAddress::By::kLabel) {
    return read_line(files, device / "label") == address.key;
  }
  return std::find(device.begin(), device.end(), fs::path{address.key}) != device.end();
}

/// Real paths of all IIO devices; a device may go while they are listed.
std::vector<fs::path> iio_devices(const fs::path & devices)
{
  std::vector<fs::path> found;
  std::error_code error;
  for (fs::directory_iterator at{devices, error}, end; !error && at != end; at.increment(error)) {
    std::error_code gone;
    const fs::path real = fs::canonical(at->path(), gone);
    if (!gone && at->path().filename().string().rfind("iio:device", 0) == 0) {
      found.push_back(real);
    }
  }
  return found;
}

}  // namespace

std::optional<TofAddress> parse_tof_address(const std::string & text)
{
  if (text == "none") {
    return TofAddress{};
  }
  for (const auto & [prefix, by] : kWays) {
    if (text.rfind(prefix, 0) == 0 && text.size() > prefix.size()) {
      TofAddress address{by, text.substr(prefix.size())};
      const bool wrong = by == TofAddress::By::kI2cName && !is_i2c_name(address.key);
      return wrong ? std::nullopt : std::optional<TofAddress>{std::move(address)};
    }
  }
  return std::nullopt;
}

Result<std::string> find_iio_device(
  const AttributeSource & files, const std::string & sysfs_root, const TofAddress & address)
{
  if (address.by == TofAddress::By::kPath) {
    std::error_code error;
    const fs::path real = fs::canonical(address.key, error);
    if (error) {
      return IoFault{IoFaultKind::kSilent, "there is no " + address.key};
    }
    return real.string();
  }
  const fs::path devices = fs::path{sysfs_root} / "bus" / "iio" / "devices";
  std::vector<fs::path> found;
  for (const fs::path & device : iio_devices(devices)) {
    if (matches(files, device, address)) {
      found.push_back(device);
    }
  }
  if (found.size() != 1) {
    const bool label = address.by == TofAddress::By::kLabel;
    return IoFault{
      found.empty() ? IoFaultKind::kSilent : IoFaultKind::kBadAnswer,
      std::to_string(found.size()) + " devices in " + devices.string() +
        (label ? " have the label " : " are at ") + address.key + ", accepted: one"};
  }
  return found.front().string();
}

}  // namespace stetro_driver::linux_io
