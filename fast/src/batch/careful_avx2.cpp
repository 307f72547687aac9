// SPDX-License-Identifier: MIT
#include "careful_entries.h"

#if defined(__AVX2__)
#include "careful_sums.h"

#endif
