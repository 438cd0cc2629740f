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

// The control loop at its rate around emulated devices at the real speed of their protocols: how
// well it keeps its time, what it costs, and what it allocates. Writes the figures as JSON.

#include <sys/resource.h>

#include <atomic>
#include <chrono>
#include <fstream>
#include <iostream>
#include <memory>
#include <string>
#include <utility>

#include "CLI/CLI.hpp"
#include "control_loop.hpp"
#include "stetro_config/fault.hpp"
#include "stetro_driver/driver_hardware.hpp"
#include "thread_allocations.hpp"

namespace stetro_driver
{
namespace
{

Time steady_now() { return std::chrono::steady_clock::now().time_since_epoch(); }

double cpu_s(int whose)
{
  rusage usage{};
  getrusage(whose, &usage);
  const auto seconds = [](const timeval & time) {
    return static_cast<double>(time.tv_sec) + 1e-6 * static_cast<double>(time.tv_usec);
  };
  return seconds(usage.ru_utime) + seconds(usage.ru_stime);
}

/// Passes everything on, and counts what the thread that reads has cost since it was told to.
class Meter : public HardwareInterface
{
public:
  explicit Meter(HardwareInterface & robot) : robot_(robot) {}
  void configure() override { robot_.configure(); }
  void activate() override { robot_.activate(); }
  void deactivate() override { robot_.deactivate(); }
  void reset_emergency_stop() override { robot_.reset_emergency_stop(); }
  Result<SensorFrame> read(Time now) override
  {
    if (begin_.exchange(false)) {
      allocations_before_ = thread_allocations();
      cpu_before_s_ = cpu_s(RUSAGE_THREAD);
    }
    allocated = thread_allocations() - allocations_before_;
    loop_cpu_s = cpu_s(RUSAGE_THREAD) - cpu_before_s_;
    return robot_.read(now);
  }
  std::optional<IoFault> write(const JointCommand & command) override
  {
    return robot_.write(command);
  }
  void make_safe() noexcept override { robot_.make_safe(); }

  void begin() { begin_ = true; }
  std::atomic<std::uint64_t> allocated{0};
  std::atomic<double> loop_cpu_s{0.0};

private:
  HardwareInterface & robot_;
  std::atomic<bool> begin_{false};
  std::uint64_t allocations_before_ = 0;
  double cpu_before_s_ = 0.0;
};

struct Options
{
  std::string site;
  std::string robot;
  std::string out = "control_loop.json";
  double seconds = 30.0;
  double rate_hz = 100.0;
};

DriverSetup setup_for(const Options & options)
{
  DriverParams params;
  params.hardware = "emulated";
  params.site_file = options.site;
  params.robot_file = options.robot;
  stetro_config::Faults faults;
  auto setup = read_setup(params, faults);
  faults.throw_if_any();
  return std::move(setup).value();
}

/// Rolls to and fro, so that commands and their ends are part of what is measured.
void drive(ControlLoop & loop, double seconds)
{
  const Time begin = steady_now();
  for (int turn = 0; time_to_seconds(steady_now() - begin) < seconds; ++turn) {
    JointCommand roll;
    roll.kind = MotionKind::kTwist;
    roll.vx_m_s = turn % 40 < 20 ? 0.05 : -0.05;
    loop.command({true, roll, steady_now() + std::chrono::milliseconds{150}, 1});
    SensorFrame frame;
    while (loop.take(frame)) {
    }
    loop.wait(std::chrono::milliseconds{50});
  }
}

int run(const Options & options)
{
  const DriverHardware hardware = make_hardware(setup_for(options));
  Meter meter{*hardware.robot};
  meter.configure();
  meter.activate();
  ControlLoop loop{
    meter, [world = hardware.world] { return world->time(); },
    seconds_to_time(1.0 / options.rate_hz)};
  loop.start();
  drive(loop, 2.0);  // warm
  meter.begin();
  const double cpu_before_s = cpu_s(RUSAGE_SELF);
  const Time begin = steady_now();
  drive(loop, options.seconds);
  const double took_s = time_to_seconds(steady_now() - begin);
  const double cpu_share = (cpu_s(RUSAGE_SELF) - cpu_before_s) / took_s;
  const linux_io::LoopSummary summary = loop.summary();
  loop.stop();
  std::ofstream out(options.out);
  out << "{\n  \"rate_hz\": " << options.rate_hz << ",\n  \"seconds\": " << took_s
      << ",\n  \"cycles\": " << summary.cycles << ",\n  \"overruns\": " << summary.overruns
      << ",\n  \"periods_missed\": " << loop.missed()
      << ",\n  \"period_error_p50_s\": " << time_to_seconds(summary.period_error_p50)
      << ",\n  \"period_error_p999_s\": " << time_to_seconds(summary.period_error_p999)
      << ",\n  \"period_error_max_s\": " << time_to_seconds(summary.period_error_max)
      << ",\n  \"mean_work_s\": " << time_to_seconds(summary.mean_work)
      << ",\n  \"longest_work_s\": " << time_to_seconds(summary.longest_work)
      << ",\n  \"loop_cpu_share\": " << meter.loop_cpu_s / took_s
      << ",\n  \"process_cpu_share\": " << cpu_share
      << ",\n  \"loop_allocations\": " << meter.allocated << "\n}\n";
  out.close();
  std::cout << std::ifstream(options.out).rdbuf();
  return meter.allocated == 0 ? 0 : 1;
}

}  // namespace
}  // namespace stetro_driver

int main(int argc, char ** argv)
{
  CLI::App app{"The control loop around emulated devices: timing, CPU, allocations."};
  stetro_driver::Options options;
  app.add_option("--site", options.site, "site file")->required()->check(CLI::ExistingFile);
  app.add_option("--robot", options.robot, "robot file")->required()->check(CLI::ExistingFile);
  app.add_option("--out", options.out, "figures as JSON")->capture_default_str();
  app.add_option("--seconds", options.seconds, "to measure")->capture_default_str();
  app.add_option("--rate", options.rate_hz, "of the loop [Hz]")->capture_default_str();
  CLI11_PARSE(app, argc, argv);
  return stetro_driver::run(options);
}
