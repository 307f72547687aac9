// SPDX-License-Identifier: MIT
#include "cageproof/closed_form/batch/instruction_set.h"

#include "cageproof/core/input_error.h"

#include <array>
#include <cstdlib>
#include <string>

namespace cageproof::closed_form::batch {
namespace {

constexpr std::array<std::string_view, 3> set_names{"plain", "avx2", "avx512"};

InstructionSet widest_of_machine() {
#if defined(__x86_64__)
  if (__builtin_cpu_supports("avx2") && __builtin_cpu_supports("fma")) {
    const bool wider =
        __builtin_cpu_supports("avx512f") && __builtin_cpu_supports("avx512dq") && __builtin_cpu_supports("avx512vl");
    return wider ? InstructionSet::Avx512 : InstructionSet::Avx2;
  }
#endif
  return InstructionSet::Plain;
}

}  // namespace

std::string_view name_of(InstructionSet set) { return set_names[static_cast<std::size_t>(set)]; }

InstructionSet named_instruction_set(std::string_view name, InstructionSet widest) {
  if (name.empty()) return widest;
  std::string of_machine;
  for (std::size_t set = 0; set <= static_cast<std::size_t>(widest); ++set) {
    if (name == set_names[set]) return static_cast<InstructionSet>(set);
    of_machine += (set == 0 ? "" : ", ") + std::string(set_names[set]);
  }
  throw InputError("environment variable CAGEPROOF_SIMD: '" + std::string(name) +
                   "' is no instruction set of this machine, which has " + of_machine +
                   "; give one of these, or leave the variable unset for the widest");
}

InstructionSet instruction_set() {
  static const InstructionSet found = [] {
    const char* const name = std::getenv("CAGEPROOF_SIMD");
    return named_instruction_set(name == nullptr ? "" : name, widest_of_machine());
  }();
  return found;
}

}  // namespace cageproof::closed_form::batch
