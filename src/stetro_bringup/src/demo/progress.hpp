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
#ifndef DEMO__PROGRESS_HPP_
#define DEMO__PROGRESS_HPP_

#include <iosfwd>
#include <string>

#include "demo_node.hpp"

namespace stetro_bringup
{

/// Shows how far the climb has come: one line rewritten on a terminal, a line a step elsewhere.
class Progress
{
public:
  Progress(std::ostream & out, bool terminal);

  /// \param simulated_s time on the robot's clock since the start [s]
  void show(const MissionView & mission, double y_m, double simulated_s);

  /// Ends the line that show() has been rewriting.
  void close();

private:
  std::ostream & out_;
  const bool terminal_;
  std::string last_;
};

}  // namespace stetro_bringup

#endif  // DEMO__PROGRESS_HPP_
