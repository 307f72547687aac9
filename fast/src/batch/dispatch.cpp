// SPDX-License-Identifier: MIT
#include "cageproof/closed_form/batch/instruction_set.h"

#include "kernels.h"

namespace cageproof::closed_form::batch {
namespace {

const Kernels& kernels_of([[maybe_unused]] InstructionSet set) {
#if defined(__x86_64__)
  if (set == InstructionSet::Avx512) return kernels_avx512;
  if (set == InstructionSet::Avx2) return kernels_avx2;
#endif
  return kernels_plain;
}

}  // namespace

const Kernels& kernels() {
  static const Kernels& found = kernels_of(instruction_set());
  return found;
}

}  // namespace cageproof::closed_form::batch
