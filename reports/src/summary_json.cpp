// SPDX-License-Identifier: MIT
#include "cageproof/reports/summary.h"

#include "row_members.h"
#include "worst_places.h"

#include <algorithm>

namespace cageproof::reports {
namespace {

Json numbers(const std::vector<double>& values) {
  Json json = Json::array();
  for (const double value : values) json.push_back(json_number(value));
  return json;
}

// Facts that may differ between runs with the same findings.
Json environment(const RunResult& result) {
  Json sessions = Json::array();
  for (const Session& session : result.sessions) {
    Json times = Json::array();
    for (const EvaluationTime& time : session.times)
      times.push_back({{"formula", time.formula},
                       {"evaluation", time.evaluation},
                       {"order", time.order},
                       {"nanoseconds", json_number(time.nanoseconds)}});
    sessions.push_back({{"started", session.started},
                        {"seconds", json_number(session.seconds)},
                        {"command_line", session.command_line},
                        {"machine", session.machine},
                        {"times", times}});
  }
  return {{"sessions", sessions}, {"notes", result.session_notes}};
}

Json row_json(const ResultRow& row, const WorstPlace& worst) {
  Json json = Json::object();
  for (const RowMember& member : row_members()) json[member.name] = member_json(row, member);
  json["worst_file"] = worst.file;
  json["worst_lines"] = Json::array();
  for (std::size_t i = 0; i < worst.count; ++i) json["worst_lines"].push_back(worst.first + i);
  return json;
}

Json erratum_json(const ErratumRow& row) {
  Json json{
      {"source", row.source}, {"printed", row.printed}, {"correct", row.correct}, {"measured", !row.formula.empty()}};
  if (row.formula.empty()) return json;
  json.update({{"formula", row.formula},
               {"order", row.order},
               {"evaluation", row.evaluation},
               {"regime", row.regime},
               {"samples", row.samples},
               {"printed_nonfinite", row.nonfinite},
               {"printed_error", json_number(row.printed_error)},
               {"corrected_error", json_number(row.corrected_error)}});
  return json;
}

}  // namespace

void put_summary(const RunResult& result, std::string_view schema, const std::function<void(std::string_view)>& put) {
  const auto count = [&](Verdict verdict) { return std::ranges::count(result.rows, verdict, &ResultRow::verdict); };
  Json json{{"schema", schema},
            {"schema_version", summary_schema_version},
            {"all_kept", result.all_kept()},
            {"promises",
             {{"kept", count(Verdict::Kept)},
              {"broken", count(Verdict::Broken)},
              {"not_promised", count(Verdict::NotPromised)},
              {"undecided", count(Verdict::Undecided)}}},
            {"version", result.version},
            {"suite", result.suite},
            {"seed", result.seed},
            {"settings", result.settings},
            {"environment", environment(result)},
            {"notes", result.notes},
            {"histogram_bins",
             {{"bins_per_decade", ErrorHistogram::bins_per_decade},
              {"lowest_decade", ErrorHistogram::lowest_decade},
              {"highest_decade", ErrorHistogram::highest_decade},
              {"first_and_last", "bin 0 holds errors below, the last bin errors above these decades"}}},
            {"rows", Json::array()}};
  // Rows go to text one by one: as JSON values all of them take ten times as much memory.
  const std::string head = dump(json);
  put(std::string_view(head).substr(0, head.size() - std::string_view("]}").size()));
  const WorstPlaces worst(result);
  for (const ResultRow& r : result.rows) put((&r == &result.rows.front() ? "" : ",") + dump(row_json(r, worst.of(r))));
  json = {{"curves", Json::array()}, {"fields", Json::array()}, {"errata", Json::array()}};
  for (const ResultCurve& curve : result.curves)
    json["curves"].push_back({{"subject", curve.subject},
                              {"evaluation", curve.evaluation},
                              {"scalar", curve.scalar},
                              {"regime", curve.setting},
                              {"check", curve.check},
                              {"order", curve.order},
                              {"parameter_name", curve.parameter_name},
                              {"parameters", numbers(curve.parameters)},
                              {"relative_errors", numbers(curve.errors)}});
  for (const FieldEntry& field : result.fields) {
    Json entry{{"title", field.title},
               {"unit", field.unit},
               {"data", field.data},
               {"picture", field.picture},
               {"largest", json_number(field.largest)}};
    if (!field.page.empty()) entry["page"] = field.page;
    if (!field.state.empty()) entry["state"] = field.state;
    json["fields"].push_back(std::move(entry));
  }
  for (const ErratumRow& erratum : result.errata) json["errata"].push_back(erratum_json(erratum));
  put("]," + dump(json).substr(1) + "\n");
}

std::string summary_json(const RunResult& result, std::string_view schema) {
  std::string text;
  put_summary(result, schema, [&](std::string_view part) { text += part; });
  return text;
}

}  // namespace cageproof::reports
