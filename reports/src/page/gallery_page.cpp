// SPDX-License-Identifier: MIT
#include "gallery_page.h"

#include "figure.h"
#include "figure_facts.h"
#include "page_data.h"
#include "page_template.h"
#include "run_names.h"

#include <fmt/format.h>

#include <algorithm>

namespace cageproof::reports {
namespace {

// A scene's largest error is that of the evaluation which its picture shows, in colours that end at one.
std::string largest_text(const FieldEntry& field) {
  constexpr std::string_view several = ": errors of ";
  const auto at = field.title.find(several);
  if (field.state.empty() || at == field.title.npos) return short_number(field.largest);
  const std::string first = field.title.substr(at + several.size());
  return fmt::format("of {}, which the picture shows, {}{}", first.substr(0, first.find(',')),
                     short_number(field.largest), field.largest > 1 ? " (the colours end at 1)" : "");
}

// Fields that are rounding noise, or those that are not.
Data fields_of(const RunResult& result, bool noise) {
  Data fields{Data::type::list};
  const ShownNames names = names_of_run(result);
  for (const FieldEntry& field : result.fields) {
    if (is_rounding_noise(field) != noise) continue;
    Data data;
    data.set("title", names.in(field.title));
    data.set("unit", field.unit.empty() || field.unit == "1" ? "" : " " + field.unit);
    data.set("file", field.data);
    data.set("largest", largest_text(field));
    data.set("has_picture", !field.picture.empty());
    data.set("picture", field.picture);
    data.set("has_page", !field.page.empty());
    data.set("page", field.page);
    data.set("has_state", !field.state.empty());
    data.set("state", field.state);
    fields << data;
  }
  return fields;
}

Data figure_data(const FigureEntry& entry) {
  Data figure, panels{Data::type::list};
  figure.set("heading", entry.sheet.heading);
  figure.set("source", entry.sheet.source);
  figure.set("text", entry.sheet.text);
  figure.set("picture", entry.picture);
  for (std::size_t i = 0; i < entry.data.size(); ++i) {
    const FigurePanel& panel = entry.sheet.panels[i];
    Data one;
    one.set("title", panel.title);
    one.set("facts", facts_text(panel));
    one.set("measured", measured_text(panel));
    one.set("file", entry.data[i]);
    panels << one;
  }
  figure.set("panels", panels);
  return figure;
}

}  // namespace

bool is_rounding_noise(const FieldEntry& field) { return field.largest < 1e-13; }

std::string facts_text(const FigurePanel& panel) {
  std::string text;
  for (const auto& [name, value] : panel.facts)
    if (!value.empty()) text += fmt::format("{}{} {}", text.empty() ? "" : ", ", name, value);
  return text;
}

std::string measured_text(const FigurePanel& panel) {
  std::string text;
  for (const auto& [name, value] : panel.measured)
    text += fmt::format("{}{} {}", text.empty() ? "" : ", ", name, short_number(value));
  return text;
}

std::string gallery_page(const RunResult& result, const std::vector<FigureEntry>& figures) {
  if (result.fields.empty() && figures.empty()) return "";
  Data data = common_data(result, "");
  Data sheets{Data::type::list};
  for (const FigureEntry& entry : figures) sheets << figure_data(entry);
  set_verdict(data, result);
  data.set("has_rows", !result.rows.empty());
  const auto cage = result.settings.find("cage");
  data.set("has_cage", cage != result.settings.end());
  data.set("of_cage", cage == result.settings.end() ? "" : names_of_run(result).of(cage->second));
  data.set("has_fields", !result.fields.empty());
  set_list(data, "telling_fields", fields_of(result, false));
  set_list(data, "noise", fields_of(result, true));
  data.set("noise_count", grouped(static_cast<std::uint64_t>(std::ranges::count_if(result.fields, is_rounding_noise))));
  set_list(data, "figures", sheets);
  return rendered(kGalleryTemplate, "gallery.mustache", data);
}

}  // namespace cageproof::reports
