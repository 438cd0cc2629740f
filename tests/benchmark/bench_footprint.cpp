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

// CPU and memory of localizer and supervisor while the robot climbs in real time, against bare
// endpoints that read and write the same messages at the same rates at the same time.

#include <algorithm>
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <map>
#include <memory>
#include <string>
#include <thread>
#include <vector>

#include "CLI/CLI.hpp"
#include "benchmark/process_usage.hpp"
#include "benchmark/topic_table.hpp"
#include "nlohmann/json.hpp"
#include "stetro_tests/robot_run.hpp"

namespace bench
{

using nlohmann::json;
using stetro_tests::Process;
using stetro_tests::RobotRun;
using std::chrono_literals::operator""s;

namespace
{

constexpr double kMostCpuRatio = 1.5;
constexpr double kMostPss_mib = 15.0;

struct Options
{
  std::uint32_t domain = 0;
  std::vector<std::string> reads;   ///< topics; with these it is a bare process
  std::vector<std::string> writes;  ///< topic=rate_hz=file with the message's bytes
  int seconds = 30;
  std::string out = "footprint.json";
};

/// What a node exchanges: the topics it reads and those it writes.
struct NodeTopics
{
  std::vector<std::string> reads;
  std::vector<std::string> writes;
};

const std::map<std::string, NodeTopics> & nodes()
{
  static const std::map<std::string, NodeTopics> table = {
    {"driver",
     {{"/stetro/command"},
      {"/stetro/ranges", "/stetro/contacts", "/stetro/blocks", "/stetro/imu/data", "/stetro/odom",
       "/stetro/command_status", "/clock", "/stetro/ground_truth"}}},
    {"localizer",
     {{"/stetro/ranges", "/stetro/contacts", "/stetro/blocks", "/stetro/imu/data", "/stetro/odom",
       "/clock"},
      {"/stetro/pose", "/stetro/stair_pose", "/stetro/innovations", "/tf"}}},
    {"supervisor",
     {{"/stetro/ranges", "/stetro/contacts", "/stetro/blocks", "/stetro/odom",
       "/stetro/command_status", "/stetro/stair_pose", "/clock"},
      {"/stetro/command", "/stetro/mission_status", "/fleet_states"}}},
    // The test's own ears: who writes to them has as much to send on both sides.
    {"observer",
     {{"/stetro/stair_pose", "/stetro/mission_status", "/stetro/command", "/stetro/command_status",
       "/stetro/ground_truth"},
      {}}}};
  return table;
}

struct Stream
{
  std::chrono::steady_clock::time_point due;
  std::chrono::nanoseconds period;
  std::function<void()> write;
};

/// "topic=rate_hz=file" as a stream.
Stream stream_of(const std::string & text, bare::Participant & participant)
{
  const auto first = text.find('=');
  const auto second = text.find('=', first + 1);
  const double rate_hz = std::stod(text.substr(first + 1, second - first - 1));
  std::ifstream file(text.substr(second + 1), std::ios::binary);
  const Bytes bytes{std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()};
  return {
    std::chrono::steady_clock::now(),
    std::chrono::nanoseconds(static_cast<std::int64_t>(1e9 / rate_hz)),
    topic_named(text.substr(0, first)).write(participant, bytes)};
}

/// Reads and writes at the rates told until it is killed.
int be_bare(const Options & options)
{
  bare::Participant participant(options.domain);
  bare::Dispatch dispatch;
  for (const auto & topic : options.reads) {
    topic_named(topic).read(participant, dispatch);
  }
  std::vector<Stream> streams;
  for (const auto & text : options.writes) {
    streams.push_back(stream_of(text, participant));
  }
  dispatch.start();
  const auto earlier = [](const Stream & a, const Stream & b) { return a.due < b.due; };
  while (streams.empty()) {
    std::this_thread::sleep_for(1s);
  }
  while (true) {
    Stream & next = *std::min_element(streams.begin(), streams.end(), earlier);
    std::this_thread::sleep_until(next.due);
    next.write();
    next.due += next.period;
  }
}

/// How often each topic speaks, and the file with its last message.
struct Traffic
{
  double rate_hz;
  std::string file;
};

/// Listens to the climbing robot for some seconds.
std::map<std::string, Traffic> listen(
  const stetro_tests::LoopbackDomain & domain, const std::filesystem::path & folder, int seconds)
{
  stetro_tests::Observer ears(domain, "ears");
  std::map<std::string, std::function<Heard()>> heard;
  for (const TopicKind & topic : topic_table()) {
    heard[topic.name] = topic.listen(ears);
  }
  ears.start();
  std::this_thread::sleep_for(std::chrono::seconds(seconds));
  std::map<std::string, Traffic> result;
  for (const auto & [name, ask] : heard) {
    const Heard seen = ask();
    std::string file = name;
    std::replace(file.begin(), file.end(), '/', '_');
    const auto path = (folder / file).string();
    std::ofstream(path, std::ios::binary)
      .write(
        reinterpret_cast<const char *>(seen.last.data()),
        static_cast<std::streamsize>(seen.last.size()));
    result[name] = {static_cast<double>(seen.count) / seconds, path};
  }
  return result;
}

std::unique_ptr<Process> start_bare(
  const NodeTopics & topics, const std::map<std::string, Traffic> & traffic,
  const stetro_tests::LoopbackDomain & domain)
{
  std::vector<std::string> command = {
    std::filesystem::read_symlink("/proc/self/exe").string(), "--domain",
    std::to_string(domain.id())};
  for (const auto & topic : topics.reads) {
    command.insert(command.end(), {"--read", topic});
  }
  for (const auto & topic : topics.writes) {
    const Traffic & told = traffic.at(topic);
    if (told.rate_hz > 0.0) {
      command.insert(
        command.end(), {"--write", topic + "=" + std::to_string(told.rate_hz) + "=" + told.file});
    }
  }
  return std::make_unique<Process>(command, domain.environment());
}

/// CPU shares and memory of the robot's processes and their bare twins over the same seconds.
json compare(
  const std::map<std::string, Process *> & robot, const std::map<std::string, Process *> & twins,
  int seconds)
{
  std::map<std::string, std::chrono::nanoseconds> before;
  for (const auto & [name, process] : robot) {
    before[name] = cpu_time_of(process->pid());
    before["bare " + name] = cpu_time_of(twins.at(name)->pid());
  }
  std::this_thread::sleep_for(std::chrono::seconds(seconds));
  json result;
  for (const auto & [name, process] : robot) {
    const auto share = [&](const std::string & who, const Process & of) {
      return std::chrono::duration<double>(cpu_time_of(of.pid()) - before[who]).count() / seconds;
    };
    const double ours = share(name, *process);
    const double bare_share = share("bare " + name, *twins.at(name));
    result[name] = {
      {"cpu_share", ours},
      {"bare_cpu_share", bare_share},
      {"cpu_ratio", ours / bare_share},
      {"pss_mib", pss_mib_of(process->pid())},
      {"bare_pss_mib", pss_mib_of(twins.at(name)->pid())}};
  }
  return result;
}

void note_targets(json & result)
{
  for (auto & [name, figures] : result.items()) {
    const bool has_cpu_target = name != "driver";
    figures["meets_targets"] = figures["pss_mib"] <= kMostPss_mib &&
                               (!has_cpu_target || figures["cpu_ratio"] <= kMostCpuRatio);
  }
}

int measure(const Options & options)
{
  stetro_tests::StackOptions robot;
  robot.speed = 1.0;
  robot.site = stetro_tests::papers_staircase();
  const auto run = std::make_unique<RobotRun>(robot);
  if (const auto trouble = run->start_climb(); !trouble.empty()) {
    throw std::runtime_error(trouble);
  }
  const stetro_tests::TemporaryFolder folder;
  const auto traffic = listen(run->domain, folder.path(), 10);
  const stetro_tests::LoopbackDomain elsewhere;
  std::map<std::string, std::unique_ptr<Process>> twins;
  std::map<std::string, Process *> twin_pointers;
  for (const auto & [name, topics] : nodes()) {
    twins[name] = start_bare(topics, traffic, elsewhere);
    twin_pointers[name] = twins[name].get();
  }
  std::this_thread::sleep_for(3s);  // discovery and first messages are not what is measured
  json result = compare(
    {{"driver", &run->stack.driver()},
     {"localizer", &run->stack.localizer()},
     {"supervisor", &run->stack.supervisor()}},
    twin_pointers, options.seconds);
  note_targets(result);
  std::filesystem::create_directories(std::filesystem::absolute(options.out).parent_path());
  std::ofstream(options.out) << result.dump(2) << "\n";
  std::cout << result.dump(2) << std::endl;
  return 0;
}

}  // namespace

}  // namespace bench

int main(int argc, char ** argv)
{
  bench::Options options;
  CLI::App app("CPU and memory of localizer and supervisor against bare endpoints.");
  app.add_option("--seconds", options.seconds, "to measure for")->check(CLI::Range(1, 3600));
  app.add_option("--out", options.out, "where the figures go");
  app.add_option("--domain", options.domain, "for its own use");
  app.add_option("--read", options.reads, "for its own use");
  app.add_option("--write", options.writes, "for its own use");
  CLI11_PARSE(app, argc, argv);
  try {
    return options.reads.empty() ? bench::measure(options) : bench::be_bare(options);
  } catch (const std::exception & error) {
    std::cerr << "bench_footprint: " << error.what() << "\n";
    return 1;
  }
}
