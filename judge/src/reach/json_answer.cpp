// SPDX-License-Identifier: MIT
#include "reach/json_answer.h"

#include "cageproof/core/numbers/scalar_text.h"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>
#include <functional>

namespace cageproof::judge {
namespace {

using Json = nlohmann::json;

constexpr std::array<const char*, 3> keys{"value", "gradient", "hessian"};

// JSON's -0 is an integer to many readers, and loses its sign.
void add_number(std::string& text, double x) {
  if (x == 0) text += std::signbit(x) ? "-0.0" : "0";
  else fmt::format_to(std::back_inserter(text), "{}", x);
}

using AddNumber = std::function<void(std::string&, double)>;

void add_point(std::string& text, const double* x, int dim, const AddNumber& add) {
  text += '[';
  for (int c = 0; c < dim; ++c) {
    if (c > 0) text += ',';
    add(text, x[c]);
  }
  text += ']';
}

// Element, point and parameters.
void add_members(std::string& text, const Formula& formula, const Asked& asked, std::size_t point,
                 const AddNumber& add) {
  const int dim = formula.dim();
  text += "\"element\":[";
  for (int k = 0; k < formula.corners(); ++k) {
    if (k > 0) text += ',';
    add_point(text, asked.corners.data() + static_cast<std::ptrdiff_t>(k) * dim, dim, add);
  }
  text += "],\"point\":";
  add_point(text, asked.points.data() + point * static_cast<std::size_t>(dim), dim, add);
  if (!formula.parameters.empty()) {
    text += ",\"parameters\":{";
    for (std::size_t k = 0; k < formula.parameters.size(); ++k) {
      fmt::format_to(std::back_inserter(text), "{}\"{}\":", k > 0 ? "," : "", formula.parameters[k].name);
      const double x = asked.parameters[k];
      if (std::isfinite(x)) add(text, x);
      else fmt::format_to(std::back_inserter(text), "\"{}\"", format_scalar(x));
    }
    text += '}';
  }
  text += '}';
}

void add_points(std::string& text, const std::vector<double>& numbers, std::size_t begin, std::size_t end,
                int dimension, const AddNumber& add) {
  text += '[';
  for (std::size_t i = begin; i < end; ++i) {
    if (i > begin) text += ',';
    add_point(text, numbers.data() + static_cast<std::size_t>(dimension) * i, dimension, add);
  }
  text += ']';
}

// Kind, cage, and the points from `begin` to `end`.
void add_cage(std::string& text, std::string_view kind, const Asked& asked, std::size_t begin, std::size_t end,
              const AddNumber& add) {
  fmt::format_to(std::back_inserter(text), "{{\"kind\":\"{}\",\"vertices\":", kind);
  const auto dimension = static_cast<std::size_t>(asked.dimension);
  add_points(text, asked.corners, 0, asked.corners.size() / dimension, asked.dimension, add);
  text += ",\"faces\":[";
  const auto corners = static_cast<std::size_t>(asked.face_corners);
  for (std::size_t f = 0; f + corners <= asked.faces.size(); f += corners)
    fmt::format_to(
        std::back_inserter(text), "{}[{}]", f > 0 ? "," : "",
        fmt::join(std::span(asked.faces).subspan(f, asked.faces[f + corners - 1] < 0 ? corners - 1 : corners), ","));
  text += "],\"points\":";
  add_points(text, asked.points, begin, end, asked.dimension, add);
  text += '}';
}

// Lists of lists are taken as they come, as deep as tensors are.
bool add_numbers(const Json& json, std::vector<double>& numbers, int depth = 0) {
  constexpr int deepest = 8;
  if (json.is_number()) {
    numbers.push_back(json.get<double>());
    return true;
  }
  if (json.is_string()) {
    const auto x = parse_scalar<double>(json.get_ref<const std::string&>());
    if (x) numbers.push_back(*x);
    return x.has_value();
  }
  return depth < deepest && json.is_array() &&
         std::ranges::all_of(json, [&](const Json& one) { return add_numbers(one, numbers, depth + 1); });
}

// Python and others write NaN, Infinity and -Infinity, which JSON does not have: as text they are numbers here.
std::string without_bare_words(std::string_view line) {
  std::string text;
  bool is_in_text = false;
  for (std::size_t i = 0; i < line.size(); ++i) {
    if (line[i] == '"' && (i == 0 || line[i - 1] != '\\')) is_in_text = !is_in_text;
    const std::string_view rest = is_in_text ? std::string_view() : line.substr(i);
    const auto replace = [&](std::string_view word, std::string_view by) {
      if (!rest.starts_with(word)) return false;
      text += by;
      i += word.size() - 1;
      return true;
    };
    if (!replace("NaN", "\"nan\"") && !replace("-Infinity", "\"-inf\"") && !replace("Infinity", "\"inf\""))
      text += line[i];
  }
  return text;
}

std::string shortened(std::string_view line) {
  constexpr std::size_t most = 80;
  std::string text(line.substr(0, most));
  for (char& c : text)
    if (static_cast<unsigned char>(c) < ' ' || static_cast<unsigned char>(c) > '~') c = '?';
  return line.size() > most ? text + "..." : text;
}

void add_hex(std::string& text, double x) { fmt::format_to(std::back_inserter(text), "\"{}\"", format_hex(x)); }

}  // namespace

void add_line(std::string& text, const Request& request, const Asked& asked, std::size_t point) {
  if (request.formula == nullptr) {
    add_cage(text, request.kind, asked, 0, asked.count, add_number);
    text += '\n';
    return;
  }
  fmt::format_to(std::back_inserter(text), "{{\"formula\":\"{}\",\"order\":{},", request.formula->name, request.order);
  if (request.single) text += "\"scalar\":\"float\",";
  add_members(text, *request.formula, asked, point, add_number);
  text += '\n';
}

std::string exact_line(const Formula& formula, const Asked& asked, std::size_t point) {
  std::string text = "{";
  add_members(text, formula, asked, point, add_hex);
  return text;
}

std::string exact_line(const Request& request, const Asked& asked, std::size_t point) {
  if (request.formula != nullptr) return exact_line(*request.formula, asked, point);
  std::string text;
  add_cage(text, request.kind, asked, point, point + 1, add_hex);
  return text;
}

LineAnswer parse_answer(std::string_view line, const Request& request, const Asked& asked) {
  LineAnswer answer;
  Json json = Json::parse(line, nullptr, false);
  if (json.is_discarded()) json = Json::parse(without_bare_words(line), nullptr, false);
  if (!json.is_object()) {
    answer.text = fmt::format("a line is no JSON object: {}", shortened(line));
    return answer;
  }
  if (const auto error = json.find("error"); error != json.end()) {
    answer.kind = LineAnswer::Kind::Error;
    answer.text = error->is_string() ? shortened(error->get_ref<const std::string&>()) : "error";
    return answer;
  }
  const Formula* const formula = request.formula;
  std::size_t size =
      formula != nullptr ? static_cast<std::size_t>(formula->components()) : asked.count * asked.coordinates;
  const std::size_t dimension = formula != nullptr ? static_cast<std::size_t>(formula->dim()) : 1;
  answer.kind = LineAnswer::Kind::Given;
  for (int o = 0; o <= request.order; ++o, size *= dimension) {
    const char* const key = formula != nullptr ? keys[o] : "coordinates";
    const auto member = json.find(key);
    std::vector<double>& numbers = answer.tensors[o];
    numbers.reserve(size);
    if (member == json.end()) {
      answer.kind = LineAnswer::Kind::Short;
      answer.text = fmt::format("a line has no \"{}\": {}", key, shortened(line));
      return answer;
    }
    if (!add_numbers(*member, numbers)) {
      answer.kind = LineAnswer::Kind::Garbage;
      answer.text = fmt::format("\"{}\" holds something that is no number: {}", key, shortened(line));
      return answer;
    }
    if (numbers.size() != size) {
      answer.kind = LineAnswer::Kind::Short;
      answer.text = fmt::format("\"{}\" has {} numbers instead of {}", key, numbers.size(), size);
      return answer;
    }
  }
  return answer;
}

Description parse_description(std::string_view line) {
  Description description;
  const Json json = Json::parse(line, nullptr, false);
  if (!json.is_object()) return description;
  if (const auto about = json.find("about"); about != json.end() && about->is_string())
    description.about = shortened(about->get_ref<const std::string&>());
  const auto formulas = json.find("formulas");
  if (formulas == json.end() || !formulas->is_object()) return description;
  description.orders.emplace();
  for (const auto& [name, order] : formulas->items())
    if (order.is_number_integer()) (*description.orders)[name] = std::clamp(order.get<int>(), -1, 2);
  if (const auto floats = json.find("float"); floats != json.end() && floats->is_boolean() && floats->get<bool>())
    for (const auto& [name, order] : std::map<std::string, int>(*description.orders))
      (*description.orders)[name + " float"] = order;
  return description;
}

}  // namespace cageproof::judge
