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

#ifndef STETRO_DDS__LAUNCH_HPP_
#define STETRO_DDS__LAUNCH_HPP_

#include <atomic>
#include <functional>
#include <mutex>
#include <optional>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "CLI/CLI.hpp"
#include "stetro_config/loader.hpp"
#include "stetro_dds/context.hpp"
#include "stetro_dds/executor.hpp"
#include "stetro_dds/node.hpp"
#include "stetro_dds/node_params.hpp"
#include "stetro_dds/parameter_files.hpp"
#include "stetro_dds/ros_arguments.hpp"

namespace stetro_dds
{

/// What `run_main` tells about a program, and the options it has beside the ROS 2 ones.
struct Program
{
  std::string name;
  std::string summary;
  std::function<void(CLI::App &)> options{};
};

/// A node's configuration: how it lives in the graph, and its own parameters.
template <class Params>
struct Configured
{
  NodeOptions options;
  Params params;
};

/// The command line and the parameter files, on their way into nodes.
/**
 *   int main(int argc, char ** argv)
 *   {
 *     return run_main(argc, argv, {"stetro_driver", "Sensors and actuators."}, [](Launch & launch) {
 *       const auto driver = launch.configure<DriverParams>("driver", "/stetro");
 *       Context context(launch.context_options());  // throws here if anything was wrong
 *       DriverNode node(context, driver.options, driver.params);
 *       Executor executor;
 *       executor.add(node.node());
 *       launch.spin(executor);
 *       return 0;
 *     });
 *   }
 */
class Launch
{
public:
  explicit Launch(RosArguments arguments);

  /// Reads one node's parameters; faults wait for `check()`, so that every node's are reported.
  template <class Params>
  Configured<Params> configure(
    const std::string & name, const std::string & ns = "/", Params defaults = {})
  {
    NodeOptions options = node_options(name, ns);
    stetro_config::Loader<AllParams<Params>> loader({std::move(defaults), {}});
    const auto full_name = NodeName{options.ns, options.name}.full();
    files_.each_section(
      full_name, faults_,
      [&loader](const YAML::Node & map, const std::string & file) { loader.read_map(map, file); });
    each_override(options, name, [&loader](const std::string & key, const std::string & value) {
      loader.set(key, value, "command line");
    });
    AllParams<Params> all = loader.finish(faults_);
    adopt(all.common, options);
    return {std::move(options), std::move(all.own)};
  }

  /// Faults found outside parameters, a site file's for instance, can join the others here.
  [[nodiscard]] stetro_config::Faults & faults() { return faults_; }

  /// Once every node is configured: is everything that was written right?
  /**
   * Its first call logs a warning for each section of a parameter file that none of the nodes
   * reads: it is meant for another program, or its name is misspelt.
   *
   * \throws stetro_config::ConfigError with every fault of every node
   */
  void check() const;

  /// Domain, network scope and distro for the process. \throws as `check()`
  [[nodiscard]] ContextOptions context_options() const;

  /// Spins until `stop()`, or a signal.
  void spin(Executor & executor);

  /// Ends `spin`; from any thread. A program with a loop of its own asks `stop_requested()`.
  void stop();
  [[nodiscard]] bool stop_requested() const { return stop_requested_; }

private:
  [[nodiscard]] NodeOptions node_options(const std::string & name, const std::string & ns);
  void each_override(
    const NodeOptions & options, const std::string & default_name,
    const std::function<void(const std::string &, const std::string &)> & visit_override) const;
  void warn_of_strays() const;
  void adopt(const NodeParams & params, NodeOptions & options);

  RosArguments arguments_;
  stetro_config::Faults faults_;
  ParameterFiles files_;
  std::set<std::string> names_;  ///< of the nodes configured, every way they may be called
  std::vector<std::string> full_names_;
  mutable std::once_flag strays_told_;
  std::optional<NodeParams> common_;  ///< of the first node; the others must agree
  std::mutex mutex_;
  Executor * spinning_ = nullptr;
  std::atomic<bool> stop_requested_{false};
};

/// The whole of `main`: command line, logging, signals, and errors as exit codes.
/**
 * \return what `body` returned; 0 after --help; 2 with every fault on stderr if the configuration
 *   or command line is wrong; 1 for any other exception
 */
int run_main(
  int argc, const char * const * argv, const Program & program,
  const std::function<int(Launch &)> & body);

}  // namespace stetro_dds

#endif  // STETRO_DDS__LAUNCH_HPP_
