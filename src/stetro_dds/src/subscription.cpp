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

#include "stetro_dds/subscription.hpp"

#include <algorithm>
#include <atomic>
#include <chrono>
#include <memory>
#include <optional>
#include <stdexcept>
#include <string>
#include <utility>

#include "dds_qos.hpp"
#include "fastdds/dds/core/condition/StatusCondition.hpp"
#include "fastdds/dds/subscriber/DataReader.hpp"
#include "fastdds/dds/subscriber/DataReaderListener.hpp"
#include "fastdds/dds/subscriber/SampleInfo.hpp"
#include "participant.hpp"
#include "wait_set.hpp"

namespace stetro_dds
{

namespace dds = eprosima::fastdds::dds;
namespace rtps = eprosima::fastrtps::rtps;

namespace
{

constexpr std::size_t kMostReasons = 32;  // further ones share a counter

/// The middleware stamps with the system clock; a step between then and now must not make a
/// sample younger than now.
Time steady_time_of(const rtps::Time_t & received)
{
  const Time wall = std::chrono::system_clock::now().time_since_epoch();
  const Time age = wall - Time{received.to_ns()};
  return Clock::steady_now() - std::max(age, Time{0});
}

}  // namespace

/// The middleware's reader; as its listener it only records.
class SubscriptionBase::Reader : public dds::DataReaderListener
{
public:
  Reader(
    SubscriptionBase & owner, Participant & participant, const std::string & dds_topic,
    const dds::TypeSupport & type)
  : owner_(owner), participant_(participant)
  {
    auto & topic = participant.topic(dds_topic, type);
    reader_ = participant.subscriber().create_datareader(
      &topic, reader_qos(owner.profile(), *type), this,
      dds::StatusMask::subscription_matched() << dds::StatusMask::sample_lost());
    if (reader_ == nullptr) {
      throw std::runtime_error("topic '" + owner.topic() + "': the middleware makes no reader");
    }
    reader_->get_statuscondition().set_enabled_statuses(dds::StatusMask::data_available());
  }

  ~Reader() override
  {
    reader_->set_listener(nullptr);
    participant_.subscriber().delete_datareader(reader_);
  }

  Reader(const Reader &) = delete;
  Reader & operator=(const Reader &) = delete;

  dds::DataReader & get() { return *reader_; }
  dds::SampleInfo & info() { return info_; }
  [[nodiscard]] std::uint64_t lost() const { return lost_; }

  void on_subscription_matched(
    dds::DataReader * /*reader*/, const dds::SubscriptionMatchedStatus & status) override
  {
    owner_.matched_ = status.current_count;
    participant_.note_match_change();
  }

  void on_sample_lost(dds::DataReader * /*reader*/, const dds::SampleLostStatus & status) override
  {
    lost_ += static_cast<std::uint64_t>(std::max(status.total_count_change, 0));
  }

private:
  SubscriptionBase & owner_;
  Participant & participant_;
  dds::DataReader * reader_ = nullptr;
  dds::SampleInfo info_;
  std::atomic<std::uint64_t> lost_{0};
};

SubscriptionBase::SubscriptionBase(
  Participant & participant, std::string topic, const std::string & dds_topic,
  const dds::TypeSupport & type, const QosProfile & profile)
: Endpoint(std::move(topic), type.get_type_name(), profile),
  reader_(std::make_unique<Reader>(*this, participant, dds_topic, type))
{
}

SubscriptionBase::~SubscriptionBase() = default;

Guid SubscriptionBase::guid() const { return to_guid(reader_->get().guid()); }

std::size_t SubscriptionBase::take(std::size_t limit)
{
  auto & malformed = detail::malformed_on_this_thread();
  auto & info = reader_->info();
  std::size_t taken = 0;
  while (taken < limit) {
    const auto malformed_before = malformed;
    const auto code = reader_->get().take_next_sample(message(), &info);
    const auto bad = malformed - malformed_before;
    counts_.malformed += bad;
    taken += bad;
    // One call may drop malformed samples and still bring the sound one behind them.
    if (code != eprosima::fastrtps::types::ReturnCode_t::RETCODE_OK) {
      if (bad == 0) {
        break;
      }
    } else if (info.valid_data) {
      ++taken;
      count(deliver(
        {steady_time_of(info.reception_timestamp), to_guid(info.sample_identity.writer_guid())}));
    }
  }
  return taken;
}

void SubscriptionBase::count(std::optional<Refusal> refusal)
{
  if (!refusal) {
    ++counts_.accepted;
    return;
  }
  ++counts_.refused;
  auto & reasons = counts_.refused_by_reason;
  const bool room = reasons.size() < kMostReasons || reasons.count(refusal->reason) > 0;
  ++reasons[room ? refusal->reason : "others"];
  last_refusal_ = std::move(*refusal);
}

SubscriptionCounts SubscriptionBase::counts() const
{
  SubscriptionCounts counts = counts_;
  counts.lost = reader_->lost();
  return counts;
}

void SubscriptionBase::attach_to(WaitSet & wait_set)
{
  wait_set.attach(reader_->get().get_statuscondition());
}

void SubscriptionBase::detach_from(WaitSet & wait_set)
{
  wait_set.detach(reader_->get().get_statuscondition());
}

}  // namespace stetro_dds
