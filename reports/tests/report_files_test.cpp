// SPDX-License-Identifier: MIT
#include "cageproof/core/catalogue/formula.h"
#include "cageproof/core/whole_file.h"
#include "cageproof/reports/checked_file.h"
#include "cageproof/reports/packed_file.h"
#include "cageproof/reports/summary.h"
#include "page/script_json.h"
#include "sample_run.h"
#include "tables.h"

#include <fmt/format.h>
#include <gtest/gtest.h>
#include <vtksys/Base64.h>

#include <algorithm>
#include <array>
#include <cstdio>
#include <numeric>
#include <set>
#include <sstream>

namespace cageproof::reports {
namespace {

// A page with its cells as text, where its script finds them packed.
std::string with_cells(const std::string& page, const std::filesystem::path& scratch) {
  const std::string start = "<script type=\"application/gzip\" id=\"cells-data\">";
  const auto at = page.find(start);
  if (at == page.npos) return page;
  const auto first = at + start.size(), end = page.find("</script>", first);
  std::string bytes(end - first, '\0');
  bytes.resize(vtksysBase64_Decode(reinterpret_cast<const unsigned char*>(page.data() + first), bytes.size(),
                                   reinterpret_cast<unsigned char*>(bytes.data()), 0));
  write_file(scratch / "cells", bytes);
  return page.substr(0, first) + script_json(Json::parse(read_packed(scratch / "cells"))) + page.substr(end);
}

// The report's files, unpacked.
std::map<std::string, std::string> report(RunResult run) {
  const ScratchFolder scratch;
  ReportWriter writer(scratch.path() / "report");
  run.fields.push_back(
      writer.write_image(sample_slice("slice", 10), "<slice> & 'more'", "relative error", ColourScale::Log10));
  run.fields.push_back(writer.write_mesh(sample_mesh("mesh", 6), "mesh", "partition of unity", ColourScale::Log10));
  writer.write(run);
  writer.commit();
  std::map<std::string, std::string> files = files_below(scratch.path() / "report");
  for (auto& [name, text] : files) {
    if (name.ends_with(".gz")) text = read_packed(scratch.path() / "report" / name);
    if (name.ends_with(".html")) text = with_cells(text, scratch.path());
  }
  return files;
}

// The values of all attributes of that name.
std::vector<std::string> attributes(const std::string& page, const std::string& name) {
  std::vector<std::string> values;
  const std::string start = name + "=\"";
  for (auto at = page.find(start); at != page.npos; at = page.find(start, at + 1))
    values.push_back(page.substr(at + start.size(), page.find('"', at + start.size()) - at - start.size()));
  return values;
}

// A page without what may differ between runs that found the same.
std::string without_environment(std::string page) {
  const std::string start = "<section class=\"environment\">", end = "</section>";
  for (auto at = page.find(start); at != page.npos; at = page.find(start))
    page.erase(at, page.find(end, at) + end.size() - at);
  return page;
}

TEST(ReportFiles, AreAFunctionOfTheResultButForTheRun) {
  RunResult run = sample_run(2, 3);
  const auto first = report(run), second = report(run);
  EXPECT_EQ(first, second);
  run.sessions = {{"2031-01-01T00:00:00Z",
                   1,
                   "cageproof verify --jobs 1",
                   {{"processor", "another"}},
                   {{"triangle.single_layer", "closed_form", 0, 850}}},
                  {"later", 2, "", {}}};
  run.session_notes = {"a note"};
  const auto other = report(run);
  ASSERT_EQ(other.size(), first.size());
  for (const auto& [name, bytes] : first) {
    if (name == summary_file) {
      auto a = Json::parse(bytes), b = Json::parse(other.at(name));
      EXPECT_NE(a["environment"], b["environment"]);
      a.erase("environment");
      b.erase("environment");
      EXPECT_EQ(a, b);
    } else if (name == "summary.md") {
      const auto end = bytes.find("## Environment");
      EXPECT_NE(end, std::string::npos);
      EXPECT_EQ(bytes.substr(0, end), other.at(name).substr(0, end)) << name;
    } else if (name.ends_with(".html")) {
      EXPECT_EQ(without_environment(bytes), without_environment(other.at(name))) << name;
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
  EXPECT_EQ(json["schema_version"], summary_schema_version);
  EXPECT_EQ(json["all_kept"], false);
  EXPECT_EQ(json["seed"], run.seed);
  EXPECT_EQ(json["environment"]["sessions"][0]["seconds"], run.sessions[0].seconds);
  EXPECT_EQ(json["rows"][0]["max"], "inf");
  EXPECT_EQ(json["rows"][0]["max_relative"], "nan");
  EXPECT_EQ(json["curves"][0]["relative_errors"][1], "-inf");
  EXPECT_TRUE(std::isnan(*number_of(json["rows"][0]["max_relative"])));
  ASSERT_EQ(json["rows"].size(), run.rows.size());
  std::map<std::string, std::size_t> line;
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
    for (const Json& at : j["worst_lines"]) EXPECT_EQ(at, ++line[j["worst_file"].get<std::string>()]);
    // Kept rows list their worst input, broken ones all that are known.
    EXPECT_EQ(j["worst_lines"].size(), row.verdict == Verdict::Broken ? row.worst.size() : 1u);
  }
  ASSERT_EQ(json["curves"].size(), run.curves.size());
  for (std::size_t i = 0; i < run.curves.size(); ++i)
    for (std::size_t k = 0; k < run.curves[i].errors.size(); ++k)
      EXPECT_EQ(*number_of(json["curves"][i]["relative_errors"][k]), run.curves[i].errors[k]);
}

TEST(ReportFiles, CsvQuotesWhatMustBe) {
  RunResult run = sample_run(1, 1);
  run.rows.resize(1);
  ResultRow& row = run.rows[0];
  row.setting = "a, b.obj";
  row.reason = "a \"quoted\" reason\nof two lines";
  row.max = HUGE_VAL;
  row.p999 = 0.1;
  const std::string csv = results_csv(run);
  EXPECT_NE(csv.find(",\"a, b.obj\",truth,"), std::string::npos);
  EXPECT_NE(csv.find(",inf,0.1,"), std::string::npos);
  EXPECT_TRUE(csv.ends_with(",\"a \"\"quoted\"\" reason\nof two lines\"\n"));
  const std::string header = csv.substr(0, csv.find('\n'));
  EXPECT_EQ(std::ranges::count(header, ','), 23);
  run.rows[0].reason = run.rows[0].setting = "plain";
  const std::string plain = results_csv(run);
  EXPECT_EQ(std::ranges::count(plain, ','), 46);
  EXPECT_EQ(plain.find('"'), std::string::npos);
}

// The line of a regime where the evaluation that the overview shows has no rows.
TEST(ReportFiles, OverviewLeavesFiguresThatAreNotThereEmpty) {
  RunResult run = sample_run(1, 2);
  std::erase_if(run.rows, [](const ResultRow& row) {
    return row.section == RowKey::Section::Element && row.setting == "near-face" && row.evaluation == "closed_form" &&
           row.scalar == "double";
  });
  const std::string page = report(run).at("index.html");
  const auto line = page.find("<td>near-face</td><td>closed_form, double</td>");
  ASSERT_NE(line, std::string::npos);
  const std::string cells = page.substr(line, page.find("</tr>", line) - line);
  EXPECT_TRUE(cells.ends_with("<td class=\"n\"></td><td class=\"n\"></td>")) << cells;
}

TEST(ReportFiles, DeformersHaveATableOfTheirOwn) {
  RunResult run = sample_run(1, 1);
  const std::string csv = results_csv(run);
  EXPECT_NE(csv.find("\ndeformer,green,stretch=rms,double,square,keeps_rigid,rotation,0,,cage sizes,"),
            std::string::npos);
  const auto files = report(run);
  const std::string &page = files.at("index.html"), &text = files.at("summary.md");
  for (const char* part :
       {"href=\"#deformers\"", "id=\"deformers\"", "href=\"deformers/cube.html\"", "href=\"deformers/square.html\""})
    EXPECT_NE(page.find(part), std::string::npos) << part;
  EXPECT_NE(files.at("deformers/square.html").find("green, stretch=unit"), std::string::npos);
  const auto table = text.find("## Deformers");
  ASSERT_NE(table, std::string::npos);
  EXPECT_NE(text.find("| square | green, stretch=unit | cage sizes | ", table), std::string::npos);
  // Cages show nothing of them.
  EXPECT_GT(text.find("keeps_rigid"), table);
  std::erase_if(run.rows, [](const ResultRow& row) { return row.section == RowKey::Section::Deformer; });
  for (const auto& [name, without] : report(run)) EXPECT_EQ(without.find("eformers"), std::string::npos) << name;
}

// Coordinates down, checks across, each with its unit and with what it compares.
TEST(ReportFiles, CoordinatesAreLinesAndChecksColumns) {
  const std::string page = report(sample_run(1, 1)).at("cages/cube.html");
  EXPECT_NE(
      page.find("title=\"Compared: the sum of the vertices&apos; coordinates and one\">partition_<wbr>of_<wbr>unity "
                "<span class=\"unit\">absolute</span></th>"),
      page.npos)
      << page.substr(page.find("<thead>"), 600);
  EXPECT_NE(
      page.find("<tr><th scope=\"row\">mean_<wbr>value <span class=\"note\">closed_form, double</span></th><td class="),
      page.npos);
  EXPECT_NE(
      report(sample_run(1, 1)).at("formulas/triangle.single_layer.html").find("<th scope=\"row\" title=\"Compared: "),
      page.npos);
  EXPECT_EQ(page.find("truth,"), page.npos) << "cells of a cage are compared with no value";
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

// A page loads nothing from elsewhere, and its links lead somewhere.
void expect_to_stand_alone(const std::string& name, const std::map<std::string, std::string>& files) {
  const std::string& page = files.at(name);
  // The scripts, ours and others', are tested by themselves. Files that the pages of a folder share lie next to them.
  std::string text = page;
  for (const std::string start : {"<script>", "<script type=\"application/gzip\"", "<script src=\"d3.min.js\">",
                                  "<script src=\"page.js\">", "<script src=\"cells.js\">"})
    for (auto at = text.find(start); at != text.npos; at = text.find(start))
      text.erase(at, text.find("</script>", at) + 9 - at);
  if (const auto end = name.find('/'); end != name.npos) {
    std::vector<std::string> beside{"page.js", "cells.js"};
    if (name.starts_with("formulas/")) beside.emplace_back("d3.min.js");
    for (const std::string& script : beside) {
      EXPECT_NE(page.find(fmt::format("<script src=\"{}\">", script)), std::string::npos) << name;
      EXPECT_TRUE(files.contains(name.substr(0, end + 1) + script)) << name << ": " << script;
    }
    EXPECT_NE(page.find("<link rel=\"stylesheet\" href=\"page.css\">"), std::string::npos) << name;
  }
  for (const char* part : {"http:", "https:", "@import", "url(", "{{", "<script src", "plugin:\"x\"", "<script>alert"})
    EXPECT_EQ(text.find(part), std::string::npos) << name << ": " << part;
  EXPECT_EQ(page.find("<script>alert"), std::string::npos) << name;
  EXPECT_EQ(attributes(text, "<img src").size(), attributes(text, "alt").size()) << name;
  const std::string folder = name.find('/') == name.npos ? "" : name.substr(0, name.find('/') + 1);
  std::vector<std::string> targets = attributes(text, "href");
  for (const std::string& source : attributes(text, "<img src")) targets.push_back(source);
  EXPECT_GT(targets.size(), 2u) << name;
  for (const std::string& target : targets) {
    const auto hash = target.find('#');
    std::string file = target.substr(0, hash);
    if (file.starts_with("../")) file.erase(0, 3);
    else file.insert(0, file.empty() ? name : folder);
    ASSERT_TRUE(files.contains(file)) << name << ": " << target;
    if (hash == target.npos) continue;
    // A section, or a cell that the page's script knows.
    const std::string id = target.substr(hash + 1), &there = files.at(file);
    EXPECT_TRUE(there.find(fmt::format("id=\"{}\"", id)) != there.npos ||
                there.find(fmt::format("\"id\":\"{}\"", id)) != there.npos)
        << name << ": " << target;
  }
}

TEST(ReportFiles, PagesStandAlone) {
  RunResult run = sample_run(2, 3);
  run.rows[0].verdict = Verdict::Broken;
  run.rows[0].reason = "</script><script>alert(1)</script>";
  run.rows[0].evaluation = "plugin:\"x\" onload='y'";
  run.sessions[0].times = {{"triangle.single_layer", "closed_form", 0, 850}};
  const auto files = report(run);
  int pages = 0;
  for (const auto& [name, text] : files)
    if (name.ends_with(".html")) ++pages, expect_to_stand_alone(name, files);
  EXPECT_EQ(pages, 1 + 1 + 2 + 4 + 2);  // index, pictures, formulas, cages, deformers
  EXPECT_NE(files.at("pictures.html").find("&lt;slice&gt; &amp; "), std::string::npos);
  EXPECT_NE(files.at("index.html").find("plugin:&quot;x&quot;"), std::string::npos);
  const Formula& formula = (*std::next(catalogue().begin(), 1));
  const std::string page = fmt::format("formulas/{}.html", formula.name);
  EXPECT_NE(files.at(page).find(std::string(formula.source)), std::string::npos);
}

TEST(ReportFiles, EveryCellOfAPageIsAnotherOne) {
  for (const auto& [name, text] : report(sample_run(2, 4))) {
    std::set<std::string> ids;
    for (auto at = text.find("{\"id\":\""); at != text.npos; at = text.find("{\"id\":\"", at + 1)) {
      const auto start = at + 7;
      EXPECT_TRUE(ids.insert(text.substr(start, text.find('"', start) - start)).second) << name;
    }
    if (name.starts_with("formulas/") && name.ends_with(".html")) {
      EXPECT_GT(ids.size(), 50u) << name;
    }
  }
}

// The cell of a row on its formula's page, as its script knows it.
Json cell_of(const std::map<std::string, std::string>& files, const std::string& page, const std::string& id) {
  const std::string start = "<script type=\"application/gzip\" id=\"cells-data\">";
  const std::string& text = files.at(page);
  const auto at = text.find(start) + start.size();
  const Json page_data = Json::parse(text.substr(at, text.find("</script>", at) - at));
  for (const Json& row : page_data["rows"])
    if (row["id"] == id) return row;
  return {};
}

TEST(ReportFiles, ACellAnswersWithItsWorstInputAndTheTruth) {
  RunResult run = sample_run(1, 2);
  ResultRow& row = run.rows[0];
  row.worst[0].furthest = {0, 0.25, "2.5000000000000000001e-01"};
  row.worst[0].relative = 4e-20;
  row.samples = 999;
  const auto files = report(run);
  const std::string page = fmt::format("formulas/{}.html", row.subject);
  const Json cell = cell_of(files, page, "truth.generic.closed_form.double.0");
  EXPECT_EQ(cell["worst"]["point"][2], "0x0.00000000007e8p-1022");
  EXPECT_EQ(cell["worst"]["element"].size(), 3u);
  EXPECT_EQ(cell["worst"]["found"], "0.25");
  EXPECT_EQ(cell["worst"]["truth"], "2.5000000000000000001e-01");
  EXPECT_EQ(cell["worst"]["digits"], "all");
  EXPECT_EQ(cell["bound"], "64");
  EXPECT_FALSE(cell.contains("median"));
  // Its line in the file of worst inputs is its own.
  std::istringstream lines(files.at(cell["file"].get<std::string>()));
  std::string line;
  for (int n = cell["line"].get<int>(); n > 0; --n) std::getline(lines, line);
  EXPECT_EQ(Json::parse(line)["point"], cell["worst"]["point"]);
  run.rows[0].samples = 1000;
  EXPECT_TRUE(cell_of(report(run), page, "truth.generic.closed_form.double.0").contains("median"));
}

// The numbers that the picture of times and errors on a formula's page is drawn from.
Json times_on_page(const RunResult& run, const std::string& formula) {
  const std::string page = report(run).at(fmt::format("formulas/{}.html", formula));
  const std::string start = "<script type=\"application/json\" id=\"times-data\">";
  const auto at = page.find(start) + start.size();
  return Json::parse(page.substr(at, page.find("</script>", at) - at));
}

TEST(ReportFiles, TimesStandBesideTheirOwnErrors) {
  RunResult run = sample_run(2, 4);
  run.rows[0].verdict = Verdict::Broken;
  const std::string formula = run.rows[0].subject;
  run.sessions[0].times = {{formula, "closed_form", 0, 850.4},
                           {formula, "closed_form", 2, 1999.6},
                           {formula, "gauss-8", 0, 30},
                           {std::string(std::next(catalogue().begin())->name), "closed_form", 0, 7}};
  const auto row_of = [&](const std::string& regime, int order, const std::string& check) -> ResultRow& {
    return *std::ranges::find_if(run.rows, [&](const ResultRow& row) {
      return row.subject == formula && row.evaluation == "closed_form" && row.scalar == "double" &&
             row.setting == regime && row.check == check && row.order == order;
    });
  };
  // Rows of anything else are far off.
  constexpr double u = 0x1p-53;
  for (ResultRow& row : run.rows) row.max_relative = 1e6 * u;
  for (const int order : {0, 1, 2}) {
    row_of("generic", order, "truth").max_relative = (9 + order) * u;
    row_of("near-face", order, "truth").max_relative = 3 * u;
    row_of("near-edge", order, "truth").max_relative = (5 + order) * u;
    row_of("near-vertex", order, "truth").max_relative = 2 * u;
  }
  row_of("generic", 0, "truth").max_relative = 0;
  // A cage's sum of the formula, and a cage whose file is called like a regime.
  ResultRow cage = row_of("near-edge", 0, "truth");
  cage.section = RowKey::Section::Cage;
  cage.setting = "near-wall.obj";
  cage.max_relative = 1e6 * u;
  run.rows.push_back(cage);
  Json times = times_on_page(run, formula);
  ASSERT_EQ(times.size(), 3u);
  for (Json& time : times) {
    EXPECT_TRUE(time["style"].contains("colour")) << time;
    time.erase("style");
  }
  EXPECT_EQ(
      times[0],
      (Json{{"evaluation", "closed_form"}, {"order", 0}, {"nanoseconds", 850.0}, {"generic", 0.0}, {"near", 5.0}}));
  EXPECT_EQ(
      times[1],
      (Json{{"evaluation", "closed_form"}, {"order", 2}, {"nanoseconds", 2000.0}, {"generic", 11.0}, {"near", 7.0}}));
  EXPECT_EQ(times[2]["evaluation"], "gauss-8");
  EXPECT_EQ(times[2]["generic"], 1e6);
  // An error that was not measured is null, and one that is not finite says so.
  for (const char* regime : {"near-edge", "near-vertex"}) row_of(regime, 0, "truth").samples = 0;
  row_of("generic", 2, "truth").max_relative = row_of("near-face", 2, "truth").max_relative = HUGE_VAL;
  EXPECT_EQ(times_on_page(run, formula)[0]["near"], 3.0);
  row_of("near-face", 0, "truth").max_relative = 0;
  EXPECT_EQ(times_on_page(run, formula)[0]["near"], 0.0);
  for (const char* regime : {"generic", "near-face"}) row_of(regime, 0, "truth").samples = 0;
  const Json without = times_on_page(run, formula);
  EXPECT_TRUE(without[0]["generic"].is_null());
  EXPECT_TRUE(without[0]["near"].is_null());
  EXPECT_EQ(without[1]["generic"], "inf");
  EXPECT_EQ(without[1]["near"], "inf");
}

TEST(ReportFiles, WhatNoResultCouldBreakIsGrey) {
  RunResult run = sample_run(1, 1);
  ResultRow& row = run.rows[0];
  row.verdict = Verdict::NotPromised;
  row.total_loss = 63;
  const std::string page = fmt::format("formulas/{}.html", row.subject), id = "truth.generic.closed_form.double.0";
  EXPECT_EQ(cell_of(report(run), page, id)["css"], "ill");
  EXPECT_EQ(cell_of(report(run), page, id)["total_loss"], "63");
  EXPECT_EQ(cell_of(report(run), page, id)["ill_posed"], true);
  row.total_loss = 65;
  row.verdict = Verdict::Kept;
  EXPECT_EQ(cell_of(report(run), page, id)["css"], "e0");
  EXPECT_FALSE(cell_of(report(run), page, id).contains("ill_posed"));
  EXPECT_NE(cell_of(report(run), page, "truth.generic.gauss-8.double.0")["css"].get<std::string>().find("open"),
            std::string::npos);
}

// Rows that were never measured are grey too; rows that no result could break have a tile and a figure of their own.
TEST(ReportFiles, WhatIsGreyIsCounted) {
  RunResult run = sample_run(1, 1);
  ResultRow& row = run.rows[0];
  const std::string page = fmt::format("formulas/{}.html", row.subject), id = "truth.generic.closed_form.double.0";
  const std::string tile = "results that cannot be judged";
  EXPECT_EQ(report(run).at("index.html").find(tile), std::string::npos);
  row.verdict = Verdict::NotPromised;
  row.total_loss = 64;
  EXPECT_NE(report(run).at("index.html").find(tile), std::string::npos);
  EXPECT_EQ(number_of(Json::parse(summary_json(run))["rows"][0]["total_loss"]), std::optional(64.0));
  row.total_loss = -1;
  EXPECT_TRUE(Json::parse(summary_json(run))["rows"][0]["total_loss"].is_null());
  EXPECT_EQ(report(run).at("index.html").find(tile), std::string::npos);
  row.samples = 0;
  EXPECT_EQ(cell_of(report(run), page, id)["css"], "ill");
  row.verdict = Verdict::Broken;
  EXPECT_NE(cell_of(report(run), page, id)["css"], "ill");
}

TEST(ReportFiles, PagesAreSmall) {
  for (const auto& [name, text] : report(sample_run(3, 12))) {
    if (name.ends_with(".html")) {
      EXPECT_LT(text.size(), name == "index.html" ? 200'000u : 1'000'000u) << name;
    }
  }
}

TEST(ReportFiles, CodeOfOthersIsWhatItSays) {
  // The table next to it states versions and hashes.
  const std::string folder = CAGEPROOF_REPORT_PAGE "/third_party/", table = read_file(folder + "README.md");
  int files = 0;
  for (const auto& entry : std::filesystem::directory_iterator(folder)) {
    if (entry.path().extension() != ".js") continue;
    ++files;
    const std::string command = fmt::format("sha256sum '{}'", entry.path().string());
    FILE* pipe = ::popen(command.c_str(), "r");
    std::array<char, 65> hash{};
    ASSERT_EQ(std::fread(hash.data(), 1, 64, pipe), 64u);
    ::pclose(pipe);
    EXPECT_NE(table.find(hash.data()), std::string::npos) << entry.path();
  }
  EXPECT_GT(files, 0);
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
