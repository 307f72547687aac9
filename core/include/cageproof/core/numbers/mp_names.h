// SPDX-License-Identifier: MIT
// The names of the multiprecision numbers, for code that is generic over scalars and needs no MPFR.
#pragma once

namespace cageproof {

template <unsigned Digits>
class Mp;
template <unsigned Digits>
struct MpConstants;

using Mp50 = Mp<50>;
using Mp100 = Mp<100>;
using Mp200 = Mp<200>;
/// No formula's scalar: what holds 200 digits where half of the digits cancel.
using Mp400 = Mp<400>;
/// No formula's scalar: it holds differences and products of doubles whose exponents are the furthest apart.
using Mp800 = Mp<800>;
/// No formula's scalar: it holds a sum of a number of ordinary size and one of size 5e-324^-3.
using Mp2000 = Mp<2000>;

}  // namespace cageproof
