// SPDX-License-Identifier: MIT
#include "page/script_json.h"

#include <gtest/gtest.h>

namespace cageproof::reports {
namespace {

TEST(script_json, ends_no_script_element_and_says_the_same) {
  const Json json = {{"name", "</script><b>"}, {"less", "a < b"}};
  const std::string text = script_json(json);
  EXPECT_EQ(text.find('<'), std::string::npos) << text;
  EXPECT_EQ(Json::parse(text), json);
}

}  // namespace
}  // namespace cageproof::reports
