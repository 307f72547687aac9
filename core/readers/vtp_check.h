// SPDX-License-Identifier: MIT
#pragma once

#include "cage/mesh_files.h"

namespace cageproof::mesh_files {

/// A compressed array of a VTP file states no more blocks, and no more bytes in them, than the file can hold.
/// \throws InputError when one does
void check_blocks(std::string_view file, const FileLine& at);

}  // namespace cageproof::mesh_files
