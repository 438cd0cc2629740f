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
#ifndef NODE__MISSION_STORE_HPP_
#define NODE__MISSION_STORE_HPP_

#include <optional>
#include <string>
#include <utility>

#include "stetro_supervisor/journey.hpp"

namespace stetro_supervisor
{

/// Keeps the mission in its file, and remembers what went wrong with that.
class MissionStore
{
public:
  /// \param path empty: nothing is kept
  explicit MissionStore(std::string path) : path_(std::move(path)) {}

  /// The mission under way when the process ended, if the file fits the site.
  std::optional<MissionRecord> load(const Journey & journey);

  /// Writes what a restart must know, when it has changed.
  void keep(const Journey & journey);

  /// Why the file was not used or could not be written; empty if all is well.
  const std::string & trouble() const { return trouble_; }

private:
  std::string path_;
  std::string trouble_;
  double kept_rolled_m_ = 0.0;
};

}  // namespace stetro_supervisor

#endif  // NODE__MISSION_STORE_HPP_
