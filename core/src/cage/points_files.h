// SPDX-License-Identifier: MIT
// Files that hold only points: text, and arrays of NumPy's.
#pragma once

#include "cageproof/core/cage/mesh_io.h"

#include <string_view>

namespace cageproof::mesh_files {

/// Whether the file is read by read_text_points: by its extension, or as it has none.
bool is_text_of_points(const std::filesystem::path& path);

/// Points of text, or of an array where a file without extension begins as one. \throws InputError as read_points
Mesh read_text_points(const std::filesystem::path& path, int dimension);

/// Reads `.npy`.
Mesh read_npy(const std::filesystem::path& path);

/// Points of an array, whole as `numpy.save` writes it: float32 or float64 of any byte order, in C or Fortran order.
/// \param name of the array in its file, for messages; may be empty
/// \throws InputError for another type or shape, a coordinate that is not finite, bytes that are missing or left over
Mesh points_of_array(std::string_view bytes, const std::filesystem::path& path, std::string_view name = "");

}  // namespace cageproof::mesh_files
