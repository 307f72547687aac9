// SPDX-License-Identifier: MIT
// An array of a VTP file in binary form, as it is stored: raw bytes or base64, compressed or not.
#pragma once

#include "cage/mesh_files.h"

#include <string>
#include <string_view>

namespace cageproof::mesh_files {

/// How a VTP file stores its binary arrays.
struct VtpStorage {
  std::string compressor;  ///< the name of VTK's class; empty for none
  bool is_big = false;     ///< byte order
  std::size_t width = 4;   ///< bytes of a number that states a size
};

/// One array, from its first byte on.
struct VtpArray {
  std::string_view from;  ///< to the end of what there is
  bool is_raw = false;    ///< bytes; base64 otherwise
  std::string type;       ///< "Int64", "Float32" ...
  bool is_offsets = false;
};

/// Checks that the array is all there, that what it unpacks to is no more than a file of `file_size` bytes can hold,
/// and that offsets end no cell beyond. \throws InputError where not
void check_array(const VtpArray& array, const VtpStorage& storage, std::size_t file_size, const FileLine& at);

/// Fails where the end of a cell, in the array of all cells' vertices, is more than the file can hold. VTK makes room
/// for so many before it looks at what there is.
void check_end_of_cell(double entry, double most, std::size_t file_size, const FileLine& at);

}  // namespace cageproof::mesh_files
