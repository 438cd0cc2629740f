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

#include "stetro_dds/publisher.hpp"

#include <memory>
#include <stdexcept>
#include <string>
#include <utility>

#include "dds_qos.hpp"
#include "fastdds/dds/publisher/DataWriter.hpp"
#include "fastdds/dds/publisher/DataWriterListener.hpp"
#include "participant.hpp"

namespace stetro_dds
{

namespace dds = eprosima::fastdds::dds;

/// The middleware's writer; as its listener it only records.
class PublisherBase::Writer : public dds::DataWriterListener
{
public:
  Writer(
    PublisherBase & owner, Participant & participant, const std::string & dds_topic,
    const dds::TypeSupport & type)
  : owner_(owner), participant_(participant)
  {
    auto & topic = participant.topic(dds_topic, type);
    writer_ = participant.publisher().create_datawriter(
      &topic, writer_qos(owner.profile(), *type), this, dds::StatusMask::publication_matched());
    if (writer_ == nullptr) {
      throw std::runtime_error("topic '" + owner.topic() + "': the middleware makes no writer");
    }
  }

  ~Writer() override
  {
    writer_->set_listener(nullptr);
    participant_.publisher().delete_datawriter(writer_);
  }

  Writer(const Writer &) = delete;
  Writer & operator=(const Writer &) = delete;

  dds::DataWriter & get() { return *writer_; }

  void on_publication_matched(
    dds::DataWriter * /*writer*/, const dds::PublicationMatchedStatus & status) override
  {
    owner_.matched_ = status.current_count;
    participant_.note_match_change();
  }

private:
  PublisherBase & owner_;
  Participant & participant_;
  dds::DataWriter * writer_ = nullptr;
};

PublisherBase::PublisherBase(
  Participant & participant, std::string topic, const std::string & dds_topic,
  const dds::TypeSupport & type, const QosProfile & profile)
: Endpoint(std::move(topic), type.get_type_name(), profile),
  writer_(std::make_unique<Writer>(*this, participant, dds_topic, type))
{
}

PublisherBase::~PublisherBase() = default;

Guid PublisherBase::guid() const { return to_guid(writer_->get().guid()); }

bool PublisherBase::write(const void * message)
{
  const bool written = writer_->get().write(const_cast<void *>(message));
  ++(written ? published_ : failed_);
  return written;
}

PublisherCounts PublisherBase::counts() const { return {published_, failed_, out_of_bounds_}; }

}  // namespace stetro_dds
