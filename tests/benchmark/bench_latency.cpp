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

// Pose latency of the localizer against a relay that only moves messages: one process, and three.
// See latency_path.hpp for what is compared. Writes the percentiles and their ratios as JSON.

#include <cstdio>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <memory>
#include <sstream>
#include <stdexcept>
#include <string>
#include <thread>
#include <vector>

#include "CLI/CLI.hpp"
#include "benchmark/latency_path.hpp"
#include "benchmark/localizer_in_process.hpp"
#include "nlohmann/json.hpp"
#include "stetro_tests/deadline.hpp"
#include "stetro_tests/loopback_domain.hpp"
#include "stetro_tests/process.hpp"
#include "stetro_tests/stack.hpp"

namespace bench
{

using nlohmann::json;
using stetro_tests::poll_until;
using std::chrono_literals::operator""s;

namespace
{

struct Options
{
  std::string role;  ///< empty: start the others
  std::uint32_t domain = 0;
  std::size_t samples = 1800;  ///< poses of each path; the ranges come at 30 Hz
  std::string out = "latency.json";
};

json figures(const LatencyRecord & robot, const LatencyRecord & bare)
{
  json result = {{"samples", robot.size()}, {"raw_samples", bare.size()}};
  for (const auto & [name, share] : {std::pair{"p50", 0.5}, {"p99", 0.99}, {"p999", 0.999}}) {
    const std::string percentile = name;
    result[percentile + "_us"] = robot.percentile_us(share);
    result["raw_" + percentile + "_us"] = bare.percentile_us(share);
    result[percentile + "_ratio"] = robot.percentile_us(share) / bare.percentile_us(share);
  }
  return result;
}

/// Waits until the sink has heard enough on both paths.
json collect(Sink & sink, std::size_t samples)
{
  const std::size_t wanted = samples + Sink::kWarmUp;
  const auto enough = [&] { return sink.robot_count() >= wanted && sink.bare_count() >= wanted; };
  const stetro_tests::Deadline deadline{std::chrono::milliseconds(wanted * 34 * 3 / 2) + 20s};
  while (!enough() && !deadline.passed()) {
    std::this_thread::sleep_for(std::chrono::milliseconds(200));  // seldom: it shares the cores
  }
  const bool heard = enough();
  sink.stop();
  if (!heard) {
    throw std::runtime_error(
      "only " + std::to_string(sink.robot_count()) + " poses of the localizer and " +
      std::to_string(sink.bare_count()) + " of the relay came");
  }
  return figures(sink.robot(), sink.bare());
}

/// Starts the source once both listeners are there.
void start_matched(Source & source)
{
  if (!poll_until([&] { return source.matched(); }, 20s)) {
    throw std::runtime_error("localizer or relay do not listen to the ranges");
  }
  source.start();
}

json run_one_process(const Options & options)
{
  Sink sink(options.domain);
  const LocalizerInProcess localizer(options.domain);
  Relay relay(options.domain);
  Source source(options.domain);
  relay.start();
  sink.start();
  start_matched(source);
  return collect(sink, options.samples);
}

void run_for_ever()
{
  while (true) {
    std::this_thread::sleep_for(1s);
  }
}

int play(const Options & options)
{
  if (options.role == "one_process") {
    std::cout << run_one_process(options) << std::endl;
  } else if (options.role == "sink") {
    Sink sink(options.domain);
    sink.start();
    std::cout << collect(sink, options.samples) << std::endl;
  } else if (options.role == "relay") {
    Relay relay(options.domain);
    relay.start();
    run_for_ever();
  } else {
    Source source(options.domain);
    start_matched(source);
    run_for_ever();
  }
  return 0;
}

/// Starts this program again in another role.
std::unique_ptr<stetro_tests::Process> start_role(
  const std::string & role, const stetro_tests::LoopbackDomain & domain, std::size_t samples)
{
  const auto self = std::filesystem::read_symlink("/proc/self/exe").string();
  return std::make_unique<stetro_tests::Process>(
    std::vector<std::string>{
      self, "--role", role, "--domain", std::to_string(domain.id()), "--samples",
      std::to_string(samples)},
    domain.environment());
}

/// What a role printed, once it has ended well.
json answer_of(stetro_tests::Process & process, std::size_t samples)
{
  const auto ending = process.wait(std::chrono::milliseconds(samples * 60) + 60s);
  if (!ending || ending->exit_code != 0) {
    throw std::runtime_error(process.tail());
  }
  std::istringstream lines(process.output());
  std::string line;
  while (std::getline(lines, line)) {
    if (line.rfind('{', 0) == 0) {  // the log lines around it begin with a bracket
      return json::parse(line);
    }
  }
  throw std::runtime_error("no figures\n" + process.tail());
}

json measure_one_process(const Options & options)
{
  const stetro_tests::LoopbackDomain domain;
  return answer_of(*start_role("one_process", domain, options.samples), options.samples);
}

json measure_three_processes(const Options & options)
{
  const stetro_tests::LoopbackDomain domain;
  stetro_tests::Process localizer(
    stetro_tests::command_of(
      "stetro_localizer", stetro_tests::building_parameters(stetro_tests::papers_staircase())),
    domain.environment());
  const auto relay = start_role("relay", domain, options.samples);
  const auto sink = start_role("sink", domain, options.samples);
  const auto source = start_role("source", domain, options.samples);
  return answer_of(*sink, options.samples);
}

int orchestrate(const Options & options)
{
  json result;
  result["one_process"] = measure_one_process(options);
  result["three_processes"] = measure_three_processes(options);
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
  CLI::App app("Pose latency of the localizer against a bare relay.");
  app.add_option("--samples", options.samples, "poses of each path and layout")
    ->check(CLI::Range(30, 1000000));
  app.add_option("--out", options.out, "where the figures go");
  app.add_option("--role", options.role, "for its own use")
    ->check(CLI::IsMember({"source", "relay", "sink", "one_process"}));
  app.add_option("--domain", options.domain, "for its own use");
  CLI11_PARSE(app, argc, argv);
  try {
    return options.role.empty() ? bench::orchestrate(options) : bench::play(options);
  } catch (const std::exception & error) {
    std::cerr << "bench_latency: " << error.what() << "\n";
    return 1;
  }
}
