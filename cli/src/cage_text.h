// SPDX-License-Identifier: MIT
// An embedded cage as a file's text, to be edited and read again.
#pragma once

#include "cageproof/core/cage/cage.h"

#include <string>

namespace cageproof::cli {

/// The cage in the format of the file's name; a warning on standard error where the format cannot hold all of it.
/// \param file of which only the name is looked at
/// \throws InputError for a format that is not written, or from which no cage like this one is read
std::string cage_text(const std::string& file, const Cage& cage);

}  // namespace cageproof::cli
