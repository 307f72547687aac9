// SPDX-License-Identifier: MIT
#include "page.h"

#include "figure.h"
#include "page_data.h"
#include "page_template.h"

#include <fmt/format.h>

#include <algorithm>

namespace cageproof::reports {
namespace {

Data tile(std::uint64_t count, const std::string& what, const std::string& kind) {
  Data data;
  data.set("figure", grouped(count));
  data.set("what", what);
  data.set("kind", kind);
  return data;
}

void set_verdict(Data& page, const RunResult& result) {
  const auto count = [&](Verdict verdict) {
    return static_cast<std::uint64_t>(std::ranges::count(result.rows, verdict, &ResultRow::verdict));
  };
  const std::uint64_t kept = count(Verdict::Kept), broken = count(Verdict::Broken);
  std::uint64_t samples = 0;
  for (const ResultRow& row : result.rows) samples += row.samples;
  page.set("verdict", verdict_line(result));
  page.set("verdict_class", broken ? "broken" : kept ? "kept" : "neutral");
  page.set("verdict_mark", broken ? "✗" : kept ? "✓" : "–");
  Data tiles{Data::type::list};
  tiles << tile(kept, "promises kept", "kept");
  tiles << tile(broken, "promises broken", broken ? "broken" : "");
  tiles << tile(count(Verdict::NotPromised), "stated, not promised", "");
  tiles << tile(samples, "errors measured", "");
  page.set("tiles", tiles);
}

void set_fields(Data& page, const RunResult& result, const std::filesystem::path& folder) {
  Data fields{Data::type::list};
  for (const FieldEntry& field : result.fields) {
    Data data;
    data.set("title", field.title);
    data.set("unit", field.unit.empty() || field.unit == "1" ? "" : " " + field.unit);
    data.set("file", field.data);
    data.set("largest", short_number(field.largest));
    data.set("has_picture", !field.picture.empty());
    if (!field.picture.empty()) data.set("picture", embedded_png(folder / field.picture));
    fields << data;
  }
  set_list(page, "fields", fields);
}

Data pairs(const std::map<std::string, std::string>& map) {
  Data list{Data::type::list};
  for (const auto& [key, value] : map) {
    Data data;
    data.set("key", key);
    data.set("value", value);
    list << data;
  }
  return list;
}

void set_environment(Data& page, const RunResult& result) {
  Data sessions{Data::type::list}, notes{Data::type::list};
  for (const Session& session : result.sessions) {
    Data data;
    data.set("command_line", session.command_line);
    data.set("started", session.started);
    data.set("seconds", fmt::format("{:.1f}", session.seconds));
    data.set("machine", pairs(session.machine));
    sessions << data;
  }
  for (const std::string& note : result.session_notes) notes << Data(note);
  page.set("sessions", sessions);
  set_list(page, "session_notes", notes);
}

}  // namespace

std::string page(const RunResult& result, const std::vector<CurvePicture>& curves,
                 const std::vector<FigureEntry>& figures, const std::filesystem::path& folder) {
  Data data;
  data.set("style", kPageStyle);
  set_verdict(data, result);
  set_broken(data, result);
  set_overview(data, result);
  set_formulas(data, result, curves, folder);
  set_cages(data, result);
  set_fields(data, result, folder);
  set_figures(data, figures, folder);
  set_errata(data, result);
  Data notes{Data::type::list};
  for (const std::string& note : result.notes) notes << Data(note);
  set_list(data, "notes", notes);
  data.set("version", result.version);
  data.set("suite", result.suite);
  data.set("seed", fmt::format("{}", result.seed));
  data.set("settings", pairs(result.settings));
  set_environment(data, result);
  kainjow::mustache::mustache sheet(kPageTemplate);
  if (!sheet.is_valid()) throw std::logic_error("page.mustache: " + sheet.error_message());
  return sheet.render(data);
}

}  // namespace cageproof::reports
