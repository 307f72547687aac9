// SPDX-License-Identifier: MIT
#include "kernels.h"

#include <cstdlib>
#include <string_view>

namespace cageproof::closed_form::batch {
namespace {

const Kernels& widest_of_machine() {
  const char* const text = std::getenv("CAGEPROOF_SIMD");
  const std::string_view named = text == nullptr ? "" : text;
#if defined(__x86_64__)
  const bool avx512 = __builtin_cpu_supports("avx512f") && __builtin_cpu_supports("avx512dq") &&
                      __builtin_cpu_supports("avx512vl") && __builtin_cpu_supports("fma");
  const bool avx2 = __builtin_cpu_supports("avx2") && __builtin_cpu_supports("fma");
  if (avx512 && named != "avx2" && named != "plain") return kernels_avx512;
  if (avx2 && named != "plain") return kernels_avx2;
#endif
  return kernels_plain;
}

}  // namespace

const Kernels& kernels() {
  static const Kernels& found = widest_of_machine();
  return found;
}

}  // namespace cageproof::closed_form::batch
