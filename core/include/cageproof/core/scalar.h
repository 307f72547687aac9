// SPDX-License-Identifier: MIT
// The scalar types every formula is generic over.
#pragma once

#include "cageproof/core/mp.h"
#include "cageproof/core/scalar_names.h"
