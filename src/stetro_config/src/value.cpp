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

#include "stetro_config/value.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <string_view>
#include <system_error>

namespace stetro_config
{
namespace
{

using std::string_view;

// yaml-cpp marks a plain scalar "?" and a quoted one "!"; anything else was tagged by hand.
constexpr char kPlainTag[] = "?";
constexpr char kQuotedTag[] = "!";
constexpr char kStringTag[] = "tag:yaml.org,2002:str";

bool is_plain(const YAML::Node & node) { return node.IsScalar() && node.Tag() == kPlainTag; }

std::optional<bool> bool_of(string_view text)
{
  if (text == "true" || text == "True" || text == "TRUE") {
    return true;
  }
  if (text == "false" || text == "False" || text == "FALSE") {
    return false;
  }
  return std::nullopt;
}

bool is_digit(char c) { return c >= '0' && c <= '9'; }

/// Without a leading '+', which from_chars does not know.
string_view unsigned_plus(string_view text)
{
  return text.size() > 1 && text[0] == '+' && text[1] != '-' ? text.substr(1) : text;
}

/// 010 is eight to one reader and ten to another: nobody may write it.
bool has_leading_zero(string_view text)
{
  const string_view digits = !text.empty() && text[0] == '-' ? text.substr(1) : text;
  return digits.size() > 1 && digits[0] == '0' && is_digit(digits[1]);
}

template <class Number>
std::optional<Number> number_of(string_view text, string_view alphabet)
{
  text = unsigned_plus(text);
  if (
    text.empty() || has_leading_zero(text) ||
    text.find_first_not_of(alphabet) != string_view::npos) {
    return std::nullopt;
  }
  Number number{};
  const char * const end = text.data() + text.size();
  const auto [stop, error] = std::from_chars(text.data(), end, number);
  if (error != std::errc{} || stop != end) {
    return std::nullopt;
  }
  return number;
}

std::optional<std::int64_t> int_of(string_view text)
{
  return number_of<std::int64_t>(text, "-0123456789");
}

bool is_exact(std::int64_t whole)
{
  // 2^63 itself is a double that no int64 equals, so test the range before casting back.
  const auto rounded = static_cast<double>(whole);
  return rounded < 0x1p63 && static_cast<std::int64_t>(rounded) == whole;
}

std::optional<double> double_of(string_view text)
{
  const bool whole = text.find_first_of(".eE") == string_view::npos;
  if (whole) {
    const auto integer = int_of(text);
    return integer && is_exact(*integer) ? std::optional{static_cast<double>(*integer)}
                                         : std::nullopt;
  }
  return number_of<double>(text, "-+.eE0123456789");
}

/// Plain text that another YAML reader would take for something else than text.
bool is_ambiguous(string_view text)
{
  if (bool_of(text)) {
    return true;
  }
  std::string bare{text.substr(std::min(text.find_first_not_of("+-"), text.size()))};
  if (bare == ".nan" || bare == ".NaN" || bare == ".NAN" || bare == ".inf" || bare == ".Inf") {
    return true;
  }
  if (
    bare.size() > 1 && bare[0] == '0' && (is_digit(bare[1]) || bare[1] == 'x' || bare[1] == 'o')) {
    return bare.find_first_not_of("0123456789abcdefABCDEFxo_.") == std::string::npos;
  }
  bare.erase(std::remove(bare.begin(), bare.end(), '_'), bare.end());  // 1_000 was a number once
  double number = 0.0;
  const char * const end = bare.data() + bare.size();
  const bool number_first = !bare.empty() && (is_digit(bare[0]) || bare[0] == '.');
  return number_first && std::from_chars(bare.data(), end, number).ptr == end;
}

std::optional<std::string> string_of(const YAML::Node & node)
{
  if (!node.IsScalar()) {
    return std::nullopt;
  }
  if (node.Tag() == kQuotedTag || node.Tag() == kStringTag) {
    return node.Scalar();
  }
  if (node.Tag() != kPlainTag || is_ambiguous(node.Scalar())) {
    return std::nullopt;
  }
  return node.Scalar();
}

template <class Element>
std::optional<Value> list_of(const YAML::Node & node, Kind element_kind)
{
  if (!node.IsSequence()) {
    return std::nullopt;
  }
  std::vector<Element> list;
  list.reserve(node.size());
  for (const YAML::Node & item : node) {
    auto element = parse(item, element_kind);
    if (!element) {
      return std::nullopt;
    }
    list.push_back(std::get<Element>(std::move(*element)));
  }
  return Value{std::move(list)};
}

template <class T>
std::optional<Value> wrapped(std::optional<T> value)
{
  return value ? std::optional<Value>{Value{std::move(*value)}} : std::nullopt;
}

std::string quoted(const std::string & text)
{
  YAML::Emitter out;
  out << YAML::DoubleQuoted << text;
  return out.c_str();
}

/// A double as YAML: with a point or an exponent, so that no reader takes it for an integer.
std::string yaml_double(double number)
{
  std::string text = to_text(number);
  return text.find_first_of(".en") == std::string::npos ? text + ".0" : text;
}

template <class List, class Element>
std::string flow_list(const List & list, Element element)
{
  std::string text = "[";
  for (const auto & item : list) {
    text += (text.size() > 1 ? ", " : "") + element(item);
  }
  return text + "]";
}

struct YamlText
{
  std::string operator()(bool value) const { return value ? "true" : "false"; }
  std::string operator()(std::int64_t value) const { return std::to_string(value); }
  std::string operator()(double value) const { return yaml_double(value); }
  std::string operator()(const std::string & value) const { return quoted(value); }
  std::string operator()(const std::vector<double> & list) const
  {
    return flow_list(list, yaml_double);
  }
  std::string operator()(const std::vector<std::string> & list) const
  {
    return flow_list(list, quoted);
  }
};

}  // namespace

std::string to_string(Kind kind)
{
  constexpr std::array<const char *, 6> kNames{
    "bool", "int", "double", "string", "list of doubles", "list of strings"};
  return kNames.at(static_cast<std::size_t>(kind));
}

std::string describe(Kind kind)
{
  constexpr std::array<const char *, 6> kWords{
    "true or false",
    "a whole number",
    "a finite number",
    "text (quoted if it looks like a number)",
    "a list of finite numbers",
    "a list of texts (quoted where they look like numbers)"};
  return kWords.at(static_cast<std::size_t>(kind));
}

std::optional<Value> parse(const YAML::Node & node, Kind kind)
{
  switch (kind) {
    case Kind::kString:
      return wrapped(string_of(node));
    case Kind::kDoubles:
      return list_of<double>(node, Kind::kDouble);
    case Kind::kStrings:
      return list_of<std::string>(node, Kind::kString);
    case Kind::kBool:
      return is_plain(node) ? wrapped(bool_of(node.Scalar())) : std::nullopt;
    case Kind::kInt:
      return is_plain(node) ? wrapped(int_of(node.Scalar())) : std::nullopt;
    case Kind::kDouble:
      return is_plain(node) ? wrapped(double_of(node.Scalar())) : std::nullopt;
  }
  return std::nullopt;
}

std::string excerpt(const YAML::Node & node)
{
  constexpr std::size_t kLongest = 60;
  if (node.IsMap()) {
    return "a map";
  }
  if (node.IsSequence()) {
    std::string text = "[";
    for (const YAML::Node & item : node) {
      text += (text.size() > 1 ? ", " : "") + (item.IsScalar() ? item.Scalar() : "...");
      if (text.size() > kLongest) {
        return text.substr(0, kLongest) + "...";
      }
    }
    return text + "]";
  }
  if (!node.IsScalar()) {
    return "null";
  }
  const std::string & text = node.Scalar();
  return text.size() > kLongest ? text.substr(0, kLongest) + "..." : text;
}

std::string to_yaml(const Value & value) { return std::visit(YamlText{}, value); }

std::string to_text(double number)
{
  std::array<char, 32> text{};
  const double size = std::abs(number);
  const bool everyday = number == 0.0 || (1e-4 <= size && size < 1e9);  // 0.0001, not 1e-04
  char * const end =
    everyday
      ? std::to_chars(text.data(), text.data() + text.size(), number, std::chars_format::fixed).ptr
      : std::to_chars(text.data(), text.data() + text.size(), number).ptr;
  return std::string(text.data(), end);
}

bool is_finite(const Value & value)
{
  if (const auto * number = std::get_if<double>(&value)) {
    return std::isfinite(*number);
  }
  if (const auto * list = std::get_if<std::vector<double>>(&value)) {
    return std::all_of(list->begin(), list->end(), [](double x) { return std::isfinite(x); });
  }
  return true;
}

}  // namespace stetro_config
