// SPDX-License-Identifier: MIT
#pragma once

#include "cage/mesh_files.h"

namespace cageproof::mesh_files {

/// Checks that all arrays of a VTP file are there, that none states or unpacks to more than the file can hold, and that
/// offsets end no cell beyond. Reads text, base64 and raw bytes, compressed or not.
/// \throws InputError where not
void check_arrays(std::string_view file, const FileLine& at);

}  // namespace cageproof::mesh_files
