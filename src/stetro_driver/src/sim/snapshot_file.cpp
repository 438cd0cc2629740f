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

#include "sim/snapshot_file.hpp"

#include <fcntl.h>
#include <sys/file.h>
#include <sys/mman.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cassert>
#include <cerrno>
#include <cstdio>
#include <cstring>
#include <utility>

namespace stetro_driver::sim
{
namespace
{

constexpr std::uint64_t kMagic = 0x31306d6973745321ULL;  // "!Stsim01" in memory
constexpr std::size_t kAlignment = 64;

[[noreturn]] void fail(const std::string & path, const char * what)
{
  throw HardwareError("snapshot " + path + ": cannot " + what + ": " + std::strerror(errno));
}

}  // namespace

struct SnapshotFile::Header
{
  std::uint64_t magic;
  std::uint64_t world;
  std::uint64_t number;  // of this store, from 1
  std::uint64_t size;
  std::uint64_t checksum;  // over the four above and the bytes

  [[nodiscard]] std::uint64_t expected(const std::uint8_t * bytes) const
  {
    std::uint8_t head[4 * sizeof(std::uint64_t)];
    std::memcpy(head, this, sizeof head);
    return checksum_of(bytes, size, checksum_of(head, sizeof head));
  }
};

std::uint64_t checksum_of(const std::uint8_t * bytes, std::size_t size, std::uint64_t start)
{
  std::uint64_t sum = start;
  for (std::size_t i = 0; i < size; ++i) {
    sum = (sum ^ bytes[i]) * 0x100000001b3ULL;
  }
  return sum;
}

SnapshotFile::SnapshotFile(std::string path, std::uint64_t world, std::size_t size)
: path_(std::move(path)),
  world_(world),
  size_(size),
  slot_size_((sizeof(Header) + size + kAlignment - 1) / kAlignment * kAlignment)
{
  lock();
  found_ = inspect();
  if (found_.outcome == ResumeOutcome::kDamaged || found_.outcome == ResumeOutcome::kForeign) {
    set_aside();
  }
  map();
}

SnapshotFile::~SnapshotFile() { unmap(); }

void SnapshotFile::give_up(const char * what)
{
  const int reason = errno;
  unmap();
  errno = reason;
  fail(path_, what);
}

// The lock comes first: a file that another process lives on is neither judged nor moved.
void SnapshotFile::lock()
{
  for (;;) {
    fd_ = ::open(path_.c_str(), O_RDWR | O_CREAT | O_CLOEXEC, 0644);
    if (fd_ < 0) {
      give_up("open it");
    }
    if (::flock(fd_, LOCK_EX | LOCK_NB) != 0) {
      give_up("lock it, another process uses it");
    }
    struct stat locked
    {
    };
    struct stat named
    {
    };
    if (::fstat(fd_, &locked) != 0) {
      give_up("look at it");
    }
    const bool there = ::stat(path_.c_str(), &named) == 0;
    if (there && locked.st_dev == named.st_dev && locked.st_ino == named.st_ino) {
      return;
    }
    unmap();  // it was set aside between our opening and our lock
  }
}

std::vector<std::uint8_t> SnapshotFile::content()
{
  struct stat about
  {
  };
  if (::fstat(fd_, &about) != 0) {
    give_up("look at it");
  }
  std::vector<std::uint8_t> raw(static_cast<std::size_t>(about.st_size));
  std::size_t filled = 0;
  while (filled < raw.size()) {
    const ssize_t got =
      ::pread(fd_, raw.data() + filled, raw.size() - filled, static_cast<off_t>(filled));
    if (got < 0 && errno != EINTR) {
      give_up("read it");
    }
    if (got == 0) {
      break;
    }
    filled += got > 0 ? static_cast<std::size_t>(got) : 0;
  }
  raw.resize(filled);
  return raw;
}

SnapshotFile::Found SnapshotFile::inspect()
{
  const std::vector<std::uint8_t> raw = content();
  if (std::all_of(raw.begin(), raw.end(), [](std::uint8_t byte) { return byte == 0; })) {
    return {};  // created, and nothing stored yet
  }
  Found best{ResumeOutcome::kDamaged, {}, path_ + ": no whole snapshot in it"};
  std::uint64_t best_number = 0;
  // The slots of another world may have another size: it is then found in the first one only.
  for (const std::size_t start : {std::size_t{0}, slot_size_}) {
    Header header{};
    if (raw.size() < start + sizeof header) {
      continue;
    }
    std::memcpy(&header, raw.data() + start, sizeof header);
    const std::size_t left = raw.size() - start - sizeof header;
    if (header.magic != kMagic || header.size > left) {
      continue;
    }
    const std::uint8_t * bytes = raw.data() + start + sizeof header;
    if (header.checksum != header.expected(bytes) || header.number < best_number) {
      continue;
    }
    best_number = header.number;
    if (header.world != world_ || header.size != size_) {
      best = {ResumeOutcome::kForeign, {}, path_ + ": of another world, robot or seed"};
    } else {
      best = {
        ResumeOutcome::kResumed,
        {bytes, bytes + header.size},
        path_ + ": store " + std::to_string(header.number),
        header.number};
    }
  }
  return best;
}

void SnapshotFile::set_aside()
{
  const std::string aside = path_ + ".refused";
  if (std::rename(path_.c_str(), aside.c_str()) != 0) {
    give_up("set the refused file aside");
  }
  unmap();  // with the lock on what is now aside
  lock();
  found_.detail += "; not used, kept as " + aside;
}

void SnapshotFile::refuse_found(const std::string & why)
{
  found_ = {ResumeOutcome::kDamaged, {}, path_ + ": " + why};
  set_aside();
  map();
}

void SnapshotFile::map()
{
  const auto total = static_cast<off_t>(2 * slot_size_);
  void * at = MAP_FAILED;
  // Blocks are allocated now: a full disk shows here, not as a SIGBUS in the loop.
  errno = ::posix_fallocate(fd_, 0, total);
  if (errno == 0 && ::ftruncate(fd_, total) == 0) {
    at = ::mmap(nullptr, 2 * slot_size_, PROT_READ | PROT_WRITE, MAP_SHARED, fd_, 0);
  }
  if (at == MAP_FAILED) {
    give_up("map it");
  }
  mapped_ = static_cast<std::uint8_t *>(at);
  newest_ = found_.number;
}

void SnapshotFile::unmap() noexcept
{
  if (mapped_ != nullptr) {
    ::munmap(mapped_, 2 * slot_size_);
    mapped_ = nullptr;
  }
  if (fd_ >= 0) {
    ::close(fd_);
    fd_ = -1;
  }
}

std::uint8_t * SnapshotFile::slot(std::size_t number) const
{
  return mapped_ + number * slot_size_;
}

void SnapshotFile::store(const std::vector<std::uint8_t> & bytes) noexcept
{
  assert(bytes.size() == size_);
  Header header{kMagic, world_, newest_ + 1, size_, 0};
  header.checksum = header.expected(bytes.data());
  std::uint8_t * to = slot(header.number % 2);
  std::memcpy(to + sizeof header, bytes.data(), size_);
  std::memcpy(to, &header, sizeof header);
  newest_ = header.number;
}

}  // namespace stetro_driver::sim
