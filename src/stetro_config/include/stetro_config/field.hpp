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

#ifndef STETRO_CONFIG__FIELD_HPP_
#define STETRO_CONFIG__FIELD_HPP_

#include <functional>
#include <string>
#include <utility>
#include <vector>

#include "stetro_config/rule.hpp"
#include "stetro_config/value.hpp"

/// \file
/// Parameters, declared once.
/**
 * A struct of parameters carries its defaults. Beside it, in its namespace, stands one list:
 *
 *   template <class Visitor>
 *   void visit(LocalizerParams & p, Visitor && each)
 *   {
 *     each("tof.sigma_m", p.tof_sigma_m, Within{1e-4, 0.1}, "beam noise at zero range [m]");
 *     each("gate.sigma", p.gate_sigma, Within{1.0, 10.0}, "innovation gate [standard deviations]");
 *   }
 *
 * and, where numbers can contradict each other, `void check(const LocalizerParams &, Faults &)`.
 * Loading (`loader.hpp`), printing and the reference table (`report.hpp`) follow from the list.
 */

namespace stetro_config
{

/// One declared parameter, bound to the struct it lives in and valid as long as that struct.
struct Field
{
  std::string name;                            ///< dotted: nested maps in YAML
  Kind kind;                                   ///< the type it has and must be written as
  std::string limits;                          ///< the rule in words, empty if any value will do
  std::string accepted;                        ///< kind and rule in words, for a fault
  std::string meaning;                         ///< one line with the unit in brackets
  std::function<Value()> get;                  ///< the value in force
  std::function<bool(const Value &)> accepts;  ///< right kind, finite and inside the rule
  std::function<bool(const Value &)> assign;   ///< false, and nothing changed, if not accepted
};

/// The visitor that turns a `visit` list into fields.
class FieldCollector
{
public:
  /// \throws std::logic_error if the name is declared twice or is also a group of names
  template <class T, class Rule>
  void operator()(const std::string & name, T & target, const Rule & rule, std::string meaning)
  {
    constexpr Kind kKind = kind_of<T>();
    auto accepts = [rule](const Value & value) {
      const T * typed = std::get_if<T>(&value);
      return typed && is_finite(value) && rule.accepts(*typed);
    };
    auto assign = [accepts, &target](const Value & value) {
      const bool accepted = accepts(value);
      if (accepted) {
        target = std::get<T>(value);
      }
      return accepted;
    };
    add(
      {name, kKind, rule.words(), accepted_words(kKind, rule), std::move(meaning),
       [&target] { return Value{target}; }, accepts, assign});
  }

  [[nodiscard]] std::vector<Field> take() { return std::move(fields_); }

private:
  void add(Field field);

  std::vector<Field> fields_;
};

/// Puts a group's name in front: `visit(p.tof, Group{"tof", each})` declares `tof.sigma_m`.
template <class Visitor>
class Group
{
public:
  Group(std::string name, Visitor & each) : name_(std::move(name)), each_(each) {}

  template <class T, class Rule>
  void operator()(const std::string & name, T & target, const Rule & rule, std::string meaning)
  {
    each_(name_ + "." + name, target, rule, std::move(meaning));
  }

private:
  std::string name_;
  Visitor & each_;
};

/// The fields of a struct in the order of its list.
template <class Params>
[[nodiscard]] std::vector<Field> fields_of(Params & params)
{
  FieldCollector collector;
  visit(params, collector);  // found in the namespace of Params
  return collector.take();
}

}  // namespace stetro_config

#endif  // STETRO_CONFIG__FIELD_HPP_
