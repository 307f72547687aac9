// SPDX-License-Identifier: MIT
// The catalogue of defects is complete, in order, and each row's page exists.
#include "cageproof/judge/verdict.h"

#include "cageproof/core/input_error.h"
#include "defects/signatures.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <fstream>
#include <set>
#include <sstream>

namespace cageproof::judge {
namespace {

std::string page(std::string_view name) {
  std::ifstream file(std::string(CAGEPROOF_DOCS) + "/" + std::string(name));
  std::ostringstream text;
  text << file.rdbuf();
  return text.str();
}

// GitHub's anchor of a heading.
std::string anchor_of(const std::string& heading) {
  std::string anchor;
  for (const char c : heading.substr(heading.find(' ') + 1))
    if (std::isalnum(static_cast<unsigned char>(c)) || c == '_' || c == '-')
      anchor += static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
    else if (c == ' ') anchor += '-';
  return anchor;
}

std::set<std::string> anchors_of(std::string_view name) {
  std::istringstream text(page(name));
  std::set<std::string> anchors;
  for (std::string line; std::getline(text, line);)
    if (line.starts_with("#")) anchors.insert(anchor_of(line.substr(line.find_last_of('#', line.find(' ')))));
  return anchors;
}

TEST(defect_table, every_row_has_a_paragraph_and_a_page_that_exists) {
  const auto paragraphs = anchors_of("defects.md");
  for (const Defect& defect : defects()) {
    EXPECT_TRUE(paragraphs.contains(std::string(defect.key))) << defect.key;
    const auto hash = defect.page.find('#');
    ASSERT_NE(hash, std::string_view::npos) << defect.key;
    const std::string anchor(defect.page.substr(hash + 1));
    EXPECT_TRUE(anchors_of(defect.page.substr(0, hash)).contains(anchor)) << defect.page;
    EXPECT_TRUE(defect.sentence.ends_with('.')) << defect.sentence;
  }
}

TEST(defect_table, signatures_are_tried_in_its_order_and_the_last_explains_all) {
  std::size_t before = 0;
  for (const Signature& signature : signatures()) {
    const auto place = static_cast<std::size_t>(&defect_named(signature.key) - defects().data());
    EXPECT_GE(place, before) << signature.key;
    before = place;
  }
  EXPECT_EQ(signatures().back().key, defects().back().key);
  EXPECT_THROW(defect_named("nothing"), InputError);
}

}  // namespace
}  // namespace cageproof::judge
