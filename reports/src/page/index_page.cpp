// SPDX-License-Identifier: MIT
#include "figure.h"
#include "points_outside.h"
#include "cageproof/reports/worst_file.h"
#include "gallery_page.h"
#include "given_cage.h"
#include "page_data.h"
#include "page_template.h"
#include "pages.h"
#include "subject_page.h"

#include <fmt/format.h>

#include <algorithm>

namespace cageproof::reports {
namespace {

std::string index_page(const RunResult& result, const std::vector<FigureEntry>& figures) {
  Data data = common_data(result, "");
  set_verdict(data, result);
  set_given_cage(data, result);
  set_broken(data, result);
  data.set("front_style", kFrontStyle);
  data.set("front_script", kFrontScript);
  data.set("what_ran", what_ran(result));
  const std::string outside = points_outside_line(result);
  data.set("has_points_outside", !outside.empty());
  data.set("points_outside", outside);
  const auto nowhere = result.settings.find(regimes_nowhere_setting);
  data.set("has_regimes_nowhere", nowhere != result.settings.end());
  data.set("regimes_nowhere", nowhere == result.settings.end() ? "" : nowhere->second);
  set_proof(data, result);
  set_heat_map(data, result);
  set_overview(data, result);
  set_cages(data, result);
  set_errata(data, result);
  data.set("has_pictures", !result.fields.empty() || !figures.empty());
  data.set("field_count", result.fields.size() == 1
                              ? "1 picture of a field"
                              : fmt::format("{} pictures of fields", grouped(result.fields.size())));
  const auto noise = static_cast<std::uint64_t>(std::ranges::count_if(result.fields, is_rounding_noise));
  data.set("has_noise_count", noise > 0);
  data.set("noise_count", grouped(noise));
  data.set("has_figure_count", !figures.empty());
  data.set("figure_count", grouped(figures.size()));
  Data notes{Data::type::list};
  for (const std::string& note : result.notes) notes << Data(note);
  set_list(data, "notes", notes);
  set_environment(data, result);
  return rendered(kIndexTemplate, "index.mustache", data);
}

}  // namespace

std::map<std::string, std::string> pages(const RunResult& result, const std::vector<CurvePicture>& curves,
                                         const std::vector<FigureEntry>& figures) {
  std::map<std::string, std::string> all = subject_pages(result, curves);
  all["index.html"] = index_page(result, figures);
  if (std::string gallery = gallery_page(result, figures); !gallery.empty()) all["pictures.html"] = std::move(gallery);
  return all;
}

}  // namespace cageproof::reports
