// SPDX-License-Identifier: MIT
// The instruction sets that kernels are compiled for, and the one to use.
#pragma once

#include "tables.h"

namespace cageproof::adaptive_qmvc::batch {

/// The kernels for closed_form::batch::instruction_set(). \throws InputError as that does
const Kernels& kernels();

#if defined(__x86_64__)
extern const Kernels kernels_avx512, kernels_avx2;
#endif
extern const Kernels kernels_plain;

}  // namespace cageproof::adaptive_qmvc::batch
