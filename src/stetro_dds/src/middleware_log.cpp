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

#include "middleware_log.hpp"

#include <spdlog/spdlog.h>

#include <chrono>
#include <memory>
#include <mutex>

namespace stetro_dds
{

using eprosima::fastdds::dds::Log;

namespace
{
constexpr int kLinesPerSecond = 5;
}

void MiddlewareLog::install()
{
  static std::once_flag once;
  std::call_once(once, [] {
    Log::ClearConsumers();
    Log::RegisterConsumer(std::make_unique<MiddlewareLog>(spdlog::default_logger()));
    Log::SetVerbosity(Log::Kind::Warning);
  });
}

void MiddlewareLog::Consume(const Log::Entry & entry)
{
  const auto now = std::chrono::steady_clock::now();
  if (now - second_ > std::chrono::seconds(1)) {
    if (suppressed_ > 0) {
      log_->warn("middleware: {} lines not shown", suppressed_);
    }
    second_ = now;
    lines_in_second_ = 0;
    suppressed_ = 0;
  }
  if (++lines_in_second_ > kLinesPerSecond) {
    ++suppressed_;
    return;
  }
  const bool error = entry.kind == Log::Kind::Error;
  log_->log(error ? spdlog::level::warn : spdlog::level::debug, "middleware: {}", entry.message);
}

}  // namespace stetro_dds
