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

// Replaces the global `new`, in a file of its own: whoever sees both ends warns of a mismatch.

#include "thread_allocations.hpp"

#include <cstdlib>
#include <new>

namespace
{

thread_local std::uint64_t allocations = 0;

}  // namespace

void * operator new(std::size_t size)
{
  ++allocations;
  if (void * room = std::malloc(size)) {
    return room;
  }
  throw std::bad_alloc();
}
void operator delete(void * room) noexcept { std::free(room); }
void operator delete(void * room, std::size_t) noexcept { std::free(room); }

namespace stetro_driver
{

std::uint64_t thread_allocations() noexcept { return allocations; }

}  // namespace stetro_driver
