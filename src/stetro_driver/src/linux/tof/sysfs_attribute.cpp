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

#include "linux/tof/sysfs_attribute.hpp"

#include <fcntl.h>
#include <unistd.h>

#include <array>
#include <cerrno>

namespace stetro_driver::linux_io
{
namespace
{

class OpenFile final : public Attribute
{
public:
  explicit OpenFile(int fd) : fd_(fd) {}
  ~OpenFile() override { ::close(fd_); }

  ssize_t read(char * to, std::size_t room) noexcept override
  {
    ssize_t size = -1;
    do {
      size = ::pread(fd_, to, room, 0);
    } while (size < 0 && errno == EINTR);
    return size < 0 ? -errno : size;
  }

private:
  int fd_;
};

}  // namespace

std::unique_ptr<Attribute> SysfsFiles::open(const std::string & path, std::error_code & error) const
{
  const int fd = ::open(path.c_str(), O_RDONLY | O_CLOEXEC);
  if (fd < 0) {
    error.assign(errno, std::generic_category());
    return nullptr;
  }
  error.clear();
  return std::make_unique<OpenFile>(fd);
}

std::optional<std::string> read_line(const AttributeSource & files, const std::string & path)
{
  std::error_code error;
  const auto attribute = files.open(path, error);
  if (!attribute) {
    return std::nullopt;
  }
  std::array<char, 256> text{};
  const ssize_t size = attribute->read(text.data(), text.size());
  if (size < 0) {
    return std::nullopt;
  }
  std::string line(text.data(), static_cast<std::size_t>(size));
  if (!line.empty() && line.back() == '\n') {
    line.pop_back();
  }
  return line;
}

}  // namespace stetro_driver::linux_io
