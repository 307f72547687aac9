// SPDX-License-Identifier: MIT
#include "cageproof/closed_form/batch/instruction_set.h"

#include "cluster_kernels.h"
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

const ClusterKernels& cluster_kernels_of([[maybe_unused]] InstructionSet set) {
#if defined(__x86_64__)
  if (set == InstructionSet::Avx512) return cluster_kernels_avx512;
  if (set == InstructionSet::Avx2) return cluster_kernels_avx2;
#endif
  return cluster_kernels_plain;
}

}  // namespace

const ClusterKernels& cluster_kernels() {
  static const ClusterKernels& found = cluster_kernels_of(instruction_set());
  return found;
}

const Kernels& kernels() {
  static const Kernels& found = kernels_of(instruction_set());
  return found;
}

}  // namespace cageproof::closed_form::batch
