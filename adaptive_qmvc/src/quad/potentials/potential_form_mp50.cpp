// SPDX-License-Identifier: MIT
#include "potential_form_body.h"

CAGEPROOF_POTENTIAL_FORM(cageproof::Mp50)
CAGEPROOF_SUM_OF_RULES(cageproof::Mp50)
