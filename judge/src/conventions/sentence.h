// SPDX-License-Identifier: MIT
// A convention in one sentence.
#pragma once

#include "cageproof/judge/convention.h"

namespace cageproof::judge {

/// "yours is ours times -1/(4 pi), with corners in the order 2, 3, 1".
std::string sentence_of(const Convention& convention, const Formula& registered_for);

}  // namespace cageproof::judge
