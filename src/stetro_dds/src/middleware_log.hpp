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

#ifndef MIDDLEWARE_LOG_HPP_
#define MIDDLEWARE_LOG_HPP_

#include <spdlog/logger.h>

#include <chrono>
#include <cstdint>
#include <memory>
#include <utility>

#include "fastdds/dds/log/Log.hpp"

namespace stetro_dds
{

/// Sends what the middleware logs to ours, a few lines a second at most.
/** A hostile or broken peer makes it write a line per packet. */
class MiddlewareLog : public eprosima::fastdds::dds::LogConsumer
{
public:
  /// Replaces the middleware's own output, once per process, by the default logger of that moment.
  static void install();

  /// The logger is kept: the middleware's log thread outlives the registry of loggers at exit.
  explicit MiddlewareLog(std::shared_ptr<spdlog::logger> log) : log_(std::move(log)) {}

  void Consume(const eprosima::fastdds::dds::Log::Entry & entry) override;

private:
  const std::shared_ptr<spdlog::logger> log_;
  std::chrono::steady_clock::time_point second_{};
  int lines_in_second_ = 0;
  std::uint64_t suppressed_ = 0;
};

}  // namespace stetro_dds

#endif  // MIDDLEWARE_LOG_HPP_
