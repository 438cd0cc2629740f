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

#include "stetro_localizer/state_file.hpp"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <fstream>
#include <sstream>

namespace stetro_localizer
{
namespace
{

// An open file descriptor, closed at the end of its scope.
class Descriptor
{
public:
  Descriptor(const std::string & path, int flags) : fd_(::open(path.c_str(), flags, 0644)) {}
  Descriptor(const Descriptor &) = delete;
  Descriptor & operator=(const Descriptor &) = delete;
  ~Descriptor()
  {
    if (fd_ >= 0) {
      ::close(fd_);
    }
  }

  [[nodiscard]] bool is_open() const { return fd_ >= 0; }
  [[nodiscard]] bool sync() const { return ::fsync(fd_) == 0; }
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

private:
  int fd_;
};

std::string failure(const std::string & what, const std::string & path)
{
  return what + " " + path + ": " + std::strerror(errno);
}

std::string folder_of(const std::string & path)
{
  const std::size_t slash = path.rfind('/');
  if (slash == std::string::npos) {
    return ".";
  }
  return slash == 0 ? "/" : path.substr(0, slash);
}

}  // namespace

StateReading StateFile::read() const
{
  StateReading reading;
  struct stat found
  {
  };
  if (path_.empty() || (::stat(path_.c_str(), &found) != 0 && errno == ENOENT)) {
    return reading;
  }
  std::ifstream file(path_, std::ios::binary);
  std::ostringstream text;
  if (!file || !(text << file.rdbuf())) {
    reading.kind = StateReading::Kind::kDamaged;
    reading.why = path_ + ": it cannot be read, or it is empty";
    return reading;
  }
  std::string why;
  if (const auto state = parse_stored_state(text.str(), why)) {
    reading.kind = StateReading::Kind::kFound;
    reading.state = *state;
  } else {
    reading.kind = StateReading::Kind::kDamaged;
    reading.why = path_ + ": " + why;
  }
  return reading;
}

std::optional<std::string> StateFile::write(const StoredState & state) const
{
  if (path_.empty()) {
    return std::nullopt;
  }
  const std::string beside = path_ + ".new";
  {
    const Descriptor file(beside, O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC);
    if (!file.is_open() || !file.write_all(to_text(state)) || !file.sync()) {
      return failure("cannot write", beside);
    }
  }
  if (::rename(beside.c_str(), path_.c_str()) != 0) {
    return failure("cannot rename to", path_);
  }
  const Descriptor folder(folder_of(path_), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
  if (!folder.is_open() || !folder.sync()) {
    return failure("cannot sync the folder of", path_);
  }
  return std::nullopt;
}

}  // namespace stetro_localizer
