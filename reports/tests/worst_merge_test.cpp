// SPDX-License-Identifier: MIT
#include "cageproof/core/input_error.h"
#include "cageproof/core/whole_file.h"
#include "cageproof/reports/checked_file.h"
#include "cageproof/reports/worst_file.h"
#include "sample_run.h"

#include <gtest/gtest.h>

namespace cageproof::reports {
namespace {

WorstLine line_with(double error, double x, const std::string& evaluation = "closed_form") {
  WorstLine line;
  line.subject = "triangle.single_layer";
  line.evaluation = evaluation;
  line.scalar = "double";
  line.setting = "hunted";
  line.check = "truth";
  line.unit = "conditioned";
  line.order = line.worst.asked = 1;
  line.provenance = "hunt from near-edge, seed 1, budget 10";
  line.worst.error = error;
  line.worst.corners = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
  line.worst.point = {x, 0, 1};
  return line;
}

std::vector<double> errors_in(const std::filesystem::path& path) {
  std::vector<double> errors;
  for (const WorstLine& line : read_worst(path)) errors.push_back(line.worst.error);
  return errors;
}

class WorstMerge : public ::testing::Test {
 protected:
  std::filesystem::path path() const { return scratch_.path() / "cases.jsonl"; }
  ScratchFolder scratch_;
};

TEST_F(WorstMerge, KeepsTheWorstFewOfEachKind) {
  EXPECT_EQ(merge_worst(path(), {line_with(1, 1), line_with(3, 3), line_with(2, 2), line_with(1, 1, "gauss-8")}, 2),
            3U);
  EXPECT_EQ(errors_in(path()), (std::vector<double>{3, 2, 1}));
  const WorstLine line = read_worst(path())[0];
  EXPECT_EQ(line.worst.asked, 1);
  EXPECT_EQ(line.provenance, "hunt from near-edge, seed 1, budget 10");
  EXPECT_EQ(line.number, 1);
}

TEST_F(WorstMerge, TellsFramesOfACageApart) {
  WorstLine here = line_with(1, 1);
  here.section = RowKey::Section::Cage;
  WorstLine scaled = here, moved = here;
  scaled.worst.frame.unit = 1e-100;
  moved.worst.frame.shift[1] = 1e8;
  EXPECT_EQ(merge_worst(path(), {here, scaled, moved, scaled}, 9), 3U);
  EXPECT_EQ(merge_worst(path(), {here, scaled, moved}, 9), 0U);
}

TEST_F(WorstMerge, LosesNothingThatIsThere) {
  // Lines that our writers never write: blank ones, a remark, no end of the last line.
  std::string text = "\n" + worst_line(line_with(1, 1)) + "\n";
  std::string foreign = worst_line(line_with(2, 2));
  foreign.insert(1, "\"remark\":\"kept\",");
  text += foreign;
  write_file(path(), text);
  EXPECT_EQ(merge_worst(path(), {line_with(0.5, 5), line_with(7, 7), line_with(9, 2)}, 2), 1U)
      << "one is less bad than two, one is there already";
  const std::string merged = read_file(path());
  EXPECT_TRUE(merged.starts_with(text + "\n")) << merged;
  EXPECT_EQ(errors_in(path()), (std::vector<double>{1, 2, 7}));
  EXPECT_EQ(merge_worst(path(), {line_with(7, 7)}, 2), 0U);
  EXPECT_EQ(read_file(path()), merged);
}

TEST_F(WorstMerge, ABadFileIsNamedAndLeftAlone) {
  const std::string text = worst_line(line_with(1, 1)) + "\n{\"formula\":\n";
  write_file(path(), text);
  try {
    merge_worst(path(), {line_with(2, 2)}, 2);
    ADD_FAILURE() << "no error";
  } catch (const InputError& error) {
    EXPECT_NE(std::string(error.what()).find("cases.jsonl:2: malformed JSON"), std::string::npos) << error.what();
  }
  EXPECT_EQ(read_file(path()), text);
  const auto nowhere = scratch_.path() / "nowhere" / "cases.jsonl";
  EXPECT_THROW(merge_worst(nowhere, {line_with(2, 2)}, 2), InputError);
  EXPECT_EQ(std::distance(std::filesystem::directory_iterator(scratch_.path()), std::filesystem::directory_iterator()),
            1)
      << "something was left aside";
}

}  // namespace
}  // namespace cageproof::reports
