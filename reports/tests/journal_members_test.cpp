// SPDX-License-Identifier: MIT
// Every member of the findings goes through a journal and comes back equal, in a unit's line and in the finished
// journal.
#include "cageproof/reports/checked_file.h"
#include "cageproof/reports/journal.h"
#include "sample_run.h"

#include <gtest/gtest.h>

#include <cmath>

namespace cageproof::reports {
namespace {

// Every member differs from what it is when nothing is said.
PartialResult everything() {
  PartialResult gathered;
  Tally& tally = gathered.rows[{RowKey::Section::Deformer, "d", "e", "float", "cage", "check", "pose", 1}];
  tally.unit = "relative";
  WorstCase worst{0.1, -0.5, 9, {{1.0 / 3, -0.0, 1e300}}, {0.1, 0.2, 0.3}, {0.7}, 1};
  worst.relative = 1e-320;
  worst.furthest = {4, -HUGE_VAL, "2.5000000000000000001e-01"};
  tally.add(worst.error, 0.3, worst.sample, [&](double) { return worst; });
  tally.add(HUGE_VAL, 0.2, 3, [&](double error) {
    WorstCase other{error};
    other.sample = 3;
    other.frame = {{-0.0, 1e300, 1.0 / 3}, 1e-320};
    return other;
  });
  tally.asked = 21;
  tally.without_truth = 2;
  tally.unreached = 3;
  tally.declined = 5;
  tally.total_loss = 0;
  tally.by_parameter = {-1, 0.1};
  FieldPart part;
  part.title = "t \"quoted\"";
  part.shown = "second";
  part.samples = 2;
  part.cage = "cage/c";
  part.scene = "c.green.side-by-side";
  part.compared = {"gauss-8: relative error", "closed_form: relative error"};
  part.image = {"image", {2, 1, 1}, {0.1, 0.2, 0.3}, {1, 2, 3}, {}};
  part.image.arrays = {{"first", "1", 1, {0.1, std::nan("")}}, {"second", "", 3, {1, 2, 3, 4, 5, HUGE_VAL}, true}};
  part.image.facts = {{"cage", "c"}, {"evaluations", "gauss-8, closed_form"}, {"unit of length", "<&>"}};
  gathered.fields.emplace(std::pair(2, std::size_t{0}), part);
  part.mesh = "mesh";
  part.scene = part.cage = "";
  part.compared.clear();
  part.image.facts.clear();
  gathered.fields.emplace(std::pair(5, std::size_t{0}), part);
  gathered.meshes["mesh"] = {"mesh", {{0, 0, 0}, {1, 1.0 / 3, 0}}, {{0, 1}}, {}};
  gathered.errata[3] = {"source", "printed", "correct", "formula", "evaluation", "generic", 2, 24, 3, 0.1, 1e-40};
  return gathered;
}

void expect_same(const Tally& found, const Tally& expected) {
  EXPECT_EQ(found.unit, expected.unit);
  EXPECT_EQ(found.errors.counts(), expected.errors.counts());
  EXPECT_EQ(found.errors.nonfinite(), expected.errors.nonfinite());
  EXPECT_EQ(found.errors.max(), expected.errors.max());
  EXPECT_EQ(found.asked, expected.asked);
  EXPECT_EQ(found.without_truth, expected.without_truth);
  EXPECT_EQ(found.unreached, expected.unreached);
  EXPECT_EQ(found.declined, expected.declined);
  EXPECT_EQ(found.max_relative, expected.max_relative);
  EXPECT_EQ(found.total_loss, expected.total_loss);
  EXPECT_EQ(found.by_parameter, expected.by_parameter);
  ASSERT_EQ(found.worst.cases().size(), expected.worst.cases().size());
  for (std::size_t k = 0; k < found.worst.cases().size(); ++k) {
    const WorstCase &a = found.worst.cases()[k], &b = expected.worst.cases()[k];
    EXPECT_EQ(a.error, b.error);
    EXPECT_EQ(a.parameter, b.parameter);
    EXPECT_EQ(a.sample, b.sample);
    EXPECT_EQ(a.corners, b.corners);
    EXPECT_EQ(a.point, b.point);
    EXPECT_EQ(a.parameters, b.parameters);
    EXPECT_EQ(a.frame.unit, b.frame.unit);
    EXPECT_EQ(a.frame.shift, b.frame.shift);
    EXPECT_EQ(a.asked, b.asked);
    EXPECT_EQ(a.furthest.index, b.furthest.index);
    EXPECT_EQ(a.furthest.truth, b.furthest.truth);
    EXPECT_EQ(a.furthest.found, b.furthest.found);
    EXPECT_EQ(a.relative, b.relative);
  }
}

void expect_same(const FieldPart& found, const FieldPart& expected) {
  EXPECT_EQ(found.title, expected.title);
  EXPECT_EQ(found.shown, expected.shown);
  EXPECT_EQ(found.mesh, expected.mesh);
  EXPECT_EQ(found.samples, expected.samples);
  EXPECT_EQ(found.first, expected.first);
  EXPECT_EQ(found.cage, expected.cage);
  EXPECT_EQ(found.scene, expected.scene);
  EXPECT_EQ(found.compared, expected.compared);
  EXPECT_EQ(found.image.name, expected.image.name);
  EXPECT_EQ(found.image.facts, expected.image.facts);
  if (expected.mesh.empty()) {
    EXPECT_EQ(found.image.points, expected.image.points);
    EXPECT_EQ(found.image.origin, expected.image.origin);
    EXPECT_EQ(found.image.spacing, expected.image.spacing);
  }
  ASSERT_EQ(found.image.arrays.size(), expected.image.arrays.size());
  for (std::size_t k = 0; k < found.image.arrays.size(); ++k) {
    const ImageField::Array &a = found.image.arrays[k], &b = expected.image.arrays[k];
    EXPECT_EQ(a.name, b.name);
    EXPECT_EQ(a.unit, b.unit);
    EXPECT_EQ(a.components, b.components);
    EXPECT_EQ(a.linear, b.linear);
    ASSERT_EQ(a.values.size(), b.values.size());
    for (std::size_t i = 0; i < a.values.size(); ++i)
      EXPECT_TRUE(a.values[i] == b.values[i] || (std::isnan(a.values[i]) && std::isnan(b.values[i]))) << i;
  }
}

void expect_everything(const Journal& journal) {
  const PartialResult expected = everything();
  ASSERT_EQ(journal.gathered.rows.size(), 1u);
  EXPECT_EQ(journal.gathered.rows.begin()->first, expected.rows.begin()->first);
  expect_same(journal.gathered.rows.begin()->second, expected.rows.begin()->second);
  const auto found = whole_fields(journal.gathered), fields = whole_fields(expected);
  ASSERT_EQ(found.size(), 2u);
  for (const auto& [place, field] : fields) {
    ASSERT_TRUE(found.contains(place));
    expect_same(found.at(place), field);
  }
  const MeshField& mesh = journal.gathered.meshes.at("mesh");
  EXPECT_EQ(mesh.name, "mesh");
  EXPECT_EQ(mesh.vertices, expected.meshes.at("mesh").vertices);
  EXPECT_EQ(mesh.faces, expected.meshes.at("mesh").faces);
  const ErratumRow &row = journal.gathered.errata.at(3), &erratum = expected.errata.at(3);
  EXPECT_EQ(row.source, erratum.source);
  EXPECT_EQ(row.printed, erratum.printed);
  EXPECT_EQ(row.correct, erratum.correct);
  EXPECT_EQ(row.formula, erratum.formula);
  EXPECT_EQ(row.evaluation, erratum.evaluation);
  EXPECT_EQ(row.regime, erratum.regime);
  EXPECT_EQ(row.order, erratum.order);
  EXPECT_EQ(row.samples, erratum.samples);
  EXPECT_EQ(row.nonfinite, erratum.nonfinite);
  EXPECT_EQ(row.printed_error, erratum.printed_error);
  EXPECT_EQ(row.corrected_error, erratum.corrected_error);
}

class JournalMembers : public ::testing::Test {
 protected:
  JournalMembers() {
    JournalHeader header;
    header.units = header.shard_units = 1;
    Session session{"then", 0.25, "cageproof verify", {{"processor", "p"}}};
    session.times = {{"triangle.double_layer", "closed_form", 2, 1.0 / 3}, {"f", "gauss-8", 0, 1e-300}};
    write_file(path(), journal_head(header, session));
    JournalWriter(path()).add(0, everything(), 0.5);
  }
  std::filesystem::path path() const { return scratch_.path() / "journal"; }

 private:
  ScratchFolder scratch_;
};

TEST_F(JournalMembers, ComeBackFromAUnitsLine) { expect_everything(read_journal(path())); }

TEST_F(JournalMembers, ComeBackFromAFinishedJournal) {
  write_file(path(), journal_text(read_journal(path())));
  expect_everything(read_journal(path()));
}

// Before cases had a frame, the unit and the shift of a cage were four parameters.
TEST_F(JournalMembers, OfOlderJournalsSayWhereACageStood) {
  std::string text = journal_text(read_journal(path()));
  const std::string frame = R"({"unit":1e-320,"shift":[-0.0,1e+300,0.3333333333333333]})";
  const std::size_t at = text.find(frame);
  ASSERT_NE(at, text.npos) << text;
  text.replace(at, frame.size(), "[1e-320,-0.0,1e+300,0.3333333333333333]");
  write_file(path(), text);
  expect_everything(read_journal(path()));
}

TEST_F(JournalMembers, TimesOfASessionComeBack) {
  for (const bool finished : {false, true}) {
    if (finished) write_file(path(), journal_text(read_journal(path())));
    const Journal journal = read_journal(path());
    ASSERT_EQ(journal.sessions.size(), 1u);
    EXPECT_EQ(journal.sessions[0].seconds, 0.5);
    EXPECT_EQ(journal.sessions[0].started, "then");
    EXPECT_EQ(journal.sessions[0].command_line, "cageproof verify");
    const std::vector<EvaluationTime>& times = journal.sessions[0].times;
    ASSERT_EQ(times.size(), 2u);
    EXPECT_EQ(times[0].formula, "triangle.double_layer");
    EXPECT_EQ(times[0].evaluation, "closed_form");
    EXPECT_EQ(times[0].order, 2);
    EXPECT_EQ(times[0].nanoseconds, 1.0 / 3);
    EXPECT_EQ(times[1].nanoseconds, 1e-300);
  }
}

}  // namespace
}  // namespace cageproof::reports
