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

#ifndef STETRO_TESTS__OBSERVER_HPP_
#define STETRO_TESTS__OBSERVER_HPP_

#include <memory>
#include <string>
#include <string_view>
#include <thread>
#include <vector>

#include "stetro_dds/context.hpp"
#include "stetro_dds/executor.hpp"
#include "stetro_dds/node.hpp"
#include "stetro_tests/loopback_domain.hpp"
#include "stetro_tests/probe.hpp"

namespace stetro_tests
{

/// The test's own participant: it listens with probes and speaks with publishers.
/** Ask for every probe and publisher first, then `start()`. */
class Observer
{
public:
  explicit Observer(const LoopbackDomain & domain, std::string name = "observer");
  ~Observer();
  Observer(const Observer &) = delete;
  Observer & operator=(const Observer &) = delete;

  /// A probe on a topic, relative to the robot's namespace /stetro or absolute.
  template <class Message>
  Probe<Message> & probe(std::string_view topic, const stetro_dds::QosProfile & profile)
  {
    auto made = std::make_shared<Probe<Message>>(node_.resolve(topic));
    node_.subscribe<Message>(
      topic, profile, [made](const Message & message, const stetro_dds::Reception & reception) {
        made->add(message, reception);
      });
    probes_.push_back(made);
    return *made;
  }

  /// A publisher on a topic, named likewise; any thread may publish.
  template <class Message>
  auto & publisher(std::string_view topic, const stetro_dds::QosProfile & profile)
  {
    return node_.advertise<Message>(topic, profile);
  }

  [[nodiscard]] stetro_dds::Node & node() { return node_; }
  [[nodiscard]] stetro_dds::Context & context() { return context_; }

  /// Begins to listen; no probe or publisher may be added afterwards.
  void start();

  /// Waits until every topic of ours has a peer. \return the topics that have none
  std::vector<std::string> wait_matched(std::chrono::nanoseconds limit);

private:
  static stetro_dds::NodeOptions node_options(std::string name);

  stetro_dds::Context context_;
  stetro_dds::Node node_;
  stetro_dds::Executor executor_;
  std::vector<std::shared_ptr<void>> probes_;
  std::thread spinning_;
};

/// Options of a participant of the test's own in this domain.
stetro_dds::ContextOptions context_options(const LoopbackDomain & domain);

}  // namespace stetro_tests

#endif  // STETRO_TESTS__OBSERVER_HPP_
