// SPDX-License-Identifier: MIT
// Figures in the report's page.
#include "figure.h"
#include "figure_facts.h"
#include "page_data.h"

#include <fmt/format.h>

namespace cageproof::reports {

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

void set_figures(Data& page, const std::vector<FigureEntry>& figures, const std::filesystem::path& folder) {
  Data list{Data::type::list};
  for (const FigureEntry& entry : figures) {
    Data figure, panels{Data::type::list};
    figure.set("heading", entry.sheet.heading);
    figure.set("source", entry.sheet.source);
    figure.set("text", entry.sheet.text);
    figure.set("file", entry.picture);
    figure.set("picture", embedded_png(folder / entry.picture));
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
    list << figure;
  }
  set_list(page, "figures", list);
}

}  // namespace cageproof::reports
