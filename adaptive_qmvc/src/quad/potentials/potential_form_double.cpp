// SPDX-License-Identifier: MIT
#include "potential_form_body.h"

CAGEPROOF_POTENTIAL_FORM(double)
CAGEPROOF_SUM_OF_RULES(double)
CAGEPROOF_SUM_OF_RULES(long double)
