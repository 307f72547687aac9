// SPDX-License-Identifier: MIT
// Texts of files, which the build puts into a source.
#pragma once

#include <string_view>

namespace cageproof::judge {

extern const std::string_view embedded_cageproof_judge_h, embedded_mine_c, embedded_mine_cpp, embedded_mine_py,
    embedded_mine_cage_py;

}  // namespace cageproof::judge
