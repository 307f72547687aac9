// SPDX-License-Identifier: MIT
// The instruction sets that kernels are compiled for, and the one to use.
#pragma once

#include "tables.h"

namespace cageproof::adaptive_qmvc::batch {

/// Of the widest instruction set that this machine has, or that CAGEPROOF_SIMD names.
const Kernels& kernels();

#if defined(__x86_64__)
extern const Kernels kernels_avx512, kernels_avx2;
#endif
extern const Kernels kernels_plain;

}  // namespace cageproof::adaptive_qmvc::batch
