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

#include "stetro_config/kept_file.hpp"
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
/** Replaced whole, as a KeptFile is; a damaged one is reported and not used. */
class StateFile
{
public:
  /// \param path empty keeps nothing: reads as missing, writes go nowhere
  explicit StateFile(std::string path);

  [[nodiscard]] StateReading read() const;

  /// \return nothing if it is safely on the disk, otherwise what went wrong
  [[nodiscard]] std::optional<std::string> write(const StoredState & state) const;

  [[nodiscard]] const std::string & path() const { return file_.path(); }

private:
  stetro_config::KeptFile file_;
};

}  // namespace stetro_localizer

#endif  // STETRO_LOCALIZER__STATE_FILE_HPP_
