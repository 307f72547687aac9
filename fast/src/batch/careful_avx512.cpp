// SPDX-License-Identifier: MIT
#include "careful_entries.h"

#if defined(__AVX512F__)
#include "careful_sums.h"

#endif
