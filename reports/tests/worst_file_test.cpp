// SPDX-License-Identifier: MIT
#include "cageproof/reports/worst_file.h"

#include "cageproof/core/catalogue/formula.h"
#include "cageproof/core/input_error.h"
#include "cageproof/reports/checked_file.h"
#include "sample_run.h"

#include <fmt/format.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <bit>
#include <cmath>

namespace cageproof::reports::worst_file_test {
namespace {

// Zero's sign and the bits of a NaN count, too.
bool same_bits(double a, double b) { return std::bit_cast<std::uint64_t>(a) == std::bit_cast<std::uint64_t>(b); }
bool same_bits(const Vec3<double>& a, const Vec3<double>& b) {
  return same_bits(a[0], b[0]) && same_bits(a[1], b[1]) && same_bits(a[2], b[2]);
}

std::string message_of(const std::filesystem::path& path) {
  try {
    read_worst(path);
  } catch (const InputError& error) {
    return error.what();
  }
  return "";
}

class WorstFile : public ::testing::Test {
 protected:
  std::filesystem::path write(const std::string& text) {
    write_file(scratch_.path() / "worst.jsonl", text);
    return scratch_.path() / "worst.jsonl";
  }
  ScratchFolder scratch_;
};

TEST_F(WorstFile, RoundTripIsExact) {
  RunResult run = sample_run(2, 3);
  run.rows[0].worst[0].error = HUGE_VAL;
  run.rows[0].worst[0].parameter = 1e-300;
  run.rows[0].worst[0].sample = ~std::uint64_t{0};
  const std::vector<WorstLine> lines = read_worst(write(worst_lines(run)));
  std::size_t at = 0;
  for (const ResultRow& row : run.rows) {
    for (const WorstCase& worst : row.worst) {
      ASSERT_LT(at, lines.size());
      const WorstLine& line = lines[at++];
      EXPECT_EQ(line.section, row.section);
      EXPECT_EQ(line.subject, row.subject);
      EXPECT_EQ(line.evaluation, row.evaluation);
      EXPECT_EQ(line.scalar, row.scalar);
      EXPECT_EQ(line.setting, row.setting);
      EXPECT_EQ(line.check, row.check);
      EXPECT_EQ(line.place, row.place);
      EXPECT_EQ(line.order, row.order);
      EXPECT_EQ(line.unit, row.unit);
      EXPECT_EQ(line.bound, row.bound);
      EXPECT_EQ(line.triangulation, "shortest");
      EXPECT_EQ(line.provenance, "");
      EXPECT_EQ(line.number, static_cast<int>(at));
      EXPECT_EQ(line.flags, std::vector<std::string>{row.place.empty() ? row.setting : row.place});
      EXPECT_TRUE(same_bits(line.worst.error, worst.error));
      EXPECT_TRUE(same_bits(line.worst.parameter, worst.parameter));
      EXPECT_EQ(line.worst.sample, worst.sample);
      EXPECT_TRUE(same_bits(line.worst.point, worst.point));
      ASSERT_EQ(line.worst.corners.size(), worst.corners.size());
      for (std::size_t k = 0; k < worst.corners.size(); ++k)
        EXPECT_TRUE(same_bits(line.worst.corners[k], worst.corners[k]));
    }
  }
  EXPECT_EQ(at, lines.size());
}

TEST_F(WorstFile, ParametersKeepTheirOrder) {
  RunResult run = sample_run(1, 1);
  run.rows.resize(1);
  run.rows[0].subject = "someone's formula";
  run.rows[0].worst.resize(1);
  run.rows[0].worst[0].parameters = {0.3, 1e-320, -7.0};
  EXPECT_EQ(read_worst(write(worst_lines(run)))[0].worst.parameters, run.rows[0].worst[0].parameters);
}

TEST_F(WorstFile, ParametersGoByTheirNames) {
  const auto formula = std::ranges::find_if(catalogue(), [](const Formula& f) { return f.parameters.size() > 1; });
  ASSERT_NE(formula, catalogue().end());
  const std::string first(formula->parameters[0].name), second(formula->parameters[1].name);
  RunResult run = sample_run(1, 1);
  run.rows.resize(1);
  run.rows[0].subject = formula->name;
  run.rows[0].worst.resize(1);
  const auto read_back = [&](const nlohmann::json& line) { return read_worst(write(line.dump()))[0].worst.parameters; };
  // A case may need none.
  nlohmann::json line = nlohmann::json::parse(worst_lines(run));
  EXPECT_EQ(line["parameters"], nlohmann::json::object());
  EXPECT_EQ(read_back(line), std::vector<double>());
  run.rows[0].worst[0].parameters.resize(formula->parameters.size());
  run.rows[0].worst[0].parameters[0] = 0.3;
  run.rows[0].worst[0].parameters[1] = -7;
  line = nlohmann::json::parse(worst_lines(run));
  EXPECT_EQ(line["parameters"][first], "0x1.3333333333333p-2");
  EXPECT_EQ(read_back(line), run.rows[0].worst[0].parameters);
  // The order of the members does not matter, and other members do not either.
  line["parameters"] = {};
  for (const Parameter& parameter : formula->parameters) line["parameters"][std::string(parameter.name)] = 0;
  line["parameters"][first] = 2;
  line["parameters"][second] = 1;
  line["parameters"]["a remark"] = 5;
  const std::vector<double> found = read_back(line);
  ASSERT_EQ(found.size(), formula->parameters.size());
  EXPECT_EQ(found[0], 2);
  EXPECT_EQ(found[1], 1);
  line["parameters"].erase(second);
  EXPECT_NE(message_of(write(line.dump())).find(fmt::format("\"parameters\" lacks \"{}\"", second)), std::string::npos);
}

TEST_F(WorstFile, SaysWhereACageStood) {
  RunResult run = sample_run(1, 1);
  run.rows.resize(1);
  run.rows[0].section = RowKey::Section::Cage;
  run.rows[0].worst.resize(1);
  WorstCase& worst = run.rows[0].worst[0];
  const auto own = nlohmann::json::parse(worst_lines(run));
  EXPECT_FALSE(own.contains("frame"));
  worst.frame = {{1.0 / 3, -0.0, 1e8}, 1e-100};
  const auto framed = nlohmann::json::parse(worst_lines(run));
  const auto expect_frame = [&](const nlohmann::json& line) {
    const WorstCase found = read_worst(write(line.dump()))[0].worst;
    EXPECT_EQ(found.frame.unit, worst.frame.unit);
    EXPECT_TRUE(same_bits(found.frame.shift, worst.frame.shift));
    EXPECT_TRUE(found.parameters.empty());
  };
  expect_frame(framed);
  // Before cases had a frame, the unit and the shift were four parameters.
  nlohmann::json older = own;
  const auto& shift = framed["frame"]["shift"];
  older["parameters"] = {{"parameter0", framed["frame"]["unit"]},
                         {"parameter1", shift[0]},
                         {"parameter2", shift[1]},
                         {"parameter3", shift[2]}};
  expect_frame(older);
  // A cage's sum of one formula has the formula's name, and still no parameters by name.
  older["kind"] = std::ranges::find_if(catalogue(), [](const Formula& f) { return !f.parameters.empty(); })->name;
  expect_frame(older);
  const auto complaint = [&](const nlohmann::json& frame) {
    nlohmann::json line = framed;
    line["frame"] = frame;
    return message_of(write(line.dump()));
  };
  EXPECT_NE(complaint(1).find("\"frame\" is not an object"), std::string::npos);
  EXPECT_NE(complaint({{"unit", 0}, {"shift", {0, 0, 0}}}).find("\"frame\" has a unit"), std::string::npos);
  EXPECT_NE(complaint({{"unit", 1}, {"shift", {0, 0}}}).find("three coordinates"), std::string::npos);
  EXPECT_NE(complaint({{"unit", 1}, {"shift", {0, 0, 0}}, {"turn", 1}}).find("\"frame\" is not an object"),
            std::string::npos);
}

TEST_F(WorstFile, SaysWhatTheCageOfAFileWas) {
  RunResult run = sample_run(1, 1);
  run.rows.resize(1);
  run.rows[0].section = RowKey::Section::Cage;
  run.rows[0].worst.resize(1);
  EXPECT_EQ(read_worst(write(worst_lines(run)))[0].cage_content, "");
  run.settings["cage"] = run.rows[0].setting;
  run.settings[cage_content_setting] = "0123456789abcdef";
  EXPECT_EQ(read_worst(write(worst_lines(run)))[0].cage_content, "0123456789abcdef");
  // Elements have none, and neither have other cages.
  run.rows[0].section = RowKey::Section::Element;
  EXPECT_EQ(read_worst(write(worst_lines(run)))[0].cage_content, "");
  run.rows[0].section = RowKey::Section::Cage;
  run.rows[0].setting = "another";
  EXPECT_EQ(read_worst(write(worst_lines(run)))[0].cage_content, "");
}

TEST_F(WorstFile, TheFurthestEntryIsWrittenWhereATensorWasCompared) {
  RunResult run = sample_run(1, 1);
  run.rows.resize(1);
  run.rows[0].worst.resize(1);
  EXPECT_FALSE(nlohmann::json::parse(worst_lines(run)).contains("furthest"));
  run.rows[0].worst[0].relative = 0.125;
  run.rows[0].worst[0].furthest = {4, HUGE_VAL, "2.5000000000000000001e-01"};
  const nlohmann::json line = nlohmann::json::parse(worst_lines(run));
  EXPECT_EQ(line["relative"], 0.125);
  EXPECT_EQ(line["furthest"], (nlohmann::json{{"entry", 4}, {"found", "inf"}, {"truth", "2.5000000000000000001e-01"}}));
}

TEST_F(WorstFile, WhatALineDoesNotSayIsEmpty) {
  RunResult run = sample_run(1, 1);
  run.settings.erase("triangulation");
  const std::string text = worst_lines(run), first = text.substr(0, text.find('\n'));
  for (const char* key : {"triangulation", "provenance", "asked", "frame"})
    EXPECT_FALSE(nlohmann::json::parse(first).contains(key)) << key;
  const WorstLine line = read_worst(write("\n \r\n" + first))[0];
  EXPECT_EQ(line.triangulation, "");
  EXPECT_EQ(line.provenance, "");
  EXPECT_EQ(line.worst.asked, 2);
  EXPECT_EQ(line.number, 3) << "blank lines count";
  EXPECT_EQ(worst_line(line), first);
}

TEST_F(WorstFile, RowsWithoutWorstCasesAreLeftOut) {
  RunResult run = sample_run(1, 1);
  for (ResultRow& row : run.rows) row.worst.clear();
  EXPECT_EQ(worst_lines(run), "");
  EXPECT_NE(message_of(write("")).find("holds no worst cases"), std::string::npos);
}

TEST_F(WorstFile, BadLinesAreNamed) {
  RunResult run = sample_run(1, 1);
  run.rows.resize(1);
  run.rows[0].worst.resize(1);
  const nlohmann::json good = nlohmann::json::parse(worst_lines(run));
  const auto complaint = [&](const std::string& line) { return message_of(write(good.dump() + "\n\n" + line + "\n")); };
  const auto expect = [&](const std::string& line, const std::string& reason) {
    const std::string message = complaint(line);
    EXPECT_NE(message.find("worst.jsonl:3: "), std::string::npos) << message;
    EXPECT_NE(message.find(reason), std::string::npos) << message;
    EXPECT_EQ(message.find('\n'), std::string::npos) << message;
  };
  expect("{\"formula\":", "malformed JSON at column");
  expect("{\"order\": 1e999}", "number out of range");
  expect("[1, 2]", "not a JSON object");
  for (const auto& [key, value] : good.items()) {
    if (key == "triangulation") continue;
    nlohmann::json bad = good;
    bad.erase(key);
    expect(bad.dump(), fmt::format("missing key \"{}\"", key));
  }
  const auto changed = [&](const char* key, const nlohmann::json& value) {
    nlohmann::json bad = good;
    bad[key] = value;
    return bad.dump();
  };
  expect(changed("point", {"0x1p+0", "0x1p+0"}), "\"point\" is not made of three coordinates");
  expect(changed("point", {"0x1p+0", "one", "0x1p+0"}), "\"point\" holds \"one\", which is no number");
  expect(changed("element", {{"0x1p+0", nullptr, "0x1p+0"}, {1, 2, 3}}), "\"element\" holds null");
  expect(changed("element", {{1, 2, 3}}), "two, three or four corners");
  expect(changed("order", 3), "\"order\" is not 0, 1 or 2");
  expect(changed("order", -1), "\"order\" is not a count");
  expect(changed("error", "big"), "\"error\" is not a number");
  expect(changed("sample", 1.5), "\"sample\" is not a count");
  expect(changed("flags", "near-edge"), "\"flags\" is not an array");
  expect(changed("flags", {1}), "\"flags\" holds something that is not a string");
  expect(changed("scalar", 64), "\"scalar\" is not a string");
  expect(changed("parameters", 1), "\"parameters\" is not an object");
  expect(changed("ordre", 1), R"(unknown key "ordre"; did you mean "order"? known: formula, evaluation)");
  expect(changed("kind", "green"), "unknown key \"formula\"");
  expect(changed("triangulation", "fann"), "unknown triangulation 'fann'");
  EXPECT_EQ(complaint(good.dump()), "");
  EXPECT_NE(message_of(scratch_.path() / "missing.jsonl").find("missing.jsonl: No such file"), std::string::npos);
  EXPECT_NE(message_of(scratch_.path()).find("Is a directory"), std::string::npos);
}

}  // namespace
}  // namespace cageproof::reports::worst_file_test
