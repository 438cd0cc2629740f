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
#include "stetro_supervisor/mission_record.hpp"

#include <fcntl.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <iomanip>
#include <limits>
#include <sstream>

namespace stetro_supervisor
{
namespace
{

constexpr char kHeading[] = "stetro_mission 1";
constexpr std::size_t kMostTreads = 256;  // as MissionStatus carries

/// CRC-32 of IEEE 802.3, reflected.
std::uint32_t crc32(const std::string & text)
{
  std::uint32_t crc = 0xFFFFFFFFu;
  for (const char c : text) {
    crc ^= static_cast<unsigned char>(c);
    for (int bit = 0; bit < 8; ++bit) {
      crc = (crc >> 1) ^ ((crc & 1u) != 0u ? 0xEDB88320u : 0u);
    }
  }
  return ~crc;
}

std::string checksum_line(const std::string & body)
{
  std::ostringstream line;
  line << "crc32 " << std::hex << std::setw(8) << std::setfill('0') << crc32(body) << "\n";
  return line.str();
}

template <class T>
T read_value(std::istream & in, const std::string & key)
{
  std::string found;
  T value{};
  if (!(in >> found) || found != key || !(in >> value)) {
    throw MissionFileError("mission file: '" + key + "' expected, '" + found + "' found");
  }
  return value;
}

std::string read_quoted(std::istream & in, const std::string & key)
{
  std::string found;
  std::string value;
  if (!(in >> found) || found != key || !(in >> std::quoted(value))) {
    throw MissionFileError("mission file: '" + key + "' expected, '" + found + "' found");
  }
  return value;
}

std::string verified_body(const std::string & text)
{
  const auto at = text.rfind("crc32 ");
  if (at == std::string::npos || text.substr(at) != checksum_line(text.substr(0, at))) {
    throw MissionFileError("mission file: the checksum does not match, the file is damaged");
  }
  return text.substr(0, at);
}

[[noreturn]] void fail(const std::string & what, const std::string & path)
{
  throw MissionFileError("mission file '" + path + "': " + what + ": " + std::strerror(errno));
}

void write_all(int file, const std::string & text, const std::string & path)
{
  std::size_t written = 0;
  while (written < text.size()) {
    const ssize_t n = ::write(file, text.data() + written, text.size() - written);
    if (n < 0 && errno != EINTR) {
      const int reason = errno;
      ::close(file);
      errno = reason;
      fail("write", path);
    }
    written += n > 0 ? static_cast<std::size_t>(n) : 0u;
  }
}

/// A new name in a folder is on the disk only when the folder is.
void flush_folder_of(const std::string & path)
{
  const auto parent = std::filesystem::path(path).parent_path();
  const int folder =
    ::open(parent.empty() ? "." : parent.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
  const bool flushed = folder >= 0 && ::fsync(folder) == 0;
  const int reason = errno;
  if (folder >= 0) {
    ::close(folder);
  }
  if (!flushed) {
    errno = reason;
    fail("fsync its folder", path);
  }
}

}  // namespace

void Swept::pass(double y_m)
{
  y_min_m = started ? std::min(y_min_m, y_m) : y_m;
  y_max_m = started ? std::max(y_max_m, y_m) : y_m;
  started = true;
}

double Swept::share(double width_m, double contact_width_m) const
{
  return started ? std::min(1.0, (y_max_m - y_min_m + contact_width_m) / width_m) : 0.0;
}

std::string encode(const MissionRecord & record)
{
  std::ostringstream out;
  out << std::setprecision(std::numeric_limits<double>::max_digits10);
  out << kHeading << "\n"
      << "active " << record.active << "\n"
      << "segment " << std::quoted(record.segment_id) << "\n"
      << "request " << std::quoted(record.request_id) << "\n"
      << "issuer " << std::quoted(record.issuer) << "\n"
      << "state " << to_string(record.state) << "\n"
      << "step " << record.step << "\n"
      << "leg " << to_string(record.leg) << "\n"
      << "rolled_m " << record.rolled_m << "\n"
      << "treads " << record.swept.size() << "\n";
  for (const Swept & swept : record.swept) {
    out << "swept " << swept.started << " " << swept.y_min_m << " " << swept.y_max_m << "\n";
  }
  return out.str() + checksum_line(out.str());
}

MissionRecord decode(const std::string & text)
{
  std::istringstream in{verified_body(text)};
  std::string heading;
  std::getline(in, heading);
  if (heading != kHeading) {
    throw MissionFileError("mission file: '" + std::string(kHeading) + "' expected");
  }
  MissionRecord record;
  record.active = read_value<bool>(in, "active");
  record.segment_id = read_quoted(in, "segment");
  record.request_id = read_quoted(in, "request");
  record.issuer = read_quoted(in, "issuer");
  const auto state = state_named(read_value<std::string>(in, "state"));
  record.step = read_value<int>(in, "step");
  const auto leg = leg_named(read_value<std::string>(in, "leg"));
  record.rolled_m = read_value<double>(in, "rolled_m");
  const auto treads = read_value<std::size_t>(in, "treads");
  if (!state || !leg || treads > kMostTreads || !std::isfinite(record.rolled_m)) {
    throw MissionFileError("mission file: unknown state or leg, or a number out of bounds");
  }
  record.state = *state;
  record.leg = *leg;
  for (std::size_t i = 0; i < treads; ++i) {
    Swept swept;
    swept.started = read_value<bool>(in, "swept");
    if (!(in >> swept.y_min_m >> swept.y_max_m)) {
      throw MissionFileError("mission file: two numbers expected after 'swept'");
    }
    record.swept.push_back(swept);
  }
  return record;
}

void save(const MissionRecord & record, const std::string & path)
{
  const std::string beside = path + ".new";
  const int file = ::open(beside.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, 0644);
  if (file < 0) {
    fail("open", beside);
  }
  write_all(file, encode(record), beside);
  if (::fsync(file) != 0) {
    const int reason = errno;
    ::close(file);
    errno = reason;
    fail("fsync", beside);
  }
  if (::close(file) != 0) {
    fail("close", beside);
  }
  if (std::rename(beside.c_str(), path.c_str()) != 0) {
    fail("rename", path);
  }
  flush_folder_of(path);
}

std::optional<MissionRecord> load_mission(const std::string & path)
{
  std::ifstream in{path, std::ios::binary};
  if (!in) {
    if (errno == ENOENT) {
      return std::nullopt;
    }
    fail("open", path);
  }
  std::ostringstream text;
  text << in.rdbuf();
  return decode(text.str());
}

}  // namespace stetro_supervisor
