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

#include "stetro_dds/executor.hpp"

#include <algorithm>
#include <chrono>
#include <memory>
#include <stdexcept>
#include <vector>

#include "stetro_dds/node.hpp"
#include "wait_set.hpp"

namespace stetro_dds
{

namespace
{

using std::chrono_literals::operator""ms;

constexpr std::size_t kMostPerVisit = 100;  // a flooded topic may not keep the others waiting
constexpr auto kLongestWait = 100ms;        // the middleware has lost wake-ups before

}  // namespace

Executor::Executor() : wait_set_(std::make_unique<WaitSet>()) {}

Executor::~Executor()
{
  while (!nodes_.empty()) {
    remove(*nodes_.back());
  }
}

void Executor::add(Node & node)
{
  if (node.executor_ != nullptr) {
    throw std::invalid_argument("node '" + node.name().full() + "' already has an executor");
  }
  node.executor_ = this;
  nodes_.push_back(&node);
  attach_new_subscriptions();
}

void Executor::remove(Node & node)
{
  for (std::size_t i = 0; i < node.attached_; ++i) {
    node.subscriptions()[i]->detach_from(*wait_set_);
  }
  node.attached_ = 0;
  node.executor_ = nullptr;
  nodes_.erase(std::remove(nodes_.begin(), nodes_.end(), &node), nodes_.end());
}

void Executor::attach_new_subscriptions()
{
  for (Node * node : nodes_) {
    for (; node->attached_ < node->subscriptions().size(); ++node->attached_) {
      node->subscriptions()[node->attached_]->attach_to(*wait_set_);
    }
  }
}

void Executor::spin()
{
  while (!stopped_) {
    spin_some(kLongestWait);
  }
}

std::size_t Executor::spin_some(std::chrono::nanoseconds timeout)
{
  attach_new_subscriptions();
  wait_set_->wait(std::min(timeout, until_next_timer()));
  return stopped_ ? 0 : round();
}

std::size_t Executor::drain(std::size_t max_rounds)
{
  std::size_t done = 0;
  for (std::size_t i = 0; i < max_rounds; ++i) {
    const std::size_t in_this_round = round();
    if (in_this_round == 0) {
      break;
    }
    done += in_this_round;
  }
  return done;
}

void Executor::stop()
{
  stopped_ = true;
  wait_set_->ring();
}

// By index: a handler may open further endpoints and timers.
std::size_t Executor::round()
{
  std::size_t done = 0;
  for (std::size_t n = 0; n < nodes_.size(); ++n) {
    const auto & subscriptions = nodes_[n]->subscriptions();
    for (std::size_t i = 0; i < subscriptions.size(); ++i) {
      done += subscriptions[i]->take(kMostPerVisit);
    }
  }
  for (std::size_t n = 0; n < nodes_.size(); ++n) {
    const auto & timers = nodes_[n]->timers();
    for (std::size_t i = 0; i < timers.size(); ++i) {
      done += timers[i]->fire_if_due() ? 1 : 0;
    }
  }
  return done;
}

std::chrono::nanoseconds Executor::until_next_timer() const
{
  std::chrono::nanoseconds shortest = kLongestWait;
  const Time now = Clock::steady_now();
  for (const Node * node : nodes_) {
    for (const auto & timer : node->timers()) {
      if (const auto due = timer->next_steady()) {
        shortest = std::min(shortest, *due - now);
      }
    }
  }
  return shortest;
}

}  // namespace stetro_dds
