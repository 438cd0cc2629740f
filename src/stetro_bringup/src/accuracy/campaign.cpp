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

#include "accuracy/campaign.hpp"

#include <algorithm>
#include <exception>
#include <map>
#include <mutex>
#include <optional>
#include <thread>
#include <utility>

namespace stetro_bringup
{
namespace
{

/// The climbs still to be made, and those that wait for one before them.
class Desk
{
public:
  Desk(
    const std::vector<ClimbOrder> & orders,
    const std::function<void(const ClimbOrder &, const ClimbRecord &)> & take)
  : orders_(orders), take_(take)
  {
  }

  void work(const RobotSetup & setup)
  {
    while (const auto number = next()) {
      try {
        hand_in(*number, climb(setup, orders_[*number]));
      } catch (...) {
        give_up(std::current_exception());
      }
    }
  }

  void throw_trouble() const
  {
    if (trouble_) {
      std::rethrow_exception(trouble_);
    }
  }

private:
  std::optional<std::size_t> next()
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    if (trouble_ || given_out_ == orders_.size()) {
      return std::nullopt;
    }
    return given_out_++;
  }

  void hand_in(std::size_t number, ClimbRecord record)
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    waiting_.emplace(number, std::move(record));
    for (auto it = waiting_.find(taken_); it != waiting_.end(); it = waiting_.find(++taken_)) {
      take_(orders_[it->first], it->second);
      waiting_.erase(it);
    }
  }

  void give_up(std::exception_ptr trouble)
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    trouble_ = trouble_ ? trouble_ : trouble;
  }

  const std::vector<ClimbOrder> & orders_;
  const std::function<void(const ClimbOrder &, const ClimbRecord &)> & take_;
  std::mutex mutex_;  // guards all that follows, and the calls of take_
  std::size_t given_out_ = 0;
  std::size_t taken_ = 0;
  std::map<std::size_t, ClimbRecord> waiting_;
  std::exception_ptr trouble_;
};

}  // namespace

void run_campaign(
  const RobotSetup & setup, const std::vector<ClimbOrder> & orders, unsigned jobs,
  const std::function<void(const ClimbOrder &, const ClimbRecord &)> & take)
{
  Desk desk(orders, take);
  const std::size_t wanted = jobs > 0 ? jobs : std::max(1u, std::thread::hardware_concurrency());
  std::vector<std::thread> threads;
  for (std::size_t i = 0; i < std::min(wanted, orders.size()); ++i) {
    threads.emplace_back([&] { desk.work(setup); });
  }
  for (std::thread & thread : threads) {
    thread.join();
  }
  desk.throw_trouble();
}

}  // namespace stetro_bringup
