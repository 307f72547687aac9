// SPDX-License-Identifier: MIT
#pragma once

#include "cageproof/core/cage/cage.h"
#include "cageproof/validation/replay.h"

namespace cageproof::validation {

/// The cage that a stored case names, with that name: an embedded one, or a file's. A relative path is looked for in
/// the current folder, then in the stored ones; the first cage with the stored content counts, or where no content is
/// stored, the first.
/// \throws InputError as read_cage; when no file is there, naming all places; when none has the stored content
Cage stored_cage(const std::string& name, const StoredFacts& stored);

}  // namespace cageproof::validation
