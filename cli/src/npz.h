// SPDX-License-Identifier: MIT
// NumPy's .npz: named arrays in one ZIP file.
#pragma once

#include <string>
#include <utility>
#include <vector>

namespace cageproof::cli {

/// A ZIP file of these members, name and bytes, in their order, not compressed, as numpy.savez writes it. The same
/// members give the same bytes. \throws std::runtime_error with libarchive's reason
std::string zip_text(const std::vector<std::pair<std::string, std::string>>& members);

}  // namespace cageproof::cli
