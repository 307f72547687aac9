// SPDX-License-Identifier: MIT
// The purpose of each kind of coordinates: one line of the catalogue, which lists and manuals show.
#pragma once

#include <string_view>

namespace cageproof {

/// The line of a kind, without a full stop; empty for kinds that the project does not have.
std::string_view purpose_of_kind(std::string_view kind);

}  // namespace cageproof
