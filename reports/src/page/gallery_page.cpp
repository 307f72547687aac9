// SPDX-License-Identifier: MIT
#include "gallery_page.h"

#include "figure.h"
#include "figure_facts.h"
#include "page_data.h"
#include "page_template.h"

#include <fmt/format.h>

#include <algorithm>

namespace cageproof::reports {
namespace {

// Fields that are rounding noise, or those that are not.
Data fields_of(const RunResult& result, bool noise) {
  Data fields{Data::type::list};
  for (const FieldEntry& field : result.fields) {
    if (is_rounding_noise(field) != noise) continue;
    Data data;
    data.set("title", field.title);
    data.set("unit", field.unit.empty() || field.unit == "1" ? "" : " " + field.unit);
    data.set("file", field.data);
    data.set("largest", short_number(field.largest));
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
  data.set("has_fields", !result.fields.empty());
  set_list(data, "telling_fields", fields_of(result, false));
  set_list(data, "noise", fields_of(result, true));
  data.set("noise_count", grouped(static_cast<std::uint64_t>(std::ranges::count_if(result.fields, is_rounding_noise))));
  set_list(data, "figures", sheets);
  return rendered(kGalleryTemplate, "gallery.mustache", data);
}

}  // namespace cageproof::reports
