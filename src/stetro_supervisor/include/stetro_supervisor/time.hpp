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

#ifndef STETRO_SUPERVISOR__TIME_HPP_
#define STETRO_SUPERVISOR__TIME_HPP_

#include <chrono>

namespace stetro_supervisor
{

/// Time on the receiver's clock: since the epoch, or since the origin of simulated time.
using Time = std::chrono::nanoseconds;

/// `later - earlier` in seconds.
inline double seconds_between(Time earlier, Time later)
{
  return std::chrono::duration<double>(later - earlier).count();
}

}  // namespace stetro_supervisor

#endif  // STETRO_SUPERVISOR__TIME_HPP_
