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

#include "stetro_supervisor/four_beams/open_cells.hpp"

#include <algorithm>
#include <optional>

namespace stetro_supervisor
{

using stetro_site::CellIndex;

namespace
{

constexpr std::size_t kBits = 16;
constexpr std::uint64_t kReading = 0xFFFF;

bool is_known(Reach reach) { return reach.first == reach.last; }

std::size_t set_of(const PerAzimuth<Reach> & reach)
{
  std::size_t set = 0;
  for (std::size_t i = 0; i < reach.size(); ++i) {
    set |= is_known(reach[i]) ? std::size_t{1} << i : 0;
  }
  return set;
}

std::uint64_t key_of(const PerAzimuth<Reach> & reach)
{
  std::uint64_t key = 0;
  for (const Reach & one : reach) {
    key = is_known(one) ? key << kBits | static_cast<std::uint16_t>(one.last) : key;
  }
  return key;
}

/// The keys of one table whose readings all lie within the tolerance.
class KeyRange
{
public:
  KeyRange(std::size_t set, const PerAzimuth<int> & distances, int tolerance)
  {
    for (std::size_t i = 0; i < distances.size(); ++i) {
      if ((set >> i & 1U) != 0) {
        const int distance = std::clamp<int>(distances[i], -kNoReturn, 2 * kNoReturn);
        const int error = std::min<int>(tolerance, kNoReturn);
        least_[count_] =
          static_cast<std::uint64_t>(std::clamp<int>(distance - error, 1, kNoReturn));
        most_[count_] = static_cast<std::uint64_t>(std::clamp<int>(distance + error, 0, kNoReturn));
        empty_ |= most_[count_] < least_[count_] || distance - error > kNoReturn;
        ++count_;
      }
    }
  }

  [[nodiscard]] bool empty() const { return empty_; }
  [[nodiscard]] std::uint64_t first() const { return with_least(0, 0); }

  [[nodiscard]] bool holds(std::uint64_t key) const
  {
    for (std::size_t i = 0; i < count_; ++i) {
      const std::uint64_t reading = reading_of(key, i);
      if (reading < least_[i] || reading > most_[i]) {
        return false;
      }
    }
    return true;
  }

  /// Where to look on from a key that is not held; nothing if all that follow are beyond.
  [[nodiscard]] std::optional<std::uint64_t> next(std::uint64_t key) const
  {
    for (std::size_t i = 0; i < count_; ++i) {
      const std::uint64_t begin = key >> kBits * (count_ - 1 - i) >> kBits;
      if (reading_of(key, i) < least_[i]) {
        return with_least(begin, i);
      }
      if (reading_of(key, i) > most_[i]) {
        return i == 0 ? std::nullopt : std::optional(with_least(begin + 1, i));
      }
    }
    return std::nullopt;
  }

private:
  [[nodiscard]] std::uint64_t reading_of(std::uint64_t key, std::size_t i) const
  {
    return key >> kBits * (count_ - 1 - i) & kReading;
  }

  /// A key of the first i readings, and the least of each that follows.
  [[nodiscard]] std::uint64_t with_least(std::uint64_t begin, std::size_t i) const
  {
    for (; i < count_; ++i) {
      begin = begin << kBits | least_[i];
    }
    return begin;
  }

  std::array<std::uint64_t, 3> least_{};
  std::array<std::uint64_t, 3> most_{};
  std::size_t count_ = 0;
  bool empty_ = false;
};

}  // namespace

void OpenCells::add(const PerAzimuth<Reach> & reach, CellIndex cell)
{
  tables_[set_of(reach)].push_back({key_of(reach), reach, cell});
}

void OpenCells::sort()
{
  for (auto & table : tables_) {
    std::sort(
      table.begin(), table.end(), [](const Open & a, const Open & b) { return a.key < b.key; });
  }
}

std::size_t OpenCells::size() const noexcept
{
  std::size_t sum = 0;
  for (const auto & table : tables_) {
    sum += table.size();
  }
  return sum;
}

void OpenCells::find(
  const PerAzimuth<int> & distances, int tolerance, std::vector<CellIndex> & cells) const
{
  const auto possible = [&](const Open & open) {
    bool all = true;
    for (std::size_t i = 0; i < open.reach.size(); ++i) {
      all &= open.reach[i].allows(distances[i] - tolerance, distances[i] + tolerance);
    }
    return all;
  };
  for (std::size_t set = 0; set < kSets; ++set) {
    const auto & table = tables_[set];
    if (table.empty()) {
      continue;
    }
    const KeyRange range(set, distances, tolerance);
    std::uint64_t key = range.first();
    for (auto at = table.begin(); at != table.end() && !range.empty();) {
      at = std::lower_bound(at, table.end(), key, [](const Open & open, std::uint64_t wanted) {
        return open.key < wanted;
      });
      for (; at != table.end() && range.holds(at->key); ++at) {
        if (possible(*at)) {
          cells.push_back(at->cell);
        }
      }
      const auto next = at != table.end() ? range.next(at->key) : std::nullopt;
      if (!next) {
        break;
      }
      key = *next;
    }
  }
}

}  // namespace stetro_supervisor
