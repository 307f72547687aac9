// SPDX-License-Identifier: MIT
// The scalar types every formula is generic over.
#pragma once

#include "cageproof/core/numbers/mp.h"
#include "cageproof/core/numbers/scalar_names.h"
