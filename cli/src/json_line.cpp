// SPDX-License-Identifier: MIT
#include "json_line.h"

#include "cageproof/core/input_error.h"
#include "cageproof/core/numbers/scalar_text.h"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>
#include <tuple>

namespace cageproof::cli {
namespace {

using Json = nlohmann::json;

// Builds a document in which every number is the string it was written as: JSON's doubles would cost mp200 its digits.
class NumbersAsText {
 public:
  bool null() { return put(nullptr); }
  bool boolean(bool value) { return put(value); }
  bool number_integer(Json::number_integer_t value) { return put(fmt::format("{}", value)); }
  bool number_unsigned(Json::number_unsigned_t value) { return put(fmt::format("{}", value)); }
  bool number_float(Json::number_float_t, const std::string& text) { return put(text); }
  bool string(std::string& value) { return put(std::move(value)); }
  bool binary(Json::binary_t&) { return false; }
  bool start_object(std::size_t) { return open(Json::object()); }
  bool start_array(std::size_t) { return open(Json::array()); }
  bool end_object() { return close(); }
  bool end_array() { return close(); }
  bool key(std::string& name) {
    if (open_.back()->contains(name)) {
      error = fmt::format("the key \"{}\" occurs twice", name);
      return false;
    }
    // Its place is taken at once: the value may hold keys of its own.
    (*open_.back())[name] = nullptr;
    key_ = name;
    return true;
  }
  bool parse_error(std::size_t column, const std::string& token, const nlohmann::detail::exception& reason) {
    constexpr int number_overflow = 406;  // nlohmann's number of that error
    error = reason.id == number_overflow ? fmt::format("the number {} at column {} is too large", token, column)
                                         : fmt::format("malformed JSON at column {}", column);
    return false;
  }

  Json root;
  std::string error;

 private:
  Json* add(Json value) {
    if (open_.empty()) {
      root = std::move(value);
      return &root;
    }
    if (open_.back()->is_object()) return &((*open_.back())[key_] = std::move(value));
    open_.back()->push_back(std::move(value));
    return &open_.back()->back();
  }
  bool put(Json value) {
    add(std::move(value));
    return true;
  }
  bool open(Json value) {
    open_.push_back(add(std::move(value)));
    return true;
  }
  bool close() {
    open_.pop_back();
    return true;
  }

  std::vector<Json*> open_;
  std::string key_;
};

std::string form_of_point(int dimension) { return dimension == 2 ? "[x,y]" : "[x,y,z]"; }

std::string form_of_element(const Formula& formula) { return fmt::format("[{},...]", form_of_point(formula.dim())); }

std::string form_of_query(const Formula& formula) {
  return fmt::format("{{\"element\":{},\"point\":{}}}", form_of_element(formula), form_of_point(formula.dim()));
}

std::string number(const Json& value, const std::string& where, bool may_be_infinite = false) {
  if (!value.is_string()) throw InputError(fmt::format("{} is not a number", where));
  const auto& text = value.get_ref<const std::string&>();
  const auto parsed = parse_scalar<Mp200>(text);
  if (!parsed) throw InputError(fmt::format("{}: '{}' is not a number", where, text));
  if (!isfinite(*parsed) && (!may_be_infinite || isnan(*parsed)))
    throw InputError(fmt::format("{} is not finite", where));
  return text;
}

std::array<std::string, 3> point(const Json& value, int dimension, const std::string& where) {
  if (!value.is_array() || static_cast<int>(value.size()) != dimension)
    throw InputError(fmt::format("{} must be {} numbers, {}", where, dimension, form_of_point(dimension)));
  std::array<std::string, 3> p{"0", "0", "0"};
  for (int c = 0; c < dimension; ++c) p[c] = number(value[c], fmt::format("{}[{}]", where, c));
  return p;
}

std::string parameter(const Json& given, const Parameter& p) {
  std::string text = given.contains(p.name)
                         ? number(given[std::string(p.name)], std::string(p.name), p.includes_infinity)
                         : format_scalar(p.preset);
  const double x = *parse_scalar<double>(text);
  if (std::isinf(x) && !text.ends_with("inf"))
    throw InputError(fmt::format("parameter {} = {} is beyond the range of a double", p.name, text));
  if (p.allows(x)) return text;
  if (p.whole)
    throw InputError(fmt::format("parameter {} = {} is no whole number between {} and {}", p.name, text, p.lowest + 1,
                                 p.highest - 1));
  throw InputError(fmt::format("parameter {} = {} is outside ({}, {}{}{}", p.name, text, p.lowest, p.highest,
                               p.includes_highest ? "]" : ")", p.includes_infinity ? " and not infinite" : ""));
}

Json object_of(const std::string& line, const std::string& form) {
  NumbersAsText reader;
  if (!Json::sax_parse(line, &reader)) throw InputError(fmt::format("{}; expected {}", reader.error, form));
  if (!reader.root.is_object()) throw InputError(fmt::format("not a JSON object; expected {}", form));
  return std::move(reader.root);
}

// A member that is text, taken out; empty where it is not there.
std::string text_member(Json& json, const char* key) {
  const auto found = json.find(key);
  if (found == json.end()) return {};
  if (!found->is_string()) throw InputError(fmt::format("\"{}\" is no text", key));
  std::string text = found->get<std::string>();
  json.erase(found);
  return text;
}

// Numbers are texts here.
std::optional<int> order_member(Json& json) {
  const auto found = json.find("order");
  if (found == json.end()) return std::nullopt;
  const std::string text = found->is_string() ? found->get<std::string>() : "";
  if (text != "0" && text != "1" && text != "2") throw InputError("\"order\" must be 0, 1 or 2");
  json.erase(found);
  return text[0] - '0';
}

QueryText query_of(const Json& json, const Formula& formula) {
  for (const auto& [key, value] : json.items())
    if (key != "element" && key != "point" && key != "parameters")
      throw InputError(fmt::format("unknown key \"{}\"; known: element, point, parameters", key));
  for (const char* key : {"element", "point"})
    if (!json.contains(key))
      throw InputError(fmt::format("missing key \"{}\"; expected {}", key, form_of_query(formula)));
  const Json& element = json["element"];
  if (!element.is_array() || static_cast<int>(element.size()) != formula.corners())
    throw InputError(fmt::format("element must be {} corners of a {}, {}", formula.corners(), name_of(formula.element),
                                 form_of_element(formula)));
  QueryText query;
  for (int k = 0; k < formula.corners(); ++k)
    query.corners.push_back(point(element[k], formula.dim(), fmt::format("element[{}]", k)));
  query.point = point(json["point"], formula.dim(), "point");
  const Json given = json.value("parameters", Json::object());
  if (!given.is_object()) throw InputError("parameters must be an object, {\"NAME\":VALUE,...}");
  for (const auto& [key, value] : given.items())
    if (std::ranges::find(formula.parameters, key, &Parameter::name) == formula.parameters.end())
      throw InputError(fmt::format("{} has no parameter \"{}\"", formula.name, key));
  for (const Parameter& p : formula.parameters) query.parameters.push_back(parameter(given, p));
  return query;
}

}  // namespace

QueryText parse_members(const std::string& element, const std::string& point, const Formula& formula) {
  // Each text is parsed by itself, so that an error names its option, and neither text can close their common object.
  for (const auto& [option, text, form] :
       {std::tuple("--element", &element, form_of_element(formula)), {"--point", &point, form_of_point(formula.dim())}})
    if (!Json::accept(*text)) throw InputError(fmt::format("{} {}: malformed JSON; expected {}", option, *text, form));
  return parse_query(fmt::format("{{\"element\":{},\"point\":{}}}", element, point), formula);
}

bool asks_for_description(const std::string& line) {
  constexpr const char* key = "describe";
  return line.find(key) != std::string::npos && Json::parse(line, nullptr, false) == Json{{key, true}};
}

QueryText parse_query(const std::string& line, const Formula& formula) {
  return query_of(object_of(line, form_of_query(formula)), formula);
}

QueryText parse_query(const std::string& line, const std::function<const Formula&(const LineOptions&)>& formula_for) {
  Json json = object_of(line, "{\"formula\":NAME,\"element\":[...],\"point\":[...]}");
  const LineOptions options{text_member(json, "formula"), text_member(json, "scalar"), order_member(json)};
  const Formula& formula = formula_for(options);
  return query_of(json, formula);
}

std::string error_line(const std::string& message, std::size_t line) {
  return nlohmann::ordered_json{{"error", message}, {"line", line}}.dump(-1, ' ', false,
                                                                         Json::error_handler_t::replace);
}

}  // namespace cageproof::cli
