// SPDX-License-Identifier: MIT
#include "cageproof/cageproof.h"

namespace cageproof::library {

std::string version() { return CAGEPROOF_VERSION; }

}  // namespace cageproof::library
