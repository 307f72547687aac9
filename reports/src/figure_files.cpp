// SPDX-License-Identifier: MIT
// Figures as files.
#include "cageproof/core/input_error.h"
#include "cageproof/reports/checked_file.h"
#include "cageproof/reports/figure_sheet.h"
#include "cageproof/reports/vtk_text.h"
#include "figure.h"
#include "report_folder.h"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

namespace cageproof::reports {

FigureEntry write_figure(const std::filesystem::path& folder, FigureSheet sheet) {
  FigureEntry entry;
  entry.picture = fmt::format("figures/{}.png", file_name(sheet.name));
  write_file(folder / entry.picture, figure_png(sheet));
  for (FigurePanel& panel : sheet.panels) {
    entry.data.push_back(fmt::format("figures/{}.{}.vtp", file_name(sheet.name), file_name(panel.file)));
    write_file(folder / entry.data.back(), vtp_text(panel.data));
    panel.data = {};
  }
  entry.sheet = std::move(sheet);
  return entry;
}

std::string figures_json(const std::vector<FigureEntry>& figures) {
  nlohmann::ordered_json json = {{"schema", "cageproof-figures"}, {"schema_version", 1}};
  auto all = nlohmann::ordered_json::array();
  for (const FigureEntry& figure : figures) {
    auto panels = nlohmann::ordered_json::array();
    for (std::size_t i = 0; i < figure.data.size(); ++i) {
      const FigurePanel& panel = figure.sheet.panels[i];
      nlohmann::ordered_json one = {{"title", panel.title}, {"data", figure.data[i]}};
      for (const auto& [name, value] : panel.facts) one[name] = value;
      for (const auto& [name, value] : panel.measured) one[name] = value;
      panels.push_back(std::move(one));
    }
    all.push_back({{"name", figure.sheet.name},
                   {"heading", figure.sheet.heading},
                   {"source", figure.sheet.source},
                   {"caption", figure.sheet.text},
                   {"picture", figure.picture},
                   {"panels", std::move(panels)}});
  }
  json["figures"] = std::move(all);
  return json.dump(2) + '\n';
}

void require_figure_folder(const std::filesystem::path& out) { replaceable_folder(out, figures_kind()); }

void write_figures(const std::filesystem::path& out, std::vector<FigureSheet> sheets) {
  ReportFolder folder(out, figures_kind());
  std::vector<FigureEntry> entries;
  entries.reserve(sheets.size());
  for (FigureSheet& sheet : sheets) entries.push_back(write_figure(folder.path(), std::move(sheet)));
  write_file(folder.path() / "figures/figures.json", figures_json(entries));
  folder.commit();
}

}  // namespace cageproof::reports
