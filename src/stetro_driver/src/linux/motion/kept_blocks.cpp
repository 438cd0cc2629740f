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

#include "linux/motion/kept_blocks.hpp"

#include <cmath>
#include <iomanip>
#include <limits>
#include <sstream>
#include <utility>

namespace stetro_driver::linux_io
{
namespace
{

constexpr char kHeading[] = "stetro_blocks 1";

bool same(const BlocksKnown & a, const BlocksKnown & b)
{
  return a.standing == b.standing && a.locked == b.locked && a.stood_at_m == b.stood_at_m;
}

bool read_extensions(std::istream & in, LiftExtensions & extensions_m)
{
  in >> extensions_m[0] >> extensions_m[1];
  return in && std::isfinite(extensions_m[0]) && std::isfinite(extensions_m[1]);
}

}  // namespace

std::string encode(const BlocksKnown & known)
{
  std::ostringstream out;
  out << std::setprecision(std::numeric_limits<double>::max_digits10);
  out << "extensions_m " << known.extensions_m[0] << " " << known.extensions_m[1] << "\n";
  for (std::size_t b = 0; b < kBlocks; ++b) {
    out << "block " << b + 1 << " standing " << known.standing[b] << " locked " << known.locked[b]
        << " stood_at_m " << known.stood_at_m[b][0] << " " << known.stood_at_m[b][1] << "\n";
  }
  return out.str();
}

std::optional<BlocksKnown> decode_blocks(const std::string & text)
{
  std::istringstream in{text};
  BlocksKnown known;
  const auto word = [&in](const std::string & expected) {
    std::string found;
    return (in >> found) && found == expected;
  };
  if (!word("extensions_m") || !read_extensions(in, known.extensions_m)) {
    return std::nullopt;
  }
  for (std::size_t b = 0; b < kBlocks; ++b) {
    if (
      !word("block") || !word(std::to_string(b + 1)) || !word("standing") ||
      !(in >> known.standing[b]) || !word("locked") || !(in >> known.locked[b]) ||
      !word("stood_at_m") || !read_extensions(in, known.stood_at_m[b])) {
      return std::nullopt;
    }
  }
  return (in >> std::ws).eof() ? std::optional<BlocksKnown>{known} : std::nullopt;
}

KeptBlocks::KeptBlocks(const std::string & path)
: file_(path, kHeading, stetro_config::Seal::kCrc32)
{
  if (!path.empty()) {
    thread_ = std::thread{[this] { run(); }};
  }
}

KeptBlocks::~KeptBlocks()
{
  if (thread_.joinable()) {
    {
      const std::lock_guard<std::mutex> lock{mutex_};
      stop_ = true;
    }
    changed_.notify_all();
    thread_.join();
  }
}

std::optional<BlocksKnown> KeptBlocks::load()
{
  using Kind = stetro_config::KeptReading::Kind;
  const stetro_config::KeptReading reading = file_.read();
  std::optional<BlocksKnown> known;
  if (reading.kind == Kind::kFound) {
    known = decode_blocks(reading.lines);
  }
  const std::lock_guard<std::mutex> lock{mutex_};
  if (reading.kind == Kind::kDamaged) {
    trouble_ = reading.why;
  } else if (reading.kind == Kind::kFound && !known) {
    trouble_ = file_.path() + ": its lines are not those of three blocks";
  }
  return known;
}

void KeptBlocks::keep(const BlocksKnown & known)
{
  {
    const std::lock_guard<std::mutex> lock{mutex_};
    if (newest_ && same(*newest_, known)) {
      return;
    }
    newest_ = known;
    asked_ = known;
  }
  changed_.notify_all();
}

std::string KeptBlocks::trouble() const
{
  const std::lock_guard<std::mutex> lock{mutex_};
  return trouble_;
}

// What is asked for last is written, also on the way out.
void KeptBlocks::run()
{
  std::unique_lock<std::mutex> lock{mutex_};
  while (true) {
    changed_.wait(lock, [this] { return stop_ || asked_.has_value(); });
    if (!asked_) {
      return;
    }
    const BlocksKnown known = *asked_;
    asked_.reset();
    lock.unlock();
    auto failed = file_.replace(encode(known));
    lock.lock();
    trouble_ = failed ? std::move(*failed) : "";
  }
}

}  // namespace stetro_driver::linux_io
