// SPDX-License-Identifier: MIT
#include "potential_form.h"

CAGEPROOF_POTENTIAL_FORM(cageproof::Mp100)
