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

#include "emulator/iio_tree.hpp"

#include <fstream>
#include <stdexcept>
#include <utility>

namespace stetro_driver::emulator
{
namespace
{

namespace fs = std::filesystem;

void write(const fs::path & path, const std::string & line)
{
  std::ofstream file{path};
  file << line << "\n";
  if (!file.flush()) {
    throw fs::filesystem_error{"cannot write", path, std::make_error_code(std::errc::io_error)};
  }
}

/// `in_distance_raw`, held open.
class RawAttribute final : public linux_io::Attribute
{
public:
  RawAttribute(std::shared_ptr<EmulatedTof> tof, std::unique_ptr<Attribute> file)
  : tof_(std::move(tof)), file_(std::move(file))
  {
  }
  ssize_t read(char * to, std::size_t room) noexcept override { return tof_->read(to, room); }

private:
  std::shared_ptr<EmulatedTof> tof_;
  std::unique_ptr<Attribute> file_;
};

}  // namespace

IioTree::IioTree(fs::path root) : root_(fs::canonical(root))
{
  fs::create_directories(root_ / "bus" / "iio" / "devices");
  fs::create_directories(root_ / "devices" / "platform");
}

IioTree::~IioTree()
{
  std::error_code ignored;  // a left-over directory of an emulation harms nobody
  fs::remove_all(root_ / "bus", ignored);
  fs::remove_all(root_ / "devices", ignored);
}

void IioTree::plug(const IioDevice & device)
{
  const std::lock_guard lock{mutex_};
  if (devices_.count(device.i2c_name) != 0) {
    throw std::logic_error("there is a device at " + device.i2c_name);
  }
  const fs::path links = root_ / "bus" / "iio" / "devices";
  int number = 0;
  while (fs::is_symlink(fs::symlink_status(links / ("iio:device" + std::to_string(number))))) {
    ++number;
  }
  const std::string iio_name = "iio:device" + std::to_string(number);
  const std::string bus = "i2c-" + device.i2c_name.substr(0, device.i2c_name.find('-'));
  const fs::path directory = root_ / "devices" / "platform" / bus / device.i2c_name / iio_name;
  fs::create_directories(directory);
  write(directory / "name", device.name);
  write(directory / "in_distance_scale", device.scale);
  write(directory / "in_distance_raw", "ask the emulator");
  if (!device.label.empty()) {
    write(directory / "label", device.label);
  }
  device.tof->set_bound(true);
  devices_[device.i2c_name] = {directory, links / iio_name, device.tof};
  fs::create_directory_symlink(directory, links / iio_name);
}

void IioTree::unplug(const std::string & i2c_name)
{
  const std::lock_guard lock{mutex_};
  const auto found = devices_.find(i2c_name);
  if (found == devices_.end()) {
    throw std::logic_error("there is no device at " + i2c_name);
  }
  fs::remove(found->second.link);
  fs::remove_all(found->second.directory.parent_path());
  found->second.tof->set_bound(false);
  devices_.erase(found);
}

std::unique_ptr<linux_io::Attribute> IioTree::open(
  const std::string & path, std::error_code & error) const
{
  auto file = files_.open(path, error);
  if (!file || fs::path{path}.filename() != "in_distance_raw") {
    return file;
  }
  std::error_code gone;
  const fs::path directory = fs::canonical(fs::path{path}.parent_path(), gone);
  const std::lock_guard lock{mutex_};
  for (const auto & [i2c_name, plugged] : devices_) {
    if (plugged.directory == directory) {
      return std::make_unique<RawAttribute>(plugged.tof, std::move(file));
    }
  }
  error = std::make_error_code(std::errc::no_such_device);
  return nullptr;
}

}  // namespace stetro_driver::emulator
