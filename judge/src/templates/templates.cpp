// SPDX-License-Identifier: MIT
#include "cageproof/judge/templates.h"

#include "templates/embedded.h"

namespace cageproof::judge {

const std::vector<std::string_view>& template_languages() {
  static const std::vector<std::string_view> all{"c", "cpp", "python", "python-cage"};
  return all;
}

std::vector<std::pair<std::string_view, std::string_view>> template_files(std::string_view language) {
  if (language == "python") return {{"mine.py", embedded_mine_py}};
  if (language == "python-cage") return {{"mine_cage.py", embedded_mine_cage_py}};
  const std::pair<std::string_view, std::string_view> header{"cageproof_judge.h", embedded_cageproof_judge_h};
  if (language == "c") return {header, {"mine.c", embedded_mine_c}};
  return {header, {"mine.cpp", embedded_mine_cpp}};
}

}  // namespace cageproof::judge
