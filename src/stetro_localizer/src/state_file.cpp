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

#include "stetro_localizer/state_file.hpp"

#include <utility>

namespace stetro_localizer
{

StateFile::StateFile(std::string path)
: file_(std::move(path), "stetro_localizer_state 1", stetro_config::Seal::kFnv1a)
{
}

StateReading StateFile::read() const
{
  using Kept = stetro_config::KeptReading::Kind;
  const auto kept = file_.read();
  if (kept.kind == Kept::kMissing) {
    return {};
  }
  if (kept.kind == Kept::kDamaged) {
    return {StateReading::Kind::kDamaged, {}, kept.why};
  }
  std::string why;
  if (const auto state = parse_stored_state(kept.lines, why)) {
    return {StateReading::Kind::kFound, *state, ""};
  }
  return {StateReading::Kind::kDamaged, {}, path() + ": " + why};
}

std::optional<std::string> StateFile::write(const StoredState & state) const
{
  return file_.replace(to_text(state));
}

}  // namespace stetro_localizer
