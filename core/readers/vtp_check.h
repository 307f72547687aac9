// SPDX-License-Identifier: MIT
#pragma once

#include "cage/mesh_files.h"

namespace cageproof::mesh_files {

/// Checks that compressed arrays of a VTP file state no more blocks, and no more bytes in them, than the file can hold,
/// and that offsets written as text end no cell beyond.
/// \throws InputError when one does
void check_blocks(std::string_view file, const FileLine& at);

}  // namespace cageproof::mesh_files
