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

#include <gtest/gtest.h>
#include <stdlib.h>
#include <unistd.h>

#include <array>
#include <stdexcept>
#include <string>

#include "device_bench.hpp"
#include "linux/service_notify.hpp"

namespace stetro_driver::linux_io
{
namespace
{

using std::chrono::milliseconds;

/// The service manager's end.
class Manager
{
public:
  explicit Manager(const std::string & name)
  : fd_(socket(AF_UNIX, SOCK_DGRAM | SOCK_NONBLOCK | SOCK_CLOEXEC, 0))
  {
    sockaddr_un at{};
    at.sun_family = AF_UNIX;
    name.copy(at.sun_path, sizeof(at.sun_path) - 1);
    if (name[0] == '@') {
      at.sun_path[0] = '\0';
    }
    const auto size = static_cast<socklen_t>(offsetof(sockaddr_un, sun_path) + name.size());
    EXPECT_EQ(bind(fd_, reinterpret_cast<const sockaddr *>(&at), size), 0);
  }
  ~Manager() { close(fd_); }
  Manager(const Manager &) = delete;
  Manager & operator=(const Manager &) = delete;

  /// The next datagram; empty: there is none.
  std::string heard()
  {
    std::array<char, 256> text{};
    const ssize_t size = recv(fd_, text.data(), text.size(), 0);
    return size > 0 ? std::string(text.data(), static_cast<std::size_t>(size)) : "";
  }

private:
  int fd_;
};

std::string abstract_name() { return "@stetro_notify_" + std::to_string(getpid()); }

TEST(ServiceNotify, SpeaksToAnAbstractSocket)
{
  Manager manager(abstract_name());
  ServiceNotify notify(abstract_name());
  EXPECT_TRUE(notify.asked());
  EXPECT_TRUE(notify.ready());
  EXPECT_EQ(manager.heard(), "READY=1");
  EXPECT_TRUE(notify.status("sweeping step 3"));
  EXPECT_EQ(manager.heard(), "STATUS=sweeping step 3");
  EXPECT_TRUE(notify.stopping());
  EXPECT_EQ(manager.heard(), "STOPPING=1");
}

TEST(ServiceNotify, SpeaksToASocketWithAPath)
{
  const TempDirectory directory;
  const std::string name = directory.path() / "notify";
  {
    Manager manager(name);
    ServiceNotify notify(name);
    EXPECT_TRUE(notify.ready());
    EXPECT_EQ(manager.heard(), "READY=1");
  }
  ServiceNotify late(name);
  EXPECT_FALSE(late.ready()) << "nobody listens any more, and that is no reason to wait";
}

TEST(ServiceNotify, AStatusCannotSayAnythingElse)
{
  Manager manager(abstract_name());
  ServiceNotify notify(abstract_name());
  notify.status("IMU: silent\nWATCHDOG=1");
  EXPECT_EQ(manager.heard(), "STATUS=IMU: silent WATCHDOG=1") << "one assignment";
}

TEST(ServiceNotify, FeedsTheWatchdogOnceInHalfItsPeriodAndOnlyWhenAsked)
{
  Manager manager(abstract_name());
  ServiceNotify notify(abstract_name(), milliseconds{1000});
  int fed = 0;
  for (int now_ms = 0; now_ms < 5000; now_ms += 10) {  // a loop at 100 Hz
    notify.alive(milliseconds{now_ms});
    fed += manager.heard() == "WATCHDOG=1" ? 1 : 0;
  }
  EXPECT_EQ(fed, 10) << "at 0, 0.5, 1 ... 4.5 s";
  EXPECT_EQ(manager.heard(), "") << "the health did not hold, the loop did not ask";
  notify.alive(milliseconds{9000});
  EXPECT_EQ(manager.heard(), "WATCHDOG=1") << "at once when it holds again";
}

TEST(ServiceNotify, WithoutAWatchdogOrASocketNothingIsSent)
{
  Manager manager(abstract_name());
  ServiceNotify unwatched(abstract_name());
  unwatched.alive(milliseconds{1});
  EXPECT_EQ(manager.heard(), "");
  ServiceNotify nobody("", milliseconds{1000});
  EXPECT_FALSE(nobody.asked());
  EXPECT_FALSE(nobody.ready());
  nobody.alive(milliseconds{1});
}

/// Sets a variable of the environment, and takes it away.
class Variable
{
public:
  Variable(const char * name, const std::string & value) : name_(name)
  {
    setenv(name, value.c_str(), 1);
  }
  ~Variable() { unsetenv(name_); }
  Variable(const Variable &) = delete;
  Variable & operator=(const Variable &) = delete;

private:
  const char * name_;
};

TEST(ServiceNotify, ReadsWhatSystemdPutIntoTheEnvironment)
{
  EXPECT_FALSE(ServiceNotify::from_environment().asked());
  const Variable socket("NOTIFY_SOCKET", abstract_name());
  const Variable period("WATCHDOG_USEC", "2000000");
  EXPECT_TRUE(ServiceNotify::from_environment().asked());
  EXPECT_EQ(ServiceNotify::from_environment().watchdog(), milliseconds{2000});
  {
    const Variable pid("WATCHDOG_PID", std::to_string(getpid()));
    EXPECT_TRUE(ServiceNotify::from_environment().watchdog());
  }
  const Variable pid("WATCHDOG_PID", "1");
  EXPECT_FALSE(ServiceNotify::from_environment().watchdog()) << "meant for another process";
}

TEST(ServiceNotify, RefusesWhatItCannotUse)
{
  EXPECT_THROW(ServiceNotify("relative/path"), std::invalid_argument);
  EXPECT_THROW(ServiceNotify("vsock:2:1234"), std::invalid_argument);
  EXPECT_THROW(ServiceNotify("/" + std::string(200, 'a')), std::invalid_argument);
  const Variable period("WATCHDOG_USEC", "2s");
  EXPECT_THROW(static_cast<void>(ServiceNotify::from_environment()), std::invalid_argument);
}

}  // namespace
}  // namespace stetro_driver::linux_io
