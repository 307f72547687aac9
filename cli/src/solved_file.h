// SPDX-License-Identifier: MIT
// Files of --solved that hold matrices, for NumPy.
#pragma once

#include "cageproof/deformation/solved_matrices.h"

namespace cageproof::cli {

/// Whether that file of --solved holds matrices: .npz.
bool holds_matrices(const std::string& file);

/// The text of an .npz of these, one array each.
std::string matrices_text(const std::vector<deformation::NamedMatrix>& matrices);

/// The same of several maps with equal sizes: arrays (maps x rows x columns).
std::string matrices_text(const std::vector<std::vector<deformation::NamedMatrix>>& maps);

}  // namespace cageproof::cli
