// SPDX-License-Identifier: MIT
#include "entropy.h"

CAGEPROOF_MAXIMUM_ENTROPY(double)
