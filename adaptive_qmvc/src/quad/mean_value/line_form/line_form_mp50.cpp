// SPDX-License-Identifier: MIT
#include "instances.h"

CAGEPROOF_LINE_FORM(cageproof::Mp50)
CAGEPROOF_LINE_BATCH(cageproof::Mp50)
