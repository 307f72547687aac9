// SPDX-License-Identifier: MIT
#include "instances.h"

CAGEPROOF_LINE_BATCH(cageproof::Mp50)
