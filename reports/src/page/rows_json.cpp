// SPDX-License-Identifier: MIT
#include "rows_json.h"

#include "cageproof/core/catalogue/formula.h"
#include "cageproof/core/numbers/scalar_text.h"
#include "check_words.h"
#include "figure.h"
#include "page_data.h"
#include "row_members.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace cageproof::reports {
namespace {

// Quantiles of fewer samples would be another name for the largest or the middle one.
constexpr std::uint64_t kEnoughForQuantiles = 1000;

Json hex_of(const Vec3<double>& p, int dim) {
  Json json = Json::array();
  for (int c = 0; c < dim; ++c) json.push_back(format_hex(p[c]));
  return json;
}

Json worst_json(const ResultRow& row, const WorstCase& worst) {
  const Formula* formula = row.section == RowKey::Section::Element ? find_formula(row.subject) : nullptr;
  const int dim = formula ? formula->dim() : 3;
  Json json{{"error", short_error(worst.error)}, {"point", hex_of(worst.point, dim)}};
  if (!worst.corners.empty()) {
    json["element"] = Json::array();
    for (const Vec3<double>& corner : worst.corners) json["element"].push_back(hex_of(corner, dim));
    json["parameter"] = short_number(worst.parameter);
    json["order"] = worst.asked;
  }
  json["sample"] = worst.sample;
  for (std::size_t k = 0; formula && k < worst.parameters.size(); ++k)
    json["parameters"][std::string(formula->parameters[k].name)] = format_hex(worst.parameters[k]);
  if (worst.furthest.index < 0) return json;
  json["relative"] = short_error(worst.relative);
  json["digits"] = digits_kept(worst.relative, row.scalar);
  json["entry"] = entry_name(row, worst.furthest.index);
  json["found"] = row.scalar == "float" ? format_scalar(static_cast<float>(worst.furthest.found))
                                        : format_scalar(worst.furthest.found);
  json["truth"] = worst.furthest.truth;
  return json;
}

// The first member that others have not named is added.
std::size_t index_in(std::vector<std::string>& texts, const std::string& text) {
  const auto found = std::ranges::find(texts, text);
  if (found != texts.end()) return static_cast<std::size_t>(found - texts.begin());
  texts.push_back(text);
  return texts.size() - 1;
}

// Figures as they are read, the largest error as it is: scripts sort and draw by it.
Json page_value(const ResultRow& row, const RowMember& member) {
  const std::string_view name = member.name;
  if (name == "unit") return unit_text(row.unit);
  Json value = member_json(row, member);
  if (!value.is_number_float() || name == "max") return value;
  return name == "bound" ? short_number(value.get<double>()) : short_error(value.get<double>());
}

Json row_json(const ResultRow& row, const WorstPlace& place, std::vector<std::string>& reasons) {
  Json json{{"id", cell_id(row)}, {"css", cell_class(row)}, {"text", cell_text(row)}};
  for (const RowMember& member : row_members()) {
    const std::string_view name = member.name;
    if (name == "histogram") continue;
    if ((name == "p999" || name == "median") && row.samples < kEnoughForQuantiles) continue;
    Json value = name == "reason" ? Json(index_in(reasons, row.reason)) : page_value(row, member);
    if (value.is_null() || value == "") continue;
    if (member.kind == RowMember::Kind::Count && value == 0) continue;
    json[member.name] = std::move(value);
  }
  if (row.is_ill_posed()) json["ill_posed"] = true;
  if (row.check == "enclosure") json["certified"] = true;
  if (place.count > 0) {
    json["file"] = place.file;
    json["line"] = place.first;
    json["worst"] = worst_json(row, row.worst.front());
  }
  return json;
}

}  // namespace

std::string entry_name(const RowKey& row, int index) {
  const Formula* formula = find_formula(row.subject);
  if (!formula) return fmt::format("entry {}", index);
  constexpr std::string_view axes = "xyz";
  const auto derivatives = static_cast<int>(derivative_count(formula->dim(), row.order));
  const int entry = index / derivatives, entries = formula->shape.entries();
  std::vector<std::string> parts;
  if (formula->shape.per_corner) parts.push_back(fmt::format("corner {}", entry / entries));
  if (entries > 1)
    parts.push_back(fmt::format("row {}, column {}", axes[entry % entries / formula->shape.columns],
                                axes[entry % entries % formula->shape.columns]));
  std::string letters;
  for (int o = 0, rest = index % derivatives; o < row.order; ++o, rest /= formula->dim())
    letters = fmt::format("d/d{}{}{}", axes[rest % formula->dim()], letters.empty() ? "" : " ", letters);
  if (!letters.empty()) parts.push_back(letters);
  return parts.empty() ? "the value" : fmt::format("{}", fmt::join(parts, ", "));
}

Json rows_json(const Rows& rows, const WorstPlaces& places) {
  std::vector<std::string> reasons;
  Json list = Json::array();
  for (const ResultRow* row : rows) list.push_back(row_json(*row, places.of(*row), reasons));
  Json checks = Json::object();
  for (const ResultRow* row : rows)
    if (const std::string_view words = words_of_check(row->check); !words.empty()) checks[row->check] = words;
  return {{"reasons", reasons}, {"checks", checks}, {"rows", list}};
}

Json style_json(const SeriesStyle& style) {
  return {{"colour", style.colour},
          {"dash", fmt::format("{}", fmt::join(style.dash, " "))},
          {"shape", style.shape},
          {"filled", style.filled}};
}

Json curves_json(const RunResult& result, const std::string& subject) {
  const SeriesStyles styles(result);
  Json list = Json::array();
  for (const ResultCurve& curve : result.curves) {
    if (curve.section != RowKey::Section::Element || curve.subject != subject) continue;
    Json parameters = Json::array(), errors = Json::array();
    for (std::size_t i = 0; i < std::min(curve.parameters.size(), curve.errors.size()); ++i) {
      if (!(curve.parameters[i] > 0) || !std::isfinite(curve.parameters[i])) continue;
      parameters.push_back(curve.parameters[i]);
      errors.push_back(json_number(std::isfinite(curve.errors[i]) ? std::stod(fmt::format("{:.2e}", curve.errors[i]))
                                                                  : curve.errors[i]));
    }
    if (parameters.empty()) continue;
    list.push_back({{"cell", cell_id(curve)},
                    {"regime", curve.setting},
                    {"check", curve.check},
                    {"evaluation", curve.evaluation},
                    {"scalar", curve.scalar},
                    {"order", curve.order},
                    {"axis", curve.parameter_name},
                    {"style", style_json(styles.of(curve.evaluation, curve.scalar))},
                    {"x", parameters},
                    {"y", errors}});
  }
  return list;
}

}  // namespace cageproof::reports
