// SPDX-License-Identifier: MIT
#include "cageproof/reports/work_precision.h"

#include "cageproof/core/input_error.h"
#include "cageproof/reports/checked_file.h"
#include "csv_field.h"
#include "figure.h"
#include "json_value.h"
#include "report_folder.h"
#include "error_curves_picture.h"
#include "work_precision_picture.h"

#include <fmt/format.h>

#include <algorithm>

namespace cageproof::reports {
std::string work_precision_csv(const WorkPrecision& r) {
  std::string csv =
      "subject,where,place,distance,evaluation,order,samples,nonfinite,largest,rms,median,error,unit,nodes,"
      "nanoseconds,median_nanoseconds,quantile_nanoseconds,timed,units\n";
  for (const WorkPrecisionRow& row : r.rows)
    csv += fmt::format("{},{},{},{},{},{},{},{},{},{},{},{},{},{},{},{},{},{},{}\n", csv_field(r.subject),
                       csv_field(r.where), csv_field(row.place), row.distance, csv_field(row.evaluation), r.order,
                       row.samples, row.nonfinite, row.largest, row.rms, row.median, csv_field(r.error),
                       csv_field(r.unit), row.nodes, row.nanoseconds, row.median_nanoseconds, row.quantile_nanoseconds,
                       row.timed, row.units ? fmt::format("{}", *row.units) : "");
  return csv;
}

std::string work_precision_json(const WorkPrecision& r) {
  Json rows = Json::array();
  for (const WorkPrecisionRow& row : r.rows) {
    rows.push_back({{"place", row.place},
                    {"distance", row.distance},
                    {"evaluation", row.evaluation},
                    {"samples", row.samples},
                    {"nonfinite", row.nonfinite},
                    {"largest", json_number(row.largest)},
                    {"rms", json_number(row.rms)},
                    {"median", json_number(row.median)},
                    {"nodes", row.nodes},
                    {"nanoseconds", row.nanoseconds},
                    {"median_nanoseconds", row.median_nanoseconds},
                    {"quantile_nanoseconds", row.quantile_nanoseconds},
                    {"timed", row.timed}});
    if (row.units) rows.back()["units"] = json_number(*row.units);
  }
  const Json all = {
      {"schema", "cageproof-work-precision"},
      {"schema_version", 1},
      {"subject", r.subject},
      {"where", r.where},
      {"error", r.error},
      {"unit", r.unit},
      {"timed", r.timed},
      {"order", r.order},
      {"seed", r.seed},
      {"settings", r.settings},
      {"notes", r.notes},
      {"rows", rows},
      {"run",
       {{"version", r.version}, {"command_line", r.command_line}, {"started", r.started}, {"machine", r.machine}}}};
  return dump(all) + "\n";
}

std::string work_precision_text(const WorkPrecision& r) {
  // Digits first, which say what a result is worth; conditioned units are few next to an edge whatever it is.
  const bool has_digits = r.error == "relative error";
  const bool has_units = std::ranges::any_of(r.rows, [](const WorkPrecisionRow& row) { return row.units.has_value(); });
  std::vector<std::vector<std::string>> lines(1 + r.rows.size());
  const auto add_column = [&](const std::string& title, const auto& text_of) {
    lines[0].push_back(title);
    for (std::size_t i = 0; i < r.rows.size(); ++i) lines[i + 1].push_back(text_of(r.rows[i]));
  };
  const auto whole = [](double x) { return fmt::format("{:.0f}", x); };
  using Row = WorkPrecisionRow;
  add_column("place", [](const Row& row) { return row.place; });
  add_column("evaluation", [](const Row& row) { return row.evaluation; });
  add_column("samples", [](const Row& row) { return fmt::format("{}", row.samples); });
  if (has_digits) add_column("digits", [](const Row& row) { return digits_kept(row.largest, "double"); });
  if (has_units)
    add_column("(units)", [](const Row& row) { return fmt::format("({})", short_error(row.units.value_or(0))); });
  add_column("largest", [](const Row& row) { return short_error(row.largest); });
  add_column("rms", [](const Row& row) { return short_error(row.rms); });
  add_column("median", [](const Row& row) { return short_error(row.median); });
  // Nodes are not counted for evaluations that are prepared for a whole cage.
  add_column("nodes", [&](const Row& row) { return r.timed == "point" && row.nodes == 0 ? "-" : whole(row.nodes); });
  add_column("timed", [](const Row& row) { return fmt::format("{}", row.timed); });
  add_column("ns/" + r.timed + " median", [&](const Row& row) { return whole(row.median_nanoseconds); });
  add_column("mean", [&](const Row& row) { return whole(row.nanoseconds); });
  add_column("99.9 %", [&](const Row& row) { return whole(row.quantile_nanoseconds); });
  std::vector<std::size_t> width(lines[0].size());
  for (const auto& line : lines)
    for (std::size_t c = 0; c < line.size(); ++c) width[c] = std::max(width[c], line[c].size());
  std::string text = fmt::format("{}, {}: {} [{}], order {}\n", r.subject, r.where, r.error, r.unit, r.order);
  for (const auto& line : lines) {
    text += fmt::format("{:<{}}  {:<{}}", line[0], width[0], line[1], width[1]);
    for (std::size_t c = 2; c < line.size(); ++c) text += fmt::format("  {:>{}}", line[c], width[c]);
    text += '\n';
  }
  if (has_units)
    text +=
        "digits: correct ones of the worst result; (units): the largest conditioned error, in roundings of what the "
        "problem allows\n";
  for (const std::string& note : r.notes) text += note + '\n';
  return text;
}

struct WorkPrecisionWriter::State {
  explicit State(const std::filesystem::path& out) : folder(out, work_precision_kind()) {}
  ReportFolder folder;
};

WorkPrecisionWriter::WorkPrecisionWriter(const std::filesystem::path& out) : state_(std::make_unique<State>(out)) {}
WorkPrecisionWriter::~WorkPrecisionWriter() = default;

std::vector<std::string> WorkPrecisionWriter::write(const WorkPrecision& result) {
  const std::filesystem::path& folder = state_->folder.path();
  write_file(folder / "work_precision.csv", work_precision_csv(result));
  write_file(folder / "work_precision.json", work_precision_json(result));
  std::vector<Picture> pictures = error_curves_pictures(result);
  pictures.push_back(work_precision_picture(result, WorkAxis::Nodes, "pictures/error_nodes.png"));
  pictures.push_back(work_precision_picture(result, WorkAxis::Time, "pictures/error_time.png"));
  if (const auto undrawn = draw(pictures, folder); !undrawn.empty())
    throw InputError(fmt::format("cannot draw {}", undrawn.front()));
  state_->folder.commit();
  std::vector<std::string> files{"work_precision.csv", "work_precision.json"};
  files.reserve(files.size() + pictures.size());
  for (const Picture& picture : pictures) files.push_back(picture.file);
  return files;
}

}  // namespace cageproof::reports
