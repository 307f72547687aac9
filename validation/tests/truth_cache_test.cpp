// SPDX-License-Identifier: MIT
// Truths kept on disk: found again exactly, made again where they are damaged or of another program, and checked.
#include "truth/truth_cache.h"

#include "cageproof/core/input_error.h"
#include "cageproof/validation/verify.h"

#include <gtest/gtest.h>

#include <cmath>
#include <fstream>
#include <limits>

namespace cageproof::validation::truth_cache_test {
namespace {

namespace fs = std::filesystem;

constexpr unsigned never = std::numeric_limits<unsigned>::max();

class TruthCacheTest : public testing::Test {
 protected:
  void SetUp() override { fs::remove_all(folder_); }
  void TearDown() override { fs::remove_all(folder_); }

  // Asks for the truth that has this number, and counts what has to be made.
  Truth ask(TruthCache& cache, double number, const std::string& question = "q") {
    return cache.get(question, [&] {
      ++made_;
      return truth(number);
    });
  }
  static Truth truth(double number) {
    Truth truth;
    truth.tensors.value = {Mp100(number) / 3, -Mp100(0), MpConstants<100>::nan()};
    truth.tensors.gradient = {MpConstants<100>::infinity(), -MpConstants<100>::infinity(), ldexp(Mp100(-1) / 7, -5000)};
    truth.exists = {true, false, true};
    truth.partial = {false, true, false};
    truth.norm = {sqrt(Mp100(2)), 0, 1};
    truth.conditioned = {sqrt(Mp100(3)), 0, 1};
    truth.on_element = true;
    return truth;
  }
  std::vector<fs::path> files() const {
    std::vector<fs::path> found;
    for (const auto& entry : fs::recursive_directory_iterator(folder_))
      if (entry.is_regular_file()) found.push_back(entry.path());
    return found;
  }
  void put(const fs::path& path, const std::string& text) { std::ofstream(path, std::ios::binary) << text; }
  std::string get(const fs::path& path) {
    std::ifstream file(path, std::ios::binary);
    return {std::istreambuf_iterator<char>(file), {}};
  }

  fs::path folder_ = fs::path(testing::TempDir()) / "truth-cache-test";
  int made_ = 0;
};

TEST_F(TruthCacheTest, keeps_every_bit) {
  const Truth before = truth(1);
  const auto after = truth_of(text_of(before));
  ASSERT_TRUE(after.has_value());
  EXPECT_EQ(text_of(*after), text_of(before));
  EXPECT_EQ(after->tensors.value[0], before.tensors.value[0]);
  EXPECT_TRUE(signbit(after->tensors.value[1]) && isnan(after->tensors.value[2]));
  EXPECT_EQ(after->tensors.gradient, before.tensors.gradient);
  EXPECT_TRUE(after->tensors.hessian.empty());
  EXPECT_EQ(after->exists, before.exists);
  EXPECT_EQ(after->required, before.required);
  EXPECT_EQ(after->partial, before.partial);
  EXPECT_EQ(after->norm, before.norm);
  EXPECT_EQ(after->conditioned, before.conditioned);
  EXPECT_TRUE(after->on_element && after->tensors.converged);
}

TEST_F(TruthCacheTest, gives_again_what_an_earlier_run_made) {
  TruthCache first(folder_, "a", never);
  ask(first, 1);
  TruthCache second(folder_, "a", never);
  EXPECT_EQ(text_of(ask(second, 2)), text_of(truth(1)));
  EXPECT_EQ(made_, 1);
  EXPECT_EQ(second.taken(), 1u);
  EXPECT_EQ(text_of(ask(second, 2, "another")), text_of(truth(2)));
  EXPECT_EQ(second.made(), 1u);
}

TEST_F(TruthCacheTest, makes_again_what_is_damaged_or_of_another_question) {
  TruthCache cache(folder_, "a", never);
  ask(cache, 1);
  ASSERT_EQ(files().size(), 1u);
  const fs::path file = files()[0];
  const std::string whole = get(file);
  std::string changed = whole;
  changed[whole.size() / 2] = changed[whole.size() / 2] == '1' ? '2' : '1';
  for (const std::string& text : {std::string(), whole.substr(0, whole.size() / 2), changed, "x" + whole}) {
    put(file, text);
    made_ = 0;
    EXPECT_EQ(text_of(ask(cache, 1)), text_of(truth(1)));
    EXPECT_EQ(made_, 1);
    EXPECT_EQ(get(file), whole);
  }
  ask(cache, 2, "another");
  for (const fs::path& path : files()) put(path, whole);
  made_ = 0;
  EXPECT_EQ(text_of(ask(cache, 2, "another")), text_of(truth(2)));
  EXPECT_EQ(made_, 1);
}

TEST_F(TruthCacheTest, takes_nothing_from_another_program) {
  TruthCache old(folder_, "a", never);
  ask(old, 1);
  TruthCache changed(folder_, "b", never);
  EXPECT_EQ(text_of(ask(changed, 2)), text_of(truth(2)));
  EXPECT_EQ(made_, 2);
}

TEST_F(TruthCacheTest, says_where_a_truth_that_is_made_again_differs) {
  TruthCache cache(folder_, "a", 1);
  ask(cache, 1);
  EXPECT_EQ(text_of(ask(cache, 1)), text_of(truth(1)));
  EXPECT_EQ(made_, 2);
  try {
    ask(cache, 2);
    FAIL();
  } catch (const InputError& error) {
    EXPECT_NE(std::string(error.what()).find(folder_.string()), std::string::npos) << error.what();
  }
}

TEST_F(TruthCacheTest, checks_a_hundredth) {
  TruthCache cache(folder_, "a");
  constexpr int all = 5000;
  for (int i = 0; i < all; ++i) ask(cache, 1, std::to_string(i));
  made_ = 0;
  for (int i = 0; i < all; ++i) ask(cache, 1, std::to_string(i));
  EXPECT_GT(made_, all / 100 / 3);
  EXPECT_LT(made_, all / 100 * 3);
}

TEST_F(TruthCacheTest, question_holds_every_bit_of_the_input) {
  const TruthSource source = truth_source(*find_formula("triangle.solid_angle"));
  Sample sample;
  sample.corners = {Vec3<double>(0, 0, 0), Vec3<double>(1, 0, 0), Vec3<double>(0, 1, 0)};
  sample.point = Vec3<double>(0.1, 0.2, 0.3);
  const std::string before = question_of(source, sample, 2);
  EXPECT_NE(question_of(source, sample, 1), before);
  EXPECT_NE(question_of(truth_source(*find_formula("triangle.single_layer")), sample, 2), before);
  sample.corners[1][2] = -0.0;
  EXPECT_NE(question_of(source, sample, 2), before);
  sample.corners[1][2] = 0;
  EXPECT_EQ(question_of(source, sample, 2), before);
  sample.point[0] = std::nextafter(0.1, 1);
  EXPECT_NE(question_of(source, sample, 2), before);
}

}  // namespace
}  // namespace cageproof::validation::truth_cache_test
