// SPDX-License-Identifier: MIT
#include "kernels.h"

#include "cageproof/closed_form/batch/instruction_set.h"

namespace cageproof::adaptive_qmvc::batch {

const Kernels& kernels() {
#if defined(__x86_64__)
  using closed_form::batch::InstructionSet;
  if (closed_form::batch::instruction_set() == InstructionSet::Avx512) return kernels_avx512;
  if (closed_form::batch::instruction_set() == InstructionSet::Avx2) return kernels_avx2;
#endif
  return kernels_plain;
}

}  // namespace cageproof::adaptive_qmvc::batch
