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

#ifndef ACCURACY__ACCURACY_MARKDOWN_HPP_
#define ACCURACY__ACCURACY_MARKDOWN_HPP_

#include <string>

#include "accuracy/accuracy_report.hpp"
#include "accuracy/machine.hpp"

namespace stetro_bringup
{

/// Where the figures of a report come from.
struct Provenance
{
  std::string command;  ///< that gives the same figures again
  std::string commit;   ///< of the source; empty: not known
  Machine machine;
};

/// The tables of a dated report, as GitHub reads them: millimetres and degrees.
/** It holds no date: the folder of the report does. What is not known is a dash. */
[[nodiscard]] std::string summary_markdown(
  const AccuracyReport & report, const Provenance & provenance);

}  // namespace stetro_bringup

#endif  // ACCURACY__ACCURACY_MARKDOWN_HPP_
