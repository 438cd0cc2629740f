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

#include "participant.hpp"

#include <pthread.h>
#include <signal.h>
#include <spdlog/spdlog.h>

#include <chrono>
#include <cstdlib>
#include <functional>
#include <memory>
#include <mutex>
#include <stdexcept>
#include <string>

#include "dds_qos.hpp"
#include "fastdds/dds/domain/DomainParticipantFactory.hpp"
#include "fastrtps/attributes/LibrarySettingsAttributes.h"
#include "fastrtps/xmlparser/XMLProfileManager.h"
#include "middleware_log.hpp"

namespace stetro_dds
{

namespace dds = eprosima::fastdds::dds;

namespace
{

constexpr std::uint32_t kHighestDomain = 232;    // beyond it the middleware calls exit()
constexpr std::uint32_t kEphemeralDomain = 102;  // from here on ports are in the ephemeral range

/// A broken profile falls back to every interface, and a discovery server takes us off the
/// localhost: what is configured, is configured through ContextOptions.
void scrub_environment()
{
  for (const char * name :
       {"FASTRTPS_DEFAULT_PROFILES_FILE", "FASTDDS_DEFAULT_PROFILES_FILE", "ROS_DISCOVERY_SERVER",
        "FASTDDS_ENVIRONMENT_FILE", "FASTDDS_STATISTICS"}) {
    if (std::getenv(name) != nullptr) {
      spdlog::warn("{} is ignored: quality of service and network are set by parameters", name);
      ::unsetenv(name);
    }
  }
  ::setenv("SKIP_DEFAULT_XML_FILE", "1", 1);  // one in the working directory
}

/// Takes effect for the participants of this process that are made later.
void set_intra_process(bool on)
{
  eprosima::fastrtps::LibrarySettingsAttributes settings;
  settings.intraprocess_delivery =
    on ? eprosima::fastrtps::INTRAPROCESS_FULL : eprosima::fastrtps::INTRAPROCESS_OFF;
  eprosima::fastrtps::xmlparser::XMLProfileManager::library_settings(settings);
}

/// Threads inherit the mask: signals go to the thread that waits for them, never to these.
class SignalsBlocked
{
public:
  SignalsBlocked()
  {
    sigset_t all;
    ::sigfillset(&all);
    ::pthread_sigmask(SIG_SETMASK, &all, &before_);
  }
  ~SignalsBlocked() { ::pthread_sigmask(SIG_SETMASK, &before_, nullptr); }
  SignalsBlocked(const SignalsBlocked &) = delete;
  SignalsBlocked & operator=(const SignalsBlocked &) = delete;

private:
  sigset_t before_{};
};

}  // namespace

Participant::Participant(const ContextOptions & options)
{
  if (options.domain_id > kHighestDomain) {
    throw std::runtime_error(
      "domain id " + std::to_string(options.domain_id) + ": accepted is 0 to 232");
  }
  if (options.domain_id >= kEphemeralDomain) {
    spdlog::warn("domain id {} uses ephemeral ports, 0 to 101 does not", options.domain_id);
  }
  scrub_environment();
  MiddlewareLog::install();
  set_intra_process(options.intra_process);
  create(options);
  graph_ = std::make_unique<Graph>(*this, to_guid(participant_->guid()), options.distro);
}

Participant::~Participant()
{
  graph_.reset();
  participant_->set_listener(nullptr);
  participant_->delete_contained_entities();
  dds::DomainParticipantFactory::get_instance()->delete_participant(participant_);
}

void Participant::create(const ContextOptions & options)
{
  const SignalsBlocked for_new_threads;
  auto * factory = dds::DomainParticipantFactory::get_instance();
  participant_ = factory->create_participant(
    options.domain_id, participant_qos(options), &peers_, dds::StatusMask::none());
  if (participant_ != nullptr) {
    publisher_ = participant_->create_publisher(dds::PublisherQos());
    subscriber_ = participant_->create_subscriber(dds::SubscriberQos());
  }
  if (publisher_ == nullptr || subscriber_ == nullptr) {
    throw std::runtime_error(
      "domain " + std::to_string(options.domain_id) + ": the middleware makes no participant");
  }
}

dds::Topic & Participant::topic(const std::string & dds_topic, dds::TypeSupport type)
{
  const std::lock_guard<std::mutex> lock(topics_);
  const std::string type_name = type.get_type_name();
  if (auto * known = participant_->lookup_topicdescription(dds_topic)) {
    if (known->get_type_name() != type_name) {
      throw std::runtime_error(
        "topic '" + dds_topic + "' has type '" + known->get_type_name() +
        "' in this process, not '" + type_name + "'");
    }
    return *static_cast<dds::Topic *>(known);
  }
  if (participant_->find_type(type_name).empty()) {
    type->auto_fill_type_object(false);  // names decide, as in ROS 2
    type->auto_fill_type_information(false);
    participant_->register_type(type);
  }
  auto * topic = participant_->create_topic(dds_topic, type_name, dds::TopicQos());
  if (topic == nullptr) {
    throw std::runtime_error("topic '" + dds_topic + "': the middleware makes no such topic");
  }
  return *topic;
}

void Participant::note_match_change()
{
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    ++match_changes_;
  }
  match_changed_.notify_all();
}

// The condition is asked without the lock: it may ask the middleware, whose threads come here.
bool Participant::wait_for(
  const std::function<bool()> & condition, std::chrono::nanoseconds timeout)
{
  const auto deadline = std::chrono::steady_clock::now() + timeout;
  while (true) {
    std::unique_lock<std::mutex> lock(mutex_);
    const auto changes = match_changes_;
    lock.unlock();
    if (condition()) {
      return true;
    }
    lock.lock();
    if (!match_changed_.wait_until(lock, deadline, [&] { return match_changes_ != changes; })) {
      return false;
    }
  }
}

}  // namespace stetro_dds
