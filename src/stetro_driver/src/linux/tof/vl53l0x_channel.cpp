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

#include "linux/tof/vl53l0x_channel.hpp"

#include <array>
#include <cerrno>
#include <string_view>
#include <system_error>
#include <utility>

#include "linux/tof/vl53l0x_reading.hpp"

namespace stetro_driver::linux_io
{
namespace
{

constexpr std::string_view kDriverName = "vl53l0x";
constexpr std::string_view kScale = "0.001000";  // as the driver prints a millimetre

/// What a failed read means for who stands beside the robot.
std::string explain(int error)
{
  switch (error) {
    case ETIMEDOUT:
      return "its measurement does not end (ETIMEDOUT)";
    case EREMOTEIO:
      return "does not answer on its bus: unplugged, or back at its first address (EREMOTEIO)";
    case ENXIO:
      return "does not answer on its bus: unplugged, or back at its first address (ENXIO)";
    case EIO:
      return "its bus fails (EIO)";
    case ENODEV:
      return "is gone from the kernel (ENODEV)";
    default:
      return "cannot be read: " + std::generic_category().message(error);
  }
}

/// Garbage as a log can show it.
std::string quoted(std::string_view text)
{
  std::string shown = "'";
  for (const char c : text) {
    shown += (c >= ' ' && c <= '~') ? std::string{c} : (c == '\n' ? "\\n" : "?");
  }
  return shown + "'";
}

}  // namespace

Vl53l0xChannel::Vl53l0xChannel(
  std::string place, TofAddress address, std::string sysfs_root, const AttributeSource & files,
  const DeviceClock & clock)
: place_(std::move(place)),
  address_(std::move(address)),
  sysfs_root_(std::move(sysfs_root)),
  files_(files),
  clock_(clock)
{
}

IoFault Vl53l0xChannel::fault(IoFaultKind kind, const std::string & what) const
{
  return {kind, place_ + ": " + what};
}

std::optional<IoFault> Vl53l0xChannel::check_identity(const std::string & directory) const
{
  const std::array<std::pair<std::string_view, std::string_view>, 2> expected{
    {{"name", kDriverName}, {"in_distance_scale", kScale}}};
  for (const auto & [attribute, accepted] : expected) {
    const std::string path = directory + "/" + std::string(attribute);
    const auto is = read_line(files_, path);
    if (!is) {
      return fault(IoFaultKind::kSilent, path + " cannot be read");
    }
    if (*is != accepted) {
      return fault(
        IoFaultKind::kBadAnswer, path + " is " + quoted(*is) + ", accepted: '" +
                                   std::string(accepted) + "': another device took its place");
    }
  }
  return std::nullopt;
}

std::optional<IoFault> Vl53l0xChannel::open()
{
  close();
  const auto directory = find_iio_device(files_, sysfs_root_, address_);
  if (!directory) {
    return fault(directory.fault().kind, directory.fault().detail);
  }
  if (auto other = check_identity(directory.value())) {
    return other;
  }
  std::error_code error;
  raw_ = files_.open(directory.value() + "/in_distance_raw", error);
  if (!raw_) {
    return fault(
      IoFaultKind::kSilent,
      directory.value() + "/in_distance_raw cannot be opened: " + error.message());
  }
  directory_ = directory.value();
  return std::nullopt;
}

void Vl53l0xChannel::close() noexcept
{
  raw_.reset();
  directory_.clear();
}

Result<TofMeasurement> Vl53l0xChannel::measure()
{
  std::array<char, 32> text{};
  TofMeasurement measurement;
  measurement.begun = clock_.now();
  const ssize_t size = raw_->read(text.data(), text.size());
  measurement.ended = clock_.now();
  if (size < 0) {
    const int error = static_cast<int>(-size);
    if (error == ENODEV) {
      close();
    }
    return fault(IoFaultKind::kSilent, explain(error));
  }
  const std::string_view answer{text.data(), static_cast<std::size_t>(size)};
  const auto millimetres = parse_millimetres(answer);
  if (!millimetres) {
    return fault(
      IoFaultKind::kBadAnswer, "answers " + quoted(answer) + ", accepted: 0 to 8191 and a newline");
  }
  measurement.millimetres = *millimetres;
  return measurement;
}

}  // namespace stetro_driver::linux_io
