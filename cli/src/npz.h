// SPDX-License-Identifier: MIT
// NumPy's .npz: named arrays in one ZIP file.
#pragma once

#include <cstddef>
#include <functional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace cageproof::cli {

/// The header of a .npy, which stands before the numbers, row by row. \param type as NumPy writes it: "<f8"
std::string npy_header(std::string_view type, const std::vector<std::size_t>& shape);

/// A file within a ZIP file: its name, and its bytes one piece after the other.
struct ZipMember {
  std::string name;
  std::vector<std::string_view> pieces;
};

/// Makes a ZIP file of these members, in their order, not compressed, as numpy.savez writes it. The same members give
/// the same bytes. \param take gets the file's bytes as they are made
/// \throws std::runtime_error with libarchive's reason; what `take` throws
void write_zip(const std::vector<ZipMember>& members, const std::function<void(std::string_view)>& take);

/// The same as one text, of members by name and bytes.
std::string zip_text(const std::vector<std::pair<std::string, std::string>>& members);

}  // namespace cageproof::cli
