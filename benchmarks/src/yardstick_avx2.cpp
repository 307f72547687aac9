// SPDX-License-Identifier: MIT
#include "yardstick_avx2.h"

#if defined(__AVX2__)
#include <immintrin.h>
#include <sleef.h>
#endif

namespace cageproof::benchmarks {

#if defined(__AVX2__)

bool has_yardstick() { return __builtin_cpu_supports("avx2") && __builtin_cpu_supports("fma"); }

void yardstick_values(int count, const double* y, const double* x, const double* arguments, double* angles,
                      double* logarithms) {
  for (int i = 0; i < count; i += 4)
    _mm256_storeu_pd(angles + i, Sleef_atan2d4_u10avx2(_mm256_loadu_pd(y + i), _mm256_loadu_pd(x + i)));
  for (int i = 0; i < count / 2 * 3; i += 4)
    _mm256_storeu_pd(logarithms + i, Sleef_logd4_u10avx2(_mm256_loadu_pd(arguments + i)));
}

#else

bool has_yardstick() { return false; }
void yardstick_values(int, const double*, const double*, const double*, double*, double*) {}

#endif

}  // namespace cageproof::benchmarks
