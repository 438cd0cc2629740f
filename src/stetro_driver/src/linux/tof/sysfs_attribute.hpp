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

#ifndef LINUX__TOF__SYSFS_ATTRIBUTE_HPP_
#define LINUX__TOF__SYSFS_ATTRIBUTE_HPP_

#include <sys/types.h>

#include <cstddef>
#include <memory>
#include <optional>
#include <string>
#include <system_error>

namespace stetro_driver::linux_io
{

/// An attribute of sysfs that stays open: reading it from its start makes the kernel produce it.
class Attribute
{
public:
  Attribute() = default;
  virtual ~Attribute() = default;
  Attribute(const Attribute &) = delete;
  Attribute & operator=(const Attribute &) = delete;

  /// As pread() at offset 0; may block for as long as the kernel's driver does.
  /** \return bytes that were read, or -errno */
  [[nodiscard]] virtual ssize_t read(char * to, std::size_t room) noexcept = 0;
};

/// Opens attributes: the one door between the range sensors and the kernel.
/**
 * It exists because a plain file can neither block for a measurement nor fail with an errno, so an
 * emulated sensor needs another way to do both. Names, links and directories are on disk either way.
 */
class AttributeSource
{
public:
  AttributeSource() = default;
  virtual ~AttributeSource() = default;
  AttributeSource(const AttributeSource &) = delete;
  AttributeSource & operator=(const AttributeSource &) = delete;

  /// \return null, and why in `error`, if there is no such attribute; from any thread
  [[nodiscard]] virtual std::unique_ptr<Attribute> open(
    const std::string & path, std::error_code & error) const = 0;
};

/// The attributes of the file system.
class SysfsFiles : public AttributeSource
{
public:
  [[nodiscard]] std::unique_ptr<Attribute> open(
    const std::string & path, std::error_code & error) const override;
};

/// The one line an attribute holds, without its newline; nothing if it cannot be read.
[[nodiscard]] std::optional<std::string> read_line(
  const AttributeSource & files, const std::string & path);

}  // namespace stetro_driver::linux_io

#endif  // LINUX__TOF__SYSFS_ATTRIBUTE_HPP_
