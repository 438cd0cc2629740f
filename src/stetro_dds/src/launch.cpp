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

#include "stetro_dds/launch.hpp"

#include <spdlog/sinks/stdout_color_sinks.h>
#include <spdlog/spdlog.h>

#include <algorithm>
#include <exception>
#include <functional>
#include <iostream>
#include <memory>
#include <mutex>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "stetro_dds/shutdown_signal.hpp"

namespace stetro_dds
{

namespace
{

constexpr char kRosHelp[] =
  "ROS 2 arguments, after --ros-args:\n"
  "  --params-file FILE          parameters (YAML), may be repeated, the last wins\n"
  "  -p [node:]name:=value       one parameter, stronger than any file\n"
  "  -r __ns:=/x  -r __node:=y   another namespace, another name\n"
  "  -r from:=to                 another topic\n"
  "  --log-level LEVEL           debug, info, warn, error or fatal\n";

void log_to_stderr(const std::string & program, const std::string & level)
{
  auto sink = std::make_shared<spdlog::sinks::stderr_color_sink_mt>();
  auto logger = std::make_shared<spdlog::logger>(program, std::move(sink));
  logger->set_pattern("[%Y-%m-%d %H:%M:%S.%e] [%^%l%$] [%n] %v");
  logger->set_level(level == "fatal" ? spdlog::level::critical : spdlog::level::from_str(level));
  spdlog::set_default_logger(logger);
}

bool means(const std::string & addressed, const std::string & name, const std::string & full_name)
{
  return addressed.empty() || addressed == name || addressed == full_name;
}

/// \return the exit code, or nothing to go on
std::optional<int> parse_own_options(
  const Program & program, const std::vector<std::string> & words)
{
  CLI::App app{program.summary, program.name};
  app.footer(kRosHelp);
  if (program.options) {
    program.options(app);
  }
  std::vector<const char *> argv;
  std::transform(words.begin(), words.end(), std::back_inserter(argv), [](const auto & word) {
    return word.c_str();
  });
  try {
    app.parse(static_cast<int>(argv.size()), argv.data());
  } catch (const CLI::ParseError & error) {
    return app.exit(error) == 0 ? 0 : 2;
  }
  return std::nullopt;
}

}  // namespace

Launch::Launch(RosArguments arguments)
: arguments_(std::move(arguments)), files_(arguments_.params_files, faults_)
{
}

NodeOptions Launch::node_options(const std::string & name, const std::string & ns)
{
  NodeOptions options;
  options.name = name;
  options.ns = ns;
  for (const auto & [node, rule] : arguments_.remappings) {
    if (!means(node, name, NodeName{ns, name}.full())) {
      continue;
    }
    if (rule.from == "__ns") {
      options.ns = rule.to;
    } else if (rule.from == "__node" || rule.from == "__name") {
      options.name = rule.to;
    } else {
      options.remappings.push_back(rule);
    }
  }
  const NodeName node_name{options.ns, options.name};
  try {
    validate(node_name);
    resolve_topic("any", node_name, options.remappings);
  } catch (const NameError & error) {
    faults_.add({"command line", 0, error.kind, error.value, error.accepted});
  }
  names_.insert({name, node_name.name, node_name.full()});
  full_names_.push_back(node_name.full());
  return options;
}

void Launch::each_override(
  const NodeOptions & options, const std::string & default_name,
  const std::function<void(const std::string &, const std::string &)> & visit_override) const
{
  const auto full_name = NodeName{options.ns, options.name}.full();
  for (const auto & override : arguments_.overrides) {
    if (means(override.node, options.name, full_name) || override.node == default_name) {
      visit_override(override.name, override.value);
    }
  }
}

void Launch::adopt(const NodeParams & params, NodeOptions & options)
{
  options.time = params.use_sim_time ? TimeSource::kClockTopic : TimeSource::kSystem;
  if (!common_) {
    common_ = params;
  }
  const auto agree = [&](const char * name, const std::string & first, const std::string & other) {
    if (first != other) {
      faults_.refuse(name, other, first + ", as another node of this process has it");
    }
  };
  agree("dds.network", common_->network, params.network);
  agree("dds.ros_distro", common_->ros_distro, params.ros_distro);
}

void Launch::warn_of_strays() const
{
  std::string ours;
  for (const auto & name : full_names_) {
    ours += (ours.empty() ? "" : ", ") + name;
  }
  for (const auto & section : files_.sections_for_none_of(full_names_)) {
    spdlog::warn(
      "{}:{}: section '{}' names no node of this program ({}), its parameters are not read",
      section.origin.file, section.origin.line, section.pattern, ours);
  }
}

void Launch::check() const
{
  std::call_once(strays_told_, [this] { warn_of_strays(); });
  stetro_config::Faults all = faults_;
  for (const auto & override : arguments_.overrides) {
    if (!override.node.empty() && names_.count(override.node) == 0) {
      all.add(
        {"command line", 0, "-p " + override.node + ":" + override.name, override.value,
         "the name of a node of this process"});
    }
  }
  all.throw_if_any();
}

ContextOptions Launch::context_options() const
{
  check();
  return stetro_dds::context_options(common_.value_or(NodeParams{}));
}

void Launch::spin(Executor & executor)
{
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    if (stop_requested_) {
      return;
    }
    spinning_ = &executor;
  }
  executor.spin();
  const std::lock_guard<std::mutex> lock(mutex_);
  spinning_ = nullptr;
}

void Launch::stop()
{
  const std::lock_guard<std::mutex> lock(mutex_);
  stop_requested_ = true;
  if (spinning_ != nullptr) {
    spinning_->stop();
  }
}

int run_main(
  int argc, const char * const * argv, const Program & program,
  const std::function<int(Launch &)> & body)
{
  log_to_stderr(program.name, "info");
  try {
    auto arguments = RosArguments::parse(argc, argv);
    log_to_stderr(program.name, arguments.log_level);
    if (const auto exit_code = parse_own_options(program, arguments.others)) {
      return *exit_code;
    }
    Launch launch(std::move(arguments));
    const ShutdownSignal signal([&launch] { launch.stop(); });
    return body(launch);
  } catch (const stetro_config::ConfigError & error) {
    std::cerr << error.what() << std::endl;
    return 2;
  } catch (const std::exception & error) {
    spdlog::critical("{}", error.what());
    return 1;
  }
}

}  // namespace stetro_dds
