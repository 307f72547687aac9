// SPDX-License-Identifier: MIT
// The instruction sets that kernels are compiled for, and the one to use.
#pragma once

#include "cageproof/closed_form/batch/tables.h"

namespace cageproof::closed_form::batch {

/// The kernels for instruction_set(). \throws InputError as that does
const Kernels& kernels();

#if defined(__x86_64__)
extern const Kernels kernels_avx512, kernels_avx2;
#endif
extern const Kernels kernels_plain;

}  // namespace cageproof::closed_form::batch
