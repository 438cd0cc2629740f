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

#ifndef STETRO_CONFIG__LOADER_HPP_
#define STETRO_CONFIG__LOADER_HPP_

#include <yaml-cpp/yaml.h>

#include <string>
#include <type_traits>
#include <utility>

#include "stetro_config/fault.hpp"
#include "stetro_config/field.hpp"
#include "stetro_config/field_loader.hpp"

namespace stetro_config
{

namespace detail
{
template <class Params, class = void>
struct HasCheck : std::false_type
{
};
template <class Params>
struct HasCheck<
  Params, std::void_t<decltype(check(std::declval<const Params &>(), std::declval<Faults &>()))>>
: std::true_type
{
};
}  // namespace detail

/// Loads a struct of parameters: its defaults, then files, then the command line; the last wins.
/**
 *   Loader<LocalizerParams> loader;
 *   loader.read_file("localizer.yaml");
 *   loader.set("gate.sigma", "4.0", "command line");
 *   const LocalizerParams params = loader.finish();  // or a ConfigError with every fault
 *
 * Nothing throws before `finish`. An unknown name, a wrong type, a value its rule refuses, a name
 * written twice in one file and, from the hook `check(const Params &, Faults &)`, numbers that
 * contradict each other are faults with file and line. The hook runs only when every single value
 * is sound, so it need not doubt them; it refuses by name and the loader adds the place.
 */
template <class Params>
class Loader
{
public:
  explicit Loader(Params defaults = {}) : params_(std::move(defaults)), loader_(fields_of(params_))
  {
  }
  Loader(const Loader &) = delete;  // fields point into params_
  Loader & operator=(const Loader &) = delete;

  /// Reads the file's root map.
  void read_file(const std::string & path) { loader_.read_file(path); }

  /// Reads a map that `file` names in faults: a part of a larger file, such as `ros__parameters`.
  void read_map(const YAML::Node & map, const std::string & file) { loader_.read_map(map, file); }

  /// Sets one name from YAML text, as `-p name:=text` does.
  void set(const std::string & name, const std::string & text, const std::string & source)
  {
    loader_.set(name, text, source);
  }

  /// Leaves what stands under a name for another reader. To be called before reading.
  void leave_out(const std::string & name) { loader_.leave_out(name); }
  /// What stands under a name that was left out; null if nothing does.
  [[nodiscard]] YAML::Node left_out(const std::string & name) const
  {
    return loader_.left_out(name);
  }

  /// Makes a name that nobody wrote a fault in `file`, where a default would be a guess.
  void require_every_name(const std::string & file) { loader_.require_every_name(file); }

  /// The parameters and, in `into`, every fault. With faults the parameters are not to be used.
  [[nodiscard]] Params finish(Faults & into)
  {
    loader_.check_values();
    if constexpr (detail::HasCheck<Params>::value) {
      if (loader_.faults().empty()) {
        Faults found;
        check(std::as_const(params_), found);
        loader_.add_located(found);
      }
    }
    for (const Fault & fault : loader_.faults()) {
      into.add(fault);
    }
    return params_;
  }

  /// \throws ConfigError with every fault, if there is any
  [[nodiscard]] Params finish()
  {
    Faults faults;
    Params params = finish(faults);
    faults.throw_if_any();
    return params;
  }

  /// Where the value in force was written; file "default" if nobody wrote it.
  [[nodiscard]] Origin origin(const std::string & name) const { return loader_.origin(name); }

private:
  Params params_;
  FieldLoader loader_;
};

/// Loads one file over the defaults. \throws ConfigError with every fault
template <class Params>
[[nodiscard]] Params load_file(const std::string & path)
{
  Loader<Params> loader;
  loader.read_file(path);
  return loader.finish();
}

}  // namespace stetro_config

#endif  // STETRO_CONFIG__LOADER_HPP_
