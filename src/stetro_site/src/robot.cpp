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

#include "stetro_site/robot.hpp"

#include <utility>

#include "stetro_config/loader.hpp"
#include "stetro_config/yaml_file.hpp"

namespace stetro_site
{

std::optional<Robot> read_robot(const std::string & path, stetro_config::Faults & faults)
{
  const auto root = stetro_config::read_yaml_file(path, faults);
  if (!root) {
    return std::nullopt;
  }
  stetro_config::Loader<Robot> loader;
  loader.leave_out("devices");
  loader.read_map(*root, path);
  loader.require_every_name(path);  // a body of which a part is guessed would fall
  const auto faults_before = faults.size();
  Robot robot = loader.finish(faults);
  if (faults.size() != faults_before) {
    return std::nullopt;
  }
  robot.devices = loader.left_out("devices");
  robot.file = path;
  return robot;
}

Robot load_robot(const std::string & path)
{
  stetro_config::Faults faults;
  auto robot = read_robot(path, faults);
  faults.throw_if_any();
  return std::move(robot).value();
}

}  // namespace stetro_site
