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

#ifndef LINUX__MOTION__KEPT_BLOCKS_HPP_
#define LINUX__MOTION__KEPT_BLOCKS_HPP_

#include <condition_variable>
#include <mutex>
#include <optional>
#include <string>
#include <thread>

#include "linux/motion/lifts.hpp"
#include "stetro_config/kept_file.hpp"

namespace stetro_driver::linux_io
{

/// What is known of the blocks, as text and back.
[[nodiscard]] std::string encode(const BlocksKnown & known);
/** \return nothing if it is no such text */
[[nodiscard]] std::optional<BlocksKnown> decode_blocks(const std::string & text);

/// Keeps what is known of the blocks in a file, so that a restart in mid-climb knows what stands.
/** A disk takes its time: a thread of its own writes, and keep() only hands over. */
class KeptBlocks
{
public:
  /// \param path empty: nothing is kept
  explicit KeptBlocks(const std::string & path);
  ~KeptBlocks();
  KeptBlocks(const KeptBlocks &) = delete;
  KeptBlocks & operator=(const KeptBlocks &) = delete;

  /// Of the program before this one. Nothing: there was none, or trouble() says why.
  [[nodiscard]] std::optional<BlocksKnown> load();

  /// Has it written if a block stands or hangs that did not before.
  void keep(const BlocksKnown & known);

  /// Why the file cannot be read or written; empty: it can.
  [[nodiscard]] std::string trouble() const;

private:
  void run();

  stetro_config::KeptFile file_;
  mutable std::mutex mutex_;
  std::condition_variable changed_;
  bool stop_ = false;
  std::optional<BlocksKnown> asked_{};  // to be written
  std::optional<BlocksKnown> newest_{};
  std::string trouble_;
  std::thread thread_;
};

}  // namespace stetro_driver::linux_io

#endif  // LINUX__MOTION__KEPT_BLOCKS_HPP_
