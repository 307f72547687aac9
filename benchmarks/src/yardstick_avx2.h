// SPDX-License-Identifier: MIT
// The yardstick's functions, of which the source is compiled for AVX2. Plain data alone, as gauss_kernels.h says.
#pragma once

namespace cageproof::benchmarks {

/// Whether yardstick_values may be called: the program and the processor have AVX2 and FMA.
bool has_yardstick();

/// The transcendental functions of a block of pairs.
/// \param count of pairs, a multiple of 8 \param y, x one number a pair, of the arc tangents atan2(y, x)
/// \param arguments three numbers for two pairs, of the logarithms, in all 3/2 count \param angles, logarithms results
/// \pre has_yardstick()
void yardstick_values(int count, const double* y, const double* x, const double* arguments, double* angles,
                      double* logarithms);

}  // namespace cageproof::benchmarks
