// SPDX-License-Identifier: MIT
#include "cageproof/reports/shown_names.h"
#include "page/gallery_page.h"
#include "page/pages.h"
#include "sample_run.h"

#include <gtest/gtest.h>

namespace cageproof::reports::shown_names_test {
namespace {

TEST(ShownNames, AreTheLastPartsOfPaths) {
  const ShownNames names({"cube", "/home/me/a.obj", "meshes/b.ply", "/home/me/a.obj"});
  EXPECT_EQ(names.of("/home/me/a.obj"), "a.obj");
  EXPECT_EQ(names.of("cube"), "cube");
  EXPECT_EQ(names.of("/home/me/unknown.obj"), "/home/me/unknown.obj");
  EXPECT_EQ(names.in("meshes/b.ply in /home/me/a.obj, green coordinates: errors of a/b"),
            "b.ply in a.obj, green coordinates: errors of a/b");
}

TEST(ShownNames, AreWholePathsWhereTwoShareTheirLastPart) {
  const ShownNames names({"one/a.obj", "two/a.obj", "two/b.obj"});
  EXPECT_EQ(names.of("one/a.obj"), "one/a.obj");
  EXPECT_EQ(names.of("two/a.obj"), "two/a.obj");
  EXPECT_EQ(names.of("two/b.obj"), "b.obj");
}

RunResult run_in(const std::vector<std::string>& cages) {
  RunResult run;
  for (const auto section : {RowKey::Section::Cage, RowKey::Section::Deformer})
    for (const std::string& cage : cages) {
      ResultRow row;
      row.section = section;
      row.subject = "green";
      row.evaluation = "batched";
      row.scalar = "double";
      row.setting = cage;
      row.check = "partition_of_unity";
      row.place = "inside";
      row.unit = "roundings";
      row.samples = 3;
      row.bound = 64;
      row.verdict = Verdict::Kept;
      run.rows.push_back(row);
    }
  return run;
}

std::size_t count_of(const std::string& text, const std::string& part) {
  std::size_t count = 0;
  for (auto at = text.find(part); at != text.npos; at = text.find(part, at + 1)) ++count;
  return count;
}

// A long path makes a page as wide as itself.
TEST(ShownNames, StandInHeadingsTablesAndTitlesOfPages) {
  RunResult run = run_in({"/a/long/way/to/cage.obj"});
  run.fields = {{.title = "/a/long/way/to/cage.obj, green coordinates", .data = "fields/a.vti", .largest = 1}};
  for (const auto& [name, text] : pages(run, {}, {})) {
    if (!name.ends_with(".html")) continue;
    const std::string body = text.substr(text.find("<body>"));
    EXPECT_NE(body.find("cage.obj"), body.npos) << name;
    // A page of the cage has the whole path, once and in small print.
    const bool of_cage = name.find('/') != name.npos;
    EXPECT_EQ(count_of(body, "/a/long/way/to/cage.obj"), of_cage ? 1U : 0U) << name;
    if (of_cage) EXPECT_NE(body.find("<p class=\"path\">/a/long/way/to/cage.obj</p>"), body.npos) << name;
  }
  for (const auto& [name, text] : pages(run_in({"one/cage.obj", "two/cage.obj"}), {}, {}))
    if (name == "index.html") EXPECT_NE(text.find(">two/cage.obj</a>"), text.npos);
}

}  // namespace
}  // namespace cageproof::reports::shown_names_test
