// SPDX-License-Identifier: MIT
#include "cageproof/core/formula.h"
#include "cageproof/reports/summary.h"
#include "json_value.h"
#include "sample_run.h"
#include "tables.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>

namespace cageproof::reports {
namespace {

std::map<std::string, std::string> report(RunResult run) {
  const ScratchFolder scratch;
  ReportWriter writer(scratch.path() / "report");
  run.fields.push_back(
      writer.write_image(sample_slice("slice", 10), "<slice> & 'more'", "relative error", ColourScale::Log10));
  run.fields.push_back(writer.write_mesh(sample_mesh("mesh", 6), "mesh", "partition of unity", ColourScale::Log10));
  writer.write(run);
  writer.commit();
  return files_below(scratch.path() / "report");
}

// The values of all attributes of that name.
std::vector<std::string> attributes(const std::string& page, const std::string& name) {
  std::vector<std::string> values;
  const std::string start = name + "=\"";
  for (auto at = page.find(start); at != page.npos; at = page.find(start, at + 1))
    values.push_back(page.substr(at + start.size(), page.find('"', at + start.size()) - at - start.size()));
  return values;
}

TEST(ReportFiles, AreAFunctionOfTheResultButForTheRun) {
  RunResult run = sample_run(2, 3);
  const auto first = report(run), second = report(run);
  EXPECT_EQ(first, second);
  run.sessions = {{"2031-01-01T00:00:00Z", 1, "cageproof verify --jobs 1", {{"processor", "another"}}},
                  {"later", 2, "", {}}};
  run.session_notes = {"a note"};
  const auto other = report(run);
  ASSERT_EQ(other.size(), first.size());
  for (const auto& [name, bytes] : first) {
    if (name == "summary.json") {
      auto a = Json::parse(bytes), b = Json::parse(other.at(name));
      EXPECT_NE(a["environment"], b["environment"]);
      a.erase("environment");
      b.erase("environment");
      EXPECT_EQ(a, b);
    } else if (name == "summary.md" || name == "index.html") {
      const auto end = name == "summary.md" ? bytes.find("## Environment") : bytes.find("<footer");
      EXPECT_NE(end, std::string::npos);
      EXPECT_EQ(bytes.substr(0, end), other.at(name).substr(0, end)) << name;
    } else {
      EXPECT_EQ(bytes, other.at(name)) << name;
    }
  }
}

TEST(ReportFiles, SummaryJsonHoldsEveryFigure) {
  RunResult run = sample_run(1, 3);
  run.rows[0].max = HUGE_VAL;
  run.rows[0].max_relative = std::nan("");
  run.rows[0].median = 0.1 + 0.2;
  run.curves[0].errors[1] = -HUGE_VAL;
  run.notes.push_back("bytes \xff that are no text");
  const Json json = Json::parse(summary_json(run));
  EXPECT_EQ(json["schema"], "cageproof-summary");
  EXPECT_EQ(json["schema_version"], 2);
  EXPECT_EQ(json["all_kept"], false);
  EXPECT_EQ(json["seed"], run.seed);
  EXPECT_EQ(json["environment"]["sessions"][0]["seconds"], run.sessions[0].seconds);
  EXPECT_EQ(json["rows"][0]["max"], "inf");
  EXPECT_EQ(json["rows"][0]["max_relative"], "nan");
  EXPECT_EQ(json["curves"][0]["errors"][1], "-inf");
  EXPECT_TRUE(std::isnan(*number_of(json["rows"][0]["max_relative"])));
  ASSERT_EQ(json["rows"].size(), run.rows.size());
  std::size_t line = 1;
  for (std::size_t i = 0; i < run.rows.size(); ++i) {
    const ResultRow& row = run.rows[i];
    const Json& j = json["rows"][i];
    EXPECT_EQ(*number_of(j["max"]), row.max);
    EXPECT_EQ(*number_of(j["median"]), row.median);
    EXPECT_EQ(j["bound"].is_null(), !row.bound.has_value());
    std::vector<std::uint64_t> counts(j["histogram"]["first"].get<std::size_t>());
    for (const Json& count : j["histogram"]["counts"]) counts.push_back(count.get<std::uint64_t>());
    counts.resize(row.histogram.size());
    EXPECT_EQ(counts, row.histogram);
    for (const Json& at : j["worst_lines"]) EXPECT_EQ(at, line++);
    EXPECT_EQ(j["worst_lines"].size(), row.worst.size());
  }
  ASSERT_EQ(json["curves"].size(), run.curves.size());
  for (std::size_t i = 0; i < run.curves.size(); ++i)
    for (std::size_t k = 0; k < run.curves[i].errors.size(); ++k)
      EXPECT_EQ(*number_of(json["curves"][i]["errors"][k]), run.curves[i].errors[k]);
}

TEST(ReportFiles, CsvQuotesWhatMustBe) {
  RunResult run = sample_run(1, 1);
  run.rows.resize(1);
  ResultRow& row = run.rows[0];
  row.regime = "a, b.obj";
  row.reason = "a \"quoted\" reason\nof two lines";
  row.max = HUGE_VAL;
  row.p999 = 0.1;
  const std::string csv = results_csv(run);
  EXPECT_NE(csv.find(",\"a, b.obj\",truth,"), std::string::npos);
  EXPECT_NE(csv.find(",inf,0.1,"), std::string::npos);
  EXPECT_TRUE(csv.ends_with(",\"a \"\"quoted\"\" reason\nof two lines\"\n"));
  const std::string header = csv.substr(0, csv.find('\n'));
  EXPECT_EQ(std::ranges::count(header, ','), 19);
  run.rows[0].reason = run.rows[0].regime = "plain";
  const std::string plain = results_csv(run);
  EXPECT_EQ(std::ranges::count(plain, ','), 38);
  EXPECT_EQ(plain.find('"'), std::string::npos);
}

TEST(ReportFiles, DeformersHaveATableOfTheirOwn) {
  RunResult run = sample_run(1, 1);
  const std::string csv = results_csv(run);
  EXPECT_NE(csv.find("\ndeformer,green,stretch=rms,double,square,keeps_rigid,rotation,0,cage sizes,"),
            std::string::npos);
  const auto files = report(run);
  const std::string &page = files.at("index.html"), &text = files.at("summary.md");
  for (const char* part : {"href=\"#deformers\"", "id=\"deformers\"", "id=\"deformer-cube\"", "id=\"deformer-square\"",
                           "green, stretch=unit"})
    EXPECT_NE(page.find(part), std::string::npos) << part;
  const auto table = text.find("## Deformers");
  ASSERT_NE(table, std::string::npos);
  EXPECT_NE(text.find("| square | green, stretch=unit | cage sizes | ", table), std::string::npos);
  // Cages show nothing of them.
  EXPECT_GT(text.find("keeps_rigid"), table);
  std::erase_if(run.rows, [](const ResultRow& row) { return row.section == RowKey::Section::Deformer; });
  for (const auto& [name, without] : report(run)) EXPECT_EQ(without.find("eformers"), std::string::npos) << name;
}

TEST(ReportFiles, BrokenPromisesComeFirst) {
  RunResult run = sample_run(2, 2);
  for (ResultRow& row : run.rows) row.verdict = row.bound ? Verdict::Kept : Verdict::NotPromised;
  const std::string kept = summary_markdown(run);
  EXPECT_TRUE(kept.starts_with("# Cageproof: All "));
  EXPECT_EQ(kept.find("What fell short"), std::string::npos);
  EXPECT_EQ(report(run).at("index.html").find("What fell short"), std::string::npos);
  ResultRow &mild = run.rows[0], &bad = run.rows.back();
  mild.verdict = bad.verdict = Verdict::Broken;
  mild.max = 65.5;
  mild.reason = "mild";
  bad.max = 1e-3;
  for (const auto& [name, text] : report(run)) {
    if (name != "summary.md" && name != "index.html") continue;
    const auto short_fall = text.find("What fell short"),
               formulas = text.find(name == "index.html" ? "id=\"formulas\"" : "## Formulas");
    ASSERT_NE(short_fall, std::string::npos);
    EXPECT_LT(text.find("2 of "), short_fall);
    EXPECT_LT(short_fall, formulas);
    const auto section = text.substr(short_fall, formulas - short_fall);
    // 1e-3 of an allowed 1e-12 is further out than 65.5 of 64.
    EXPECT_LT(section.find("1e-3"), section.find("66")) << name;
    EXPECT_NE(section.find("66"), std::string::npos) << name;
  }
}

TEST(ReportFiles, ThePageStandsAlone) {
  RunResult run = sample_run(2, 3);
  run.rows[0].verdict = Verdict::Broken;
  run.rows[0].reason = "<script>alert(1)</script>";
  run.rows[0].evaluation = "plugin:\"x\" onload='y'";
  const std::string page = report(run).at("index.html");
  EXPECT_EQ(page.find("<script"), std::string::npos);
  EXPECT_EQ(page.find("http:"), std::string::npos);
  EXPECT_EQ(page.find("https:"), std::string::npos);
  EXPECT_EQ(page.find("@import"), std::string::npos);
  EXPECT_EQ(page.find("url("), std::string::npos);
  EXPECT_EQ(page.find("{{"), std::string::npos);
  EXPECT_NE(page.find("&lt;slice&gt; &amp; "), std::string::npos);
  EXPECT_NE(page.find("plugin:&quot;x&quot;"), std::string::npos);
  EXPECT_EQ(page.find("plugin:\"x\""), std::string::npos);
  // Every image is embedded and described, every link within the page has its target.
  const std::vector<std::string> images = attributes(page, "<img src"), links = attributes(page, "href");
  EXPECT_EQ(images.size(), 2u * 3 + 2);
  EXPECT_EQ(images.size(), attributes(page, "alt").size());
  for (const std::string& source : images) {
    EXPECT_TRUE(source.starts_with("data:image/png;base64,iVBOR"));
    EXPECT_GT(source.size(), 1000u);
  }
  EXPECT_GT(links.size(), 5u);
  for (const std::string& target : links) {
    EXPECT_TRUE(target.starts_with('#')) << target;
    EXPECT_NE(page.find(fmt::format("id=\"{}\"", target.substr(1))), std::string::npos) << target;
  }
  const Formula& formula = (*std::next(catalogue().begin(), 1));
  EXPECT_NE(page.find(std::string(formula.source)), std::string::npos);
}

TEST(ReportFiles, ErrataShowPrintAndCorrectionSideBySide) {
  const RunResult run = sample_run(1, 1);
  const std::string page = report(run).at("index.html"), text = summary_markdown(run);
  EXPECT_NE(page.find("<h2>Errata of the papers"), std::string::npos);
  EXPECT_NE(page.find("a &lt; b"), std::string::npos);
  for (const std::string& sheet : {page, text}) {
    const auto at = sheet.find("[X24] Eq 3");
    ASSERT_NE(at, std::string::npos);
    const auto printed = sheet.find("0.41, not finite on 3 of 24", at), corrected = sheet.find("3e-40", at);
    EXPECT_LT(printed, corrected);
    EXPECT_LT(corrected, sheet.find("Not measured here", at));
    EXPECT_LT(sheet.find("Not measured here", at), sheet.find("[X24] Eq 4", at));
  }
  const Json json = Json::parse(summary_json(run))["errata"];
  ASSERT_EQ(json.size(), 2u);
  EXPECT_EQ(json[0]["printed_error"], 0.401);
  EXPECT_EQ(json[0]["printed_nonfinite"], 3);
  EXPECT_EQ(json[1]["measured"], false);
  EXPECT_FALSE(json[1].contains("printed_error"));
}

TEST(ReportFiles, ARunOfFieldsAlone) {
  RunResult run;
  run.version = "0.1.0";
  const auto files = report(run);
  EXPECT_NE(files.at("index.html").find("Nothing was promised"), std::string::npos);
  EXPECT_EQ(files.at("index.html").find("<h2>Formulas"), std::string::npos);
  EXPECT_EQ(files.at("index.html").find("<h2>Cages"), std::string::npos);
  EXPECT_TRUE(files.contains("pictures/field.slice.png"));
  EXPECT_EQ(files.at("worst.jsonl"), "");
}

}  // namespace
}  // namespace cageproof::reports
