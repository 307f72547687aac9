// SPDX-License-Identifier: MIT
#include "potential_form_body.h"

CAGEPROOF_POTENTIAL_FORM(double)
CAGEPROOF_POTENTIAL_OF_SEEN(double)
CAGEPROOF_POTENTIAL_OF_SEEN(long double)
