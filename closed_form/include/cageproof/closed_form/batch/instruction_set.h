// SPDX-License-Identifier: MIT
// The instruction sets that vectors of points are compiled for (lanes.h), and the one to use.
#pragma once

#include <string_view>

namespace cageproof::closed_form::batch {

/// Instruction sets, the narrowest first; a machine that has one has all before it.
enum class InstructionSet { Plain, Avx2, Avx512 };

/// "plain", "avx2", "avx512".
std::string_view name_of(InstructionSet set);

/// The set that a name means on a machine whose widest set is known; that one where the name is empty.
/// \throws InputError for another name than plain, avx2 and avx512, and for a set that the machine lacks
InstructionSet named_instruction_set(std::string_view name, InstructionSet widest);

/// The set that the environment variable CAGEPROOF_SIMD names, or the widest of this machine where it is not set.
/// \throws InputError as above
InstructionSet instruction_set();

}  // namespace cageproof::closed_form::batch
