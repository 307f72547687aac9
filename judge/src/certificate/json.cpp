// SPDX-License-Identifier: MIT
#include "cageproof/judge/certificate.h"

#include "cageproof/core/numbers/scalar_text.h"

#include <nlohmann/json.hpp>

#include <cmath>

namespace cageproof::judge {
namespace {

using Json = nlohmann::ordered_json;

Json number(double x) { return std::isfinite(x) ? Json(x) : Json(format_scalar(x)); }

// An input stands as an object, ready to be one line.
Json input(const std::string& line) { return line.empty() ? Json(nullptr) : Json::parse(line); }

Json json_of(const LargestError& error) {
  return {{"worst", number(error.error)}, {"median", number(error.median)}, {"input", input(error.input)}};
}

Json json_of(const CampaignRow& row, bool has_sides) {
  if (has_sides)
    return {{"regime", row.regime},
            {"samples", row.samples},
            {"declined", row.declined},
            {"failed", row.failed},
            {"wrong", row.wrong},
            {"first_wrong", row.first_wrong},
            {"input", input(row.wrong > 0 ? row.absolute.input : "")}};
  return {{"regime", row.regime},
          {"order", row.order},
          {"samples", row.samples},
          {"without_truth", row.without_truth},
          {"declined", row.declined},
          {"failed", row.failed},
          {"nonfinite", row.nonfinite},
          {"zero_truths", row.zero},
          {"digits", number(std::floor(10 * digits_of(row.relative.error)) / 10)},
          {"relative", json_of(row.relative)},
          {"conditioned", json_of(row.conditioned)},
          {"absolute", json_of(row.absolute)}};
}

Json json_of(const SubjectCampaign& campaign) {
  Json rows = Json::array(), times = Json::array();
  for (const CampaignRow& row : campaign.rows) rows.push_back(json_of(row, campaign.has_sides));
  for (const PairTime& time : campaign.times)
    times.push_back(
        {{"evaluation", time.evaluation}, {"order", time.order}, {"nanoseconds_per_pair", number(time.nanoseconds)}});
  Json found;
  found[campaign.is_kind ? "kind" : "formula"] = campaign.subject;
  if (campaign.is_kind) found["dimension"] = campaign.dimension;
  found["highest_order"] = campaign.order;
  found["rows"] = rows;
  found["times"] = times;
  return found;
}

Json json_of(const CodeFinding& finding) {
  return {{"kind", finding.kind},         {"defect", finding.is_defect}, {"text", finding.text},
          {"formula", finding.formula},   {"order", finding.order},      {"count", finding.count},
          {"input", input(finding.input)}};
}

}  // namespace

std::string json_of(const Certificate& c) {
  Json files = Json::array(), formulas = Json::array(), findings = Json::array();
  for (const JudgedFile& file : c.files) files.push_back({{"path", file.path}, {"sha256", file.sha256}});
  for (const SubjectCampaign& campaign : c.formulas) formulas.push_back(json_of(campaign));
  for (const CodeFinding& finding : c.findings) findings.push_back(json_of(finding));
  Json promise = nullptr;
  if (c.promise)
    promise = {{"bound", number(c.promise->bound)},
               {"measure", std::string(name_of(c.promise->measure))},
               {"kept", c.promise->is_kept},
               {"broken", c.promise->broken}};
  const Json all = {
      {"schema", "cageproof-certificate"},
      {"schema_version", 1},
      {"judged", {{"name", c.name}, {"what", c.what}, {"about", c.about}, {"files", files}}},
      {"verdict", c.has_defects()    ? "defects"
                  : c.is_undecided() ? "undecided"
                                     : "clean"},
      {"scalar", c.scalar},
      {"samples_per_regime", c.samples},
      {"seed", c.seed},
      {"findings", findings},
      {"not_asked", c.skipped},
      {"promise", promise},
      {"formulas", formulas},
      {"environment",
       {{"version", c.version}, {"commit", c.commit}, {"started", c.started}, {"command_line", c.command_line}}}};
  return all.dump(1, ' ', false, Json::error_handler_t::replace) + "\n";
}

}  // namespace cageproof::judge
