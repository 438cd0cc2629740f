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

// A node of no consequence, for tests that start, question and kill processes.

#include <chrono>
#include <cstdint>
#include <string>

#include "stetro_config/field.hpp"
#include "stetro_dds/launch.hpp"
#include "stetro_msgs/String.hpp"

namespace
{

struct LonelyParams
{
  std::string greeting = "hello";
  double period_s = 0.05;
  bool hang = false;
};

template <class Visitor>
void visit(LonelyParams & p, Visitor && each)
{
  using stetro_config::Any, stetro_config::NonEmpty, stetro_config::Within;
  each("greeting", p.greeting, NonEmpty{}, "what it says on `hello`");
  each("period_s", p.period_s, Within{0.001, 10.0}, "how often [s]");
  each("hang", p.hang, Any{}, "do not end when told to");
}

int run(stetro_dds::Launch & launch)
{
  using std_msgs::msg::String;
  const auto lonely = launch.configure<LonelyParams>("lonely", "/test");
  stetro_dds::Context context(launch.context_options());
  stetro_dds::Node node(context, lonely.options);
  auto & hello = node.advertise<String>("hello", stetro_dds::qos::kPose);
  auto & echo = node.advertise<String>("echo", stetro_dds::qos::kPose);
  node.subscribe<String>(
    "say", stetro_dds::qos::kPose, [&echo](const String & message) { echo.publish(message); });
  String greeting;
  greeting.data(lonely.params.greeting);
  const auto period = std::chrono::duration_cast<std::chrono::nanoseconds>(
    std::chrono::duration<double>(lonely.params.period_s));
  node.create_timer(period, [&](stetro_dds::Time) { hello.publish(greeting); });
  stetro_dds::Executor executor;
  executor.add(node);
  launch.spin(executor);
  while (lonely.params.hang) {
    std::this_thread::sleep_for(std::chrono::seconds(1));
  }
  return 0;
}

}  // namespace

int main(int argc, char ** argv)
{
  return stetro_dds::run_main(argc, argv, {"lonely_node", "Says hello, and echoes."}, run);
}
