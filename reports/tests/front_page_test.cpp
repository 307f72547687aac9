// SPDX-License-Identifier: MIT
// The first page is clear to someone who opens a report for the first time.
#include "cageproof/core/catalogue/formula.h"
#include "cageproof/core/whole_file.h"
#include "json_value.h"
#include "page/gallery_page.h"
#include "page/page_data.h"
#include "sample_run.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <limits>

namespace cageproof::reports {
namespace {

std::string page_named(const char* name, const RunResult& run) {
  const ScratchFolder scratch;
  ReportWriter writer(scratch.path() / "report");
  writer.write(run);
  writer.commit();
  return read_file(scratch.path() / "report" / name);
}

ResultRow row_of(double max_relative, Verdict verdict = Verdict::Kept) {
  ResultRow row;
  row.check = "truth";
  row.scalar = "double";
  row.unit = "conditioned";
  row.samples = 20;
  row.max = 3;
  row.bound = 64;
  row.max_relative = max_relative;
  row.verdict = verdict;
  return row;
}

TEST(FrontPage, SaysFirstWhatWasRunThenTheVerdictThenDigits) {
  const std::string page = page_named("index.html", sample_run(2, 4));
  const std::string main = page.substr(page.find("<body>"));
  const auto heat = main.find("id=\"digits\""), overview = main.find("id=\"formulas\"");
  EXPECT_LT(main.find("<h1>"), heat);
  EXPECT_NE(main.find("in 4 regimes; coordinates in 4 cages; deformers of the cages cube, square. Suite standard, seed "
                      "20240607."),
            std::string::npos);
  EXPECT_LT(main.find("Started 2024-06-07 08:09 UTC, took 187 s"), heat);
  EXPECT_LT(heat, main.find("id=\"how\""));
  EXPECT_LT(heat, overview);
}

TEST(FrontPage, ColoursDigitsThatAreRight) {
  EXPECT_EQ(heat_text(row_of(1e-15)), "15");
  EXPECT_EQ(heat_class(row_of(1e-15)), "e0");
  EXPECT_EQ(heat_class(row_of(1e-9)), "e1");
  EXPECT_EQ(heat_class(row_of(1e-5)), "e2");
  EXPECT_EQ(heat_class(row_of(1e-2)), "e3");
  EXPECT_EQ(heat_class(row_of(2)), "e4");
  EXPECT_EQ(heat_text(row_of(0)), "all");
  EXPECT_EQ(heat_class(row_of(0)), "e0");
  EXPECT_EQ(heat_text(row_of(1e-5, Verdict::Broken)), "5 ✗");
  EXPECT_EQ(heat_class(row_of(1e-5, Verdict::Broken)), "e2 broken");
  EXPECT_EQ(heat_class(row_of(1e-5, Verdict::NotPromised)), "e2 open");
  ResultRow infinite = row_of(1e-15, Verdict::Broken);
  infinite.max = std::numeric_limits<double>::infinity();
  EXPECT_EQ(heat_text(infinite), "0 ✗");
  EXPECT_EQ(heat_class(infinite), "e4 broken");
  ResultRow nothing = row_of(0);
  nothing.samples = 0;
  EXPECT_EQ(heat_text(nothing), "–");
  EXPECT_EQ(heat_class(nothing), "ill");
}

// Each cell leads to the line of its own formula and regime, also where formulas have different regimes.
TEST(FrontPage, CellsLeadToTheirLine) {
  RunResult run = sample_run(3, 4);
  const std::string first = run.rows[0].subject;
  std::erase_if(run.rows, [&](const ResultRow& row) {
    return row.section == RowKey::Section::Element && row.subject == first && row.setting == "near-face";
  });
  const std::string page = page_named("index.html", run);
  int cells = 0;
  for (auto at = page.find("\"><a href=\"#r"); at != page.npos; at = page.find("\"><a href=\"#r", at + 1)) {
    const std::string number = page.substr(at + 13, page.find('"', at + 13) - at - 13);
    const auto heat_line = page.rfind("<th scope=\"row\">", at) + 16;
    const std::string formula = page.substr(heat_line, page.find("</th>", heat_line) - heat_line);
    const auto line = page.find(fmt::format("<tr id=\"r{}\">", number));
    ASSERT_NE(line, page.npos) << number;
    const std::string text = page.substr(line, page.find("</tr>", line) - line);
    EXPECT_NE(text.find(">" + formula + "</a>"), text.npos) << formula << text;
    // The figure is that of the line's first column.
    const std::string figure =
        page.substr(page.find('>', at + 13) + 1, page.find("</a>", at) - page.find('>', at + 13) - 1);
    EXPECT_NE(text.find(figure.substr(0, figure.find(' ')) + " ("), text.npos) << figure << text;
    ++cells;
  }
  EXPECT_EQ(cells, 3 * 4 - 1);
}

// The script shows any evaluation's figures. They lead to cells of the formula's page, also where a name has characters
// that ids have not.
TEST(FrontPage, OtherEvaluationsLeadToTheirCells) {
  RunResult run = sample_run(2, 3);
  for (ResultRow& row : run.rows)
    if (row.evaluation == "quads-75") row.evaluation = "quads 75/2";
  std::erase_if(run.rows, [](const ResultRow& row) { return row.evaluation == "gauss-8" && row.order == 1; });
  const ScratchFolder scratch;
  ReportWriter writer(scratch.path() / "report");
  writer.write(run);
  writer.commit();
  const std::string page = read_file(scratch.path() / "report/index.html");
  const std::string start = "id=\"overview-data\">";
  const auto first = page.find(start) + start.size();
  const Json data = Json::parse(page.substr(first, page.find("</script>", first) - first));
  ASSERT_EQ(data["cells"].size(), 2 * 3);
  int links = 0;
  for (std::size_t line = 0; line < data["cells"].size(); ++line) {
    const ResultRow& of_line = *std::ranges::find_if(
        run.rows, [&, formula = std::next(catalogue().begin(), line / 3)->name](const ResultRow& row) {
          return row.subject == formula && row.setting == run.rows[0].setting;
        });
    const std::string formula = read_file(scratch.path() / "report" / page_of(of_line));
    const std::string regime = std::array{"generic", "near-face", "near-edge"}[line % 3];
    for (const auto& [column, orders] : data["cells"][line].items())
      for (int order = 0; order < 3; ++order) {
        if (orders[order].empty()) continue;
        const std::string id = data["ids"][regime][column][order];
        EXPECT_NE(formula.find(fmt::format("<a href=\"#{}\">{}", id, orders[order][0].get<std::string>())), page.npos)
            << id;
        ++links;
      }
  }
  EXPECT_EQ(links, 2 * 3 * (5 * 3 - 1));
}

// Rows of one regime that the recommended evaluation lacks.
TEST(FrontPage, LeavesOutColumnsAndLinesWithoutAFigure) {
  RunResult run = sample_run(2, 3);
  std::erase_if(run.rows, [&](const ResultRow& row) {
    return row.section == RowKey::Section::Element && row.setting == "near-edge" && row.evaluation == "closed_form" &&
           row.scalar == "double";
  });
  const std::string page = page_named("index.html", run);
  EXPECT_NE(page.find("<th scope=\"col\" hidden><span>near-edge</span></th>"), page.npos);
  EXPECT_NE(page.find("<th scope=\"col\"><span>near-face</span></th>"), page.npos);
  // The third of three regimes: a cell of each formula, and its line.
  const auto at = page.find("<td hidden class=\"\"><a href=\"#r2\">·</a></td>");
  EXPECT_NE(at, page.npos);
  EXPECT_NE(page.find("<tr id=\"r2\" hidden>"), page.npos);
  EXPECT_NE(page.find("<tr id=\"r1\"><th"), page.npos);
}

TEST(FrontPage, CountsNoFiguresWhereThereAreNone) {
  RunResult run = sample_run(1, 1);
  run.fields = {{.title = "telling", .data = "fields/b.vti", .largest = 2e-3}};
  const std::string page = page_named("index.html", run);
  EXPECT_NE(page.find("1 picture of a field</a>"), page.npos) << page.substr(page.find("id=\"pictures\""), 300);
}

TEST(FrontPage, SaysWhichRegimesHaveNoSamplesAtOnce) {
  RunResult run = sample_run(1, 1);
  EXPECT_EQ(page_named("index.html", run).find("is no regime"), std::string::npos);
  run.settings["regimes without samples"] = "near-edge is no regime of segments: nothing was asked there.";
  const std::string page = page_named("index.html", run);
  EXPECT_LT(page.find("<strong>near-edge is no regime of segments"), page.find("</header>"));
}

TEST(FrontPage, SaysWhatThePapersAre) {
  RunResult run = sample_run(1, 1);
  run.errata.front().source = "[W12] Eq 3";
  const std::string page = page_named("index.html", run);
  EXPECT_NE(page.find("[W12] Weber, Poranne, Gotsman, Biharmonic Coordinates, 2012."), page.npos);
  EXPECT_EQ(page.find("[T24] Thiery"), page.npos);
}

TEST(FrontPage, PicturesHaveTheVerdictAndTheCage) {
  RunResult run = sample_run(1, 1);
  run.settings["cage"] = "some/where/cage.obj";
  run.fields = {{.title = "some/where/cage.obj, green coordinates: errors of gauss-8, hybrid",
                 .data = "fields/b.vti",
                 .largest = 3.5,
                 .page = "field.html",
                 .state = "fields/b.pvsm"}};
  const std::string page = gallery_page(run, {});
  EXPECT_NE(page.find("Pictures of cage.obj</h1>"), page.npos);
  EXPECT_NE(page.find("<a href=\"index.html\">All "), page.npos) << page.substr(page.find("<h1>"), 400);
  EXPECT_NE(page.find("largest of gauss-8, which the picture shows, 3.5 (the colours end at 1)"), page.npos);
}

// Words of the rows that say nothing by themselves; what is compared between runs keeps them.
TEST(FrontPage, SaysUnitsInWords) {
  RunResult run = sample_run(1, 1);
  run.rows[0].unit = "of what is stated";
  run.rows[0].verdict = Verdict::Broken;
  run.rows[0].bound = 1;
  const std::string page = page_named("index.html", run);
  EXPECT_NE(page.find("<td>times the error that it states itself</td>"), page.npos);
  EXPECT_EQ(page.find("of what is stated"), page.npos);
  EXPECT_EQ(unit_text("conditioned"), "conditioned");
}

TEST(FrontPage, FoldsFieldsOfRoundingNoise) {
  FieldEntry field;
  field.largest = 9e-14;
  EXPECT_TRUE(is_rounding_noise(field));
  field.largest = 1e-13;
  EXPECT_FALSE(is_rounding_noise(field));
  RunResult run = sample_run(1, 1);
  run.fields = {{.title = "noise", .data = "fields/a.vti", .largest = 2e-16},
                {.title = "telling", .data = "fields/b.vti", .largest = 2e-3}};
  const std::string page = gallery_page(run, {});
  EXPECT_LT(page.find("<figcaption>telling"), page.find("Rounding noise: 1"));
  EXPECT_LT(page.find("Rounding noise: 1"), page.find("<figcaption>noise"));
}

}  // namespace
}  // namespace cageproof::reports
