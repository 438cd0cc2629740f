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

#ifndef SIM__SNAPSHOT_FILE_HPP_
#define SIM__SNAPSHOT_FILE_HPP_

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "stetro_driver/sim_robot.hpp"

namespace stetro_driver::sim
{

/// FNV-1a over bytes, 64 bits.
[[nodiscard]] std::uint64_t checksum_of(
  const std::uint8_t * bytes, std::size_t size, std::uint64_t start = 0xcbf29ce484222325ULL);

/// A world on disk that survives `kill -9` at any moment.
/**
 * A file of two slots, mapped into memory. Each store fills the slot that is not the newest, so a
 * process that dies half-way leaves the other one whole; a slot counts only if its checksum, over
 * its number, its world and its bytes, agrees. Loading takes the newest that counts. A file is
 * locked before it is read, and set aside only by who holds its lock. (The kernel
 * keeps what a dead process wrote to the mapping; a power cut may lose the last seconds of it.)
 */
class SnapshotFile
{
public:
  /// What was found.
  struct Found
  {
    ResumeOutcome outcome = ResumeOutcome::kFresh;
    std::vector<std::uint8_t> bytes{};  ///< when kResumed
    std::string detail{};
    std::uint64_t number = 0;  ///< of the store, counted from 1
  };

  /// \param world names the world: a snapshot of another is foreign \param size of each store
  /// \throws HardwareError when the file cannot be opened or mapped, or another process uses it
  SnapshotFile(std::string path, std::uint64_t world, std::size_t size);
  ~SnapshotFile();
  SnapshotFile(const SnapshotFile &) = delete;
  SnapshotFile & operator=(const SnapshotFile &) = delete;

  /// What the file held when it was opened.
  [[nodiscard]] const Found & found() const { return found_; }

  /// Refuses what was found, for a reason only its reader knows, and starts anew.
  void refuse_found(const std::string & why);

  /// Stores `size` bytes. A microsecond for a kilobyte; no system call.
  void store(const std::vector<std::uint8_t> & bytes) noexcept;

private:
  struct Header;

  void lock();
  [[nodiscard]] std::vector<std::uint8_t> content();
  [[nodiscard]] Found inspect();
  [[nodiscard]] std::uint8_t * slot(std::size_t number) const;
  [[noreturn]] void give_up(const char * what);
  void set_aside();
  void map();
  void unmap() noexcept;

  std::string path_;
  std::uint64_t world_;
  std::size_t size_;
  std::size_t slot_size_;
  int fd_ = -1;  // open as long as we live: it carries the lock
  std::uint8_t * mapped_ = nullptr;
  std::uint64_t newest_ = 0;
  Found found_;
};

}  // namespace stetro_driver::sim

#endif  // SIM__SNAPSHOT_FILE_HPP_
