// SPDX-License-Identifier: MIT
// Texts of files, which the build puts into a source.
#pragma once

#include <string_view>

namespace cageproof::judge {

extern const std::string_view embedded_cageproof_judge_h, embedded_mine_c, embedded_mine_cpp, embedded_mine_py,
    embedded_mine_cage_py, embedded_formula_c_in, embedded_formula_py_in, embedded_solid_angle_c_in,
    embedded_solid_angle_py_in, embedded_cage_py_in;

}  // namespace cageproof::judge
