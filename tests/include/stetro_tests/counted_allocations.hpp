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

// Counts what the program allocates. Include it in one source of a test program, and only there: it
// replaces the global operators.

#ifndef STETRO_TESTS__COUNTED_ALLOCATIONS_HPP_
#define STETRO_TESTS__COUNTED_ALLOCATIONS_HPP_

#include <cstddef>
#include <cstdlib>
#include <new>

inline std::size_t allocations = 0;

void * operator new(std::size_t size)
{
  ++allocations;
  if (void * memory = std::malloc(size)) {
    return memory;
  }
  throw std::bad_alloc();
}
void operator delete(void * memory) noexcept { std::free(memory); }
void operator delete(void * memory, std::size_t) noexcept { std::free(memory); }

#endif  // STETRO_TESTS__COUNTED_ALLOCATIONS_HPP_
