// SPDX-License-Identifier: MIT
#include "cageproof/judge/templates.h"

#include "cageproof/core/coordinates/coordinates.h"
#include "cageproof/core/input_error.h"
#include "cageproof/judge/sides.h"
#include "cageproof/judge/whole_cage.h"
#include "templates/embedded.h"

#include <fmt/format.h>

namespace cageproof::judge {
namespace {

constexpr std::string_view kExample = "segment.winding_angle", kTextbook = "triangle.solid_angle",
                           kExampleKind = "mean_value";

using Words = std::vector<std::pair<std::string_view, std::string>>;

// The text with each {{WORD}} replaced.
std::string filled(std::string_view text, const Words& words) {
  std::string all(text);
  for (const auto& [word, by] : words) {
    const std::string mark = fmt::format("{{{{{}}}}}", word);
    for (std::size_t at = 0; (at = all.find(mark, at)) != std::string::npos; at += by.size())
      all.replace(at, mark.size(), by);
  }
  return all;
}

// How the numbers of a value lie.
std::string layout_of(const Formula& formula) {
  std::string text = fmt::format("{} number{}", formula.components(), formula.components() == 1 ? "" : "s");
  if (formula.shape.per_corner) text += ", corner after corner";
  if (formula.shape.entries() > 1) text += ", matrices row after row";
  return text;
}

std::string parameters_of_c(const Formula& formula) {
  std::string text;
  for (std::size_t k = 0; k < formula.parameters.size(); ++k)
    text += fmt::format(" parameters[{}] is {}.", k, formula.parameters[k].name);
  return text;
}

Words words_of(const Formula& formula, std::string body) {
  const bool is_complete = formula.name == kTextbook;
  return {{"BODY", std::move(body)},
          {"FORMULA", std::string(formula.name)},
          {"DEFINITION", std::string(formula.definition)},
          {"STATE", is_complete ? "Replace the formula by yours. As it stands, `judge` finds `wrong_values`, on edges: "
                                  "rounding decides there."
                                : "It declines all inputs until `value_at` has your formula; `judge` has nothing to "
                                  "say until then."},
          {"DIM", fmt::format("{}", formula.dim())},
          {"COMPONENTS", fmt::format("{}", formula.components())}};
}

std::string c_text(const Formula& formula, std::string_view build) {
  std::string body(embedded_solid_angle_c_in);
  if (formula.name != kTextbook)
    body = fmt::format(
        "/* Yours: sets {}. corners has {} times {} numbers, point {}.{}\n * Returns 0 for an input that it declines, "
        "as "
        "this one does all until your formula is here. */\nstatic int value_at(const double* corners, const double* "
        "parameters, const double* point, double* value) {{\n  (void)corners, (void)parameters, (void)point, "
        "(void)value;\n  return 0;\n}}\n\n",
        layout_of(formula), formula.corners(), formula.dim(), formula.dim(), parameters_of_c(formula));
  Words words = words_of(formula, std::move(body));
  words.emplace_back("BUILD", build);
  return filled(embedded_formula_c_in, words);
}

std::string python_text(const Formula& formula) {
  std::string body(embedded_solid_angle_py_in);
  if (formula.name != kTextbook)
    body = fmt::format(
        "\ndef value_at(corners, parameters, point):\n    \"\"\"Yours: returns {}, in one list. corners are {} points "
        "of "
        "{} floats, parameters a dict.\n\n    Returns None for an input that it declines, as this one does all until "
        "your formula is here.\"\"\"\n    return None\n\n\n",
        layout_of(formula), formula.corners(), formula.dim());
  return filled(embedded_formula_py_in, words_of(formula, std::move(body)));
}

std::string cage_text(std::string_view kind) {
  if (kind == kExampleKind) return std::string(embedded_mine_cage_py);
  std::string definition = "sides of a cage", layout = "1 inside, 0 on the cage, -1 outside";
  if (kind != kSides) {
    require_judged_kind(kind);
    const CoordinateKind& row = coordinate_kind_named(kind);
    definition = row.source;
    layout = "the coordinates in one list";
    for (const SummedBlock& block : row.blocks) layout += fmt::format(", those of block {}", block.label);
  }
  return filled(embedded_cage_py_in, {{"KIND", std::string(kind)},
                                      {"DEFINITION", definition},
                                      {"STATE",
                                       "It declines all points until `coordinates` has your function; `judge` "
                                       "has nothing to say until then."},
                                      {"LAYOUT", layout}});
}

}  // namespace

const std::vector<std::string_view>& template_languages() {
  static const std::vector<std::string_view> all{"c", "cpp", "python", "python-cage"};
  return all;
}

std::vector<std::pair<std::string_view, std::string>> template_files(std::string_view language,
                                                                     std::string_view subject) {
  const bool is_cage = language == "python-cage";
  if (is_cage) return {{"mine_cage.py", cage_text(subject.empty() ? kExampleKind : subject)}};
  const bool is_example = subject.empty() || subject == kExample;
  if (!is_example && find_formula(subject) == nullptr &&
      (subject == kSides || find_coordinate_kind(subject) != nullptr))
    throw InputError(fmt::format("{} is of whole cages, whose example is --template python-cage", subject));
  const Formula* const formula = is_example ? nullptr : &formula_named(subject);
  if (language == "python") return {{"mine.py", is_example ? std::string(embedded_mine_py) : python_text(*formula)}};
  const std::pair<std::string_view, std::string> header{"cageproof_judge.h", embedded_cageproof_judge_h};
  if (language == "c")
    return {header,
            {"mine.c", is_example ? std::string(embedded_mine_c)
                                  : c_text(*formula, "cc -O2 -shared -fPIC -I. mine.c -o libmine.so -lm")}};
  return {header,
          {"mine.cpp", is_example ? std::string(embedded_mine_cpp)
                                  : c_text(*formula, "c++ -O2 -std=c++17 -shared -fPIC -I. mine.cpp -o libmine.so")}};
}

}  // namespace cageproof::judge
