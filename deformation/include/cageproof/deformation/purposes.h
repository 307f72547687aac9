// SPDX-License-Identifier: MIT
// The purpose of each deformer: one line of the catalogue, which lists and manuals show.
#pragma once

#include <string_view>

namespace cageproof::deformation {

/// The line of a method, of posed cages or of constraints, without a full stop; empty for methods that the project does
/// not have.
std::string_view purpose_of_method(std::string_view method);

}  // namespace cageproof::deformation
