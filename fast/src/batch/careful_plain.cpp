// SPDX-License-Identifier: MIT
#include "careful_entries.h"

#include "careful_sums.h"
