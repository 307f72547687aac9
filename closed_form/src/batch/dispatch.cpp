// SPDX-License-Identifier: MIT
#include "cageproof/closed_form/batch/instruction_set.h"

#include "kernels.h"

#include <cstdlib>
#include <string_view>

namespace cageproof::closed_form::batch {
namespace {

InstructionSet widest_of_machine() {
#if defined(__x86_64__)
  const char* const text = std::getenv("CAGEPROOF_SIMD");
  const std::string_view named = text == nullptr ? "" : text;
  const bool avx512 = __builtin_cpu_supports("avx512f") && __builtin_cpu_supports("avx512dq") &&
                      __builtin_cpu_supports("avx512vl") && __builtin_cpu_supports("fma");
  const bool avx2 = __builtin_cpu_supports("avx2") && __builtin_cpu_supports("fma");
  if (avx512 && named != "avx2" && named != "plain") return InstructionSet::Avx512;
  if (avx2 && named != "plain") return InstructionSet::Avx2;
#endif
  return InstructionSet::Plain;
}

const Kernels& kernels_of([[maybe_unused]] InstructionSet set) {
#if defined(__x86_64__)
  if (set == InstructionSet::Avx512) return kernels_avx512;
  if (set == InstructionSet::Avx2) return kernels_avx2;
#endif
  return kernels_plain;
}

}  // namespace

InstructionSet instruction_set() {
  static const InstructionSet found = widest_of_machine();
  return found;
}

const Kernels& kernels() {
  static const Kernels& found = kernels_of(instruction_set());
  return found;
}

}  // namespace cageproof::closed_form::batch
