// SPDX-License-Identifier: MIT
// The instruction sets that vectors of points are compiled for (lanes.h), and the one to use.
#pragma once

namespace cageproof::closed_form::batch {

enum class InstructionSet { Plain, Avx2, Avx512 };

/// The widest instruction set that this machine has, or the one that the environment variable CAGEPROOF_SIMD names
/// (plain, avx2, avx512) where the machine has that.
InstructionSet instruction_set();

}  // namespace cageproof::closed_form::batch
