// SPDX-License-Identifier: MIT
#include "line_form.h"

CAGEPROOF_LINE_WEIGHTS(cageproof::Mp50)
