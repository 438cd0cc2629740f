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

#ifndef SIM__ARCHIVE_HPP_
#define SIM__ARCHIVE_HPP_

#include <cstddef>
#include <cstdint>
#include <cstring>
#include <type_traits>
#include <vector>

namespace stetro_driver::sim
{

/// Writes the state that an object lists in its `archive(each)` as bytes, field after field.
/** Native byte order: a snapshot stays on the machine that made it. */
class StateWriter
{
public:
  explicit StateWriter(std::vector<std::uint8_t> & bytes) : bytes_(&bytes) {}

  template <class... Fields>
  void operator()(Fields &... fields)
  {
    (put(fields), ...);
  }

private:
  template <class Field>
  void put(const Field & field)
  {
    static_assert(std::is_trivially_copyable_v<Field>);
    const auto * raw = reinterpret_cast<const std::uint8_t *>(&field);
    bytes_->insert(bytes_->end(), raw, raw + sizeof(Field));
  }

  std::vector<std::uint8_t> * bytes_;
};

/// Reads the same fields back in the same order.
class StateReader
{
public:
  explicit StateReader(const std::vector<std::uint8_t> & bytes) : bytes_(&bytes) {}

  template <class... Fields>
  void operator()(Fields &... fields)
  {
    (get(fields), ...);
  }

  /// Every byte was asked for, and none that was not there.
  [[nodiscard]] bool exhausted() const { return !short_ && at_ == bytes_->size(); }

private:
  template <class Field>
  void get(Field & field)
  {
    static_assert(std::is_trivially_copyable_v<Field>);
    if (bytes_->size() - at_ < sizeof(Field)) {
      short_ = true;
      return;
    }
    std::memcpy(&field, bytes_->data() + at_, sizeof(Field));
    at_ += sizeof(Field);
  }

  const std::vector<std::uint8_t> * bytes_;
  std::size_t at_ = 0;
  bool short_ = false;
};

}  // namespace stetro_driver::sim

#endif  // SIM__ARCHIVE_HPP_
