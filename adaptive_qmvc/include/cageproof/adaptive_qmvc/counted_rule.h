// SPDX-License-Identifier: MIT
// Gauss-Legendre rules in numbers that count: rounded nodes and weights, compared with those of 200 digits.
#pragma once

#include "cageproof/closed_form/arithmetic/counted.h"
#include "cageproof/core/numbers/gauss_legendre.h"

template <>
const cageproof::GaussLegendre<cageproof::closed_form::Counted>&
cageproof::gauss_legendre<cageproof::closed_form::Counted>(int n);
