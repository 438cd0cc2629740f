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

#include "stetro_config/kept_file.hpp"

#include <fcntl.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <cstdint>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <iomanip>
#include <sstream>
#include <string>
#include <utility>

namespace stetro_config
{
namespace
{

constexpr std::size_t kLargestFile = 1U << 20U;  // far above what is kept, far below /dev/zero
constexpr mode_t kMode = 0644;

std::uint64_t fnv1a(const std::string & text)
{
  std::uint64_t hash = 0xcbf29ce484222325ULL;
  for (const char letter : text) {
    hash = (hash ^ static_cast<unsigned char>(letter)) * 0x100000001b3ULL;
  }
  return hash;
}

/// CRC-32 of IEEE 802.3, reflected.
std::uint32_t crc32(const std::string & text)
{
  std::uint32_t crc = 0xFFFFFFFFU;
  for (const char letter : text) {
    crc ^= static_cast<unsigned char>(letter);
    for (int bit = 0; bit < 8; ++bit) {
      crc = (crc >> 1U) ^ ((crc & 1U) != 0U ? 0xEDB88320U : 0U);
    }
  }
  return ~crc;
}

const char * word_of(Seal seal) { return seal == Seal::kCrc32 ? "crc32 " : "checksum "; }

/// An open file descriptor, closed at the end of its scope.
class Descriptor
{
public:
  Descriptor(const std::string & path, int flags) : fd_(::open(path.c_str(), flags, kMode)) {}
  Descriptor(const Descriptor &) = delete;
  Descriptor & operator=(const Descriptor &) = delete;
  ~Descriptor()
  {
    if (fd_ >= 0) {
      ::close(fd_);
    }
  }

  [[nodiscard]] bool is_open() const { return fd_ >= 0; }
  [[nodiscard]] bool flush() const { return ::fsync(fd_) == 0; }

  [[nodiscard]] bool write_all(const std::string & text) const
  {
    std::size_t done = 0;
    while (done < text.size()) {
      const ssize_t count = ::write(fd_, text.data() + done, text.size() - done);
      if (count < 0 && errno != EINTR) {
        return false;
      }
      done += count > 0 ? static_cast<std::size_t>(count) : 0;
    }
    return true;
  }

  /// Stops beyond the largest file.
  [[nodiscard]] bool read_all(std::string & text) const
  {
    std::array<char, 4096> chunk{};
    while (text.size() <= kLargestFile) {
      const ssize_t count = ::read(fd_, chunk.data(), chunk.size());
      if (count == 0) {
        return true;
      }
      if (count < 0 && errno != EINTR) {
        return false;
      }
      text.append(chunk.data(), count > 0 ? static_cast<std::size_t>(count) : 0);
    }
    return true;
  }

private:
  int fd_;
};

std::string failure(const std::string & what, const std::string & path)
{
  return "cannot " + what + " " + path + ": " + std::strerror(errno);
}

std::string folder_of(const std::string & path)
{
  const auto parent = std::filesystem::path(path).parent_path();
  return parent.empty() ? "." : parent.string();
}

}  // namespace

KeptFile::KeptFile(std::string path, std::string heading, Seal seal)
: path_(std::move(path)), heading_(std::move(heading) + "\n"), seal_(seal)
{
}

std::string KeptFile::seal_of(const std::string & text) const
{
  std::ostringstream line;
  line << word_of(seal_);
  if (seal_ == Seal::kCrc32) {
    line << std::hex << std::setw(8) << std::setfill('0') << crc32(text);
  } else {
    line << fnv1a(text);
  }
  line << "\n";
  return line.str();
}

KeptReading KeptFile::damaged(const std::string & why) const
{
  return {KeptReading::Kind::kDamaged, "", path_ + ": " + why};
}

KeptReading KeptFile::open_seal(const std::string & text) const
{
  if (text.compare(0, heading_.size(), heading_) != 0) {
    return damaged("it does not begin with '" + heading_.substr(0, heading_.size() - 1) + "'");
  }
  const std::size_t at = text.rfind(word_of(seal_));
  if (at == std::string::npos || at < heading_.size()) {
    return damaged("it has no checksum: it is not whole");
  }
  if (text.substr(at) != seal_of(text.substr(0, at))) {
    return damaged("its checksum does not fit");
  }
  return {KeptReading::Kind::kFound, text.substr(heading_.size(), at - heading_.size()), ""};
}

KeptReading KeptFile::read() const
{
  if (path_.empty()) {
    return {};
  }
  const Descriptor file(path_, O_RDONLY | O_CLOEXEC);
  if (!file.is_open() && errno == ENOENT) {
    return {};
  }
  std::string text;
  if (!file.is_open() || !file.read_all(text)) {
    return damaged(std::string("it cannot be read: ") + std::strerror(errno));
  }
  if (text.size() > kLargestFile) {
    return damaged("it is larger than 1 MiB");
  }
  return open_seal(text);
}

std::optional<std::string> KeptFile::replace(const std::string & lines) const
{
  if (path_.empty()) {
    return std::nullopt;
  }
  const std::string text = heading_ + lines;
  const std::string beside = path_ + ".new";
  {
    const Descriptor file(beside, O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC);
    if (!file.is_open() || !file.write_all(text + seal_of(text)) || !file.flush()) {
      return failure("write", beside);
    }
  }
  if (std::rename(beside.c_str(), path_.c_str()) != 0) {
    return failure("replace", path_);
  }
  const Descriptor folder(folder_of(path_), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
  if (!folder.is_open() || !folder.flush()) {  // a new name is on the disk when its folder is
    return failure("flush the folder of", path_);
  }
  return std::nullopt;
}

}  // namespace stetro_config
