// SPDX-License-Identifier: MIT
#include "cageproof/judge/vectors.h"
#include "vectors/texts.h"

#include <fmt/ranges.h>

#include <limits>

namespace cageproof::judge {
namespace {

constexpr std::array<std::string_view, 3> tensor_keys{"value", "gradient", "hessian"};

std::string vector_json(const TestVector& v, const Formula& formula) {
  std::string text = "{\"element\":[";
  for (std::size_t k = 0; k < v.sample.corners.size(); ++k)
    text += (k ? "," : "") + point_json(v.sample.corners[k], formula.dim());
  text += "],\"point\":" + point_json(v.sample.point, formula.dim()) + ",\"parameters\":[";
  for (std::size_t k = 0; k < v.sample.parameters.size(); ++k)
    text += fmt::format("{}\"{}\"", k ? "," : "", format_hex(v.sample.parameters[k]));
  text += fmt::format("],\"regime\":\"{}\",\"defects\":[\"{}\"]", v.regime, fmt::join(v.defects, "\",\""));
  for (int o = 0; o < 3; ++o)
    if (v.has[o])
      text += fmt::format(",\"{0}\":{1},\"{0}_denominator\":\"{2}\"", tensor_keys[o],
                          decimals(v.truth.tensors.of(o), 40), format_digits(v.truth.conditioned[o], 20));
  if (!v.radius.empty()) text += ",\"value_radius\":" + decimals(v.radius, 3);
  return text + "}";
}

void add_inputs(const TestVector& v, const Formula& formula, std::vector<double>& to) {
  for (const auto& corner : v.sample.corners) to.insert(to.end(), corner.data(), corner.data() + formula.dim());
  to.insert(to.end(), v.sample.point.data(), v.sample.point.data() + formula.dim());
  to.insert(to.end(), v.sample.parameters.begin(), v.sample.parameters.end());
}

}  // namespace

std::string vectors_json(const VectorSet& set, const VectorOptions& options, std::string_view version,
                         std::string_view command) {
  const Formula& formula = *set.formula;
  std::vector<std::string> names;
  names.reserve(formula.parameters.size());
  for (const auto& parameter : formula.parameters) names.push_back(json_text(parameter.name));
  std::string text = fmt::format(
      "{{\"format\":\"cageproof vectors 1\",\"version\":{},\"command\":{},\"formula\":\"{}\",\"definition\":{},"
      "\"parameters\":[{}],\"seed\":{},\"unit\":\"{}\",\"bound\":{},\"candidates\":{},\"without_defect\":{},\n"
      "\"defects\":{{",
      json_text(version), json_text(command), formula.name, json_text(formula.definition), fmt::join(names, ","),
      options.seed, format_hex(unit_roundoff<double>()), vector_bound, set.candidates, set.without_defect);
  const char* comma = "";
  for (const KnownDefect& defect : known_defects()) {
    text += fmt::format("{}\"{}\":{}", comma, defect.name, json_text(defect.description));
    comma = ",";
  }
  text += "},\n\"vectors\":[";
  comma = "\n";
  for (const TestVector& v : set.vectors) {
    text += comma + vector_json(v, formula);
    comma = ",\n";
  }
  return text + "\n]}\n";
}

std::string vectors_text(const VectorSet& set) {
  const Formula& formula = *set.formula;
  std::string text =
      fmt::format("{} {} {} {}\n", formula.name, set.vectors.size(),
                  static_cast<std::size_t>(formula.dim()) * (formula.corners() + 1) + formula.parameters.size(),
                  formula.components());
  for (const TestVector& v : set.vectors) {
    text += fmt::format("{}", fmt::join(v.defects, ","));
    std::vector<double> inputs;
    add_inputs(v, formula, inputs);
    for (const double x : inputs) text += ' ' + format_hex(x);
    for (const Mp100& x : v.truth.tensors.value)
      for (const double part : split(x)) text += ' ' + format_hex(part);
    text += ' ' + format_hex(static_cast<double>(v.truth.conditioned[0])) + '\n';
  }
  return text;
}

VectorTables vectors_tables(const VectorSet& set) {
  const Formula& formula = *set.formula;
  VectorTables tables;
  tables.input_columns = static_cast<std::size_t>(formula.dim()) * (formula.corners() + 1) + formula.parameters.size();
  constexpr double missing = std::numeric_limits<double>::quiet_NaN();
  for (int o = 0; o < 3; ++o) tables.truth_columns += formula.components() * derivative_count(formula.dim(), o);
  for (const TestVector& v : set.vectors) {
    add_inputs(v, formula, tables.inputs);
    for (int o = 0; o < 3; ++o) {
      const std::size_t count = formula.components() * derivative_count(formula.dim(), o);
      for (std::size_t i = 0; i < count; ++i) {
        const auto parts = v.has[o] ? split(v.truth.tensors.of(o)[i]) : std::array{missing, missing};
        tables.truths.insert(tables.truths.end(), parts.begin(), parts.end());
      }
      tables.denominators.push_back(v.has[o] ? static_cast<double>(v.truth.conditioned[o]) : missing);
    }
  }
  return tables;
}

}  // namespace cageproof::judge
