// SPDX-License-Identifier: MIT
#include "instances.h"

CAGEPROOF_RIEMANN_WEIGHTS(cageproof::Mp200)
