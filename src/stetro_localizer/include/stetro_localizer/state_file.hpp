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

#ifndef STETRO_LOCALIZER__STATE_FILE_HPP_
#define STETRO_LOCALIZER__STATE_FILE_HPP_

#include <optional>
#include <string>
#include <utility>

#include "stetro_localizer/stored_state.hpp"

namespace stetro_localizer
{

/// What reading the file gave.
struct StateReading
{
  enum class Kind { kFound, kMissing, kDamaged };

  Kind kind = Kind::kMissing;
  StoredState state;  ///< meaningful if `kFound`
  std::string why;    ///< of `kDamaged`, for a person
};

/// The file in which the localizer keeps its step and its calibration.
/**
 * It is replaced, never edited: written beside itself, synced to the disk and renamed over the old
 * one, so that a cut of power leaves either the old file or the new one. A file that is cut off,
 * edited, of another format or not readable is damaged: it is reported and not used, and it stays
 * where it is until the next write.
 */
class StateFile
{
public:
  /// \param path empty keeps nothing: reads as missing, writes go nowhere
  explicit StateFile(std::string path) : path_(std::move(path)) {}

  [[nodiscard]] StateReading read() const;

  /// \return nothing if it is safely on the disk, otherwise what went wrong
  [[nodiscard]] std::optional<std::string> write(const StoredState & state) const;

  [[nodiscard]] const std::string & path() const { return path_; }

private:
  std::string path_;
};

}  // namespace stetro_localizer

#endif  // STETRO_LOCALIZER__STATE_FILE_HPP_
