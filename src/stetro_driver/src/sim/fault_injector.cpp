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

#include "sim/fault_injector.hpp"

#include <algorithm>
#include <utility>

namespace stetro_driver::sim
{

FaultInjector::FaultInjector(std::vector<SimFault> faults)
{
  for (SimFault & fault : faults) {
    faults_.push_back({std::move(fault)});
  }
}

const SimFault * FaultInjector::acting(SimFaultKind kind, std::string_view device) const
{
  for (const Due & due : faults_) {
    if (due.fault.kind == kind && due.fault.device == device && in_time(due)) {
      return &due.fault;
    }
  }
  return nullptr;
}

const SimFault * FaultInjector::strike(SimFaultKind kind)
{
  for (Due & due : faults_) {
    if (due.fault.kind == kind && !due.struck && in_time(due)) {
      due.struck = true;
      return &due.fault;
    }
  }
  return nullptr;
}

bool FaultInjector::pending(SimFaultKind kind) const
{
  return std::any_of(faults_.begin(), faults_.end(), [&](const Due & due) {
    return due.fault.kind == kind && !due.struck && in_time(due);
  });
}

void FaultInjector::drive(std::string_view floor, double time_s)
{
  for (Due & due : faults_) {
    if (due.fault.is_on_floor() && due.fault.device == floor) {
      due.driven_s += time_s;
    }
  }
}

bool FaultInjector::in_time(const Due & due) const
{
  const double clock_s = due.fault.is_on_floor() ? due.driven_s : elapsed_s_;
  return clock_s >= due.fault.from_s && clock_s < due.fault.until_s;
}

}  // namespace stetro_driver::sim
