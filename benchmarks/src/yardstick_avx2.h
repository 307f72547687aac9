// SPDX-License-Identifier: MIT
// The yardstick's functions; their source is compiled for AVX2. Only plain data, as gauss_kernels.h says.
#pragma once

namespace cageproof::benchmarks {

/// Whether yardstick_values may be called: the program and the processor have AVX2 and FMA.
bool has_yardstick();

/// The transcendental functions of a block of pairs.
/// \param count of pairs, a multiple of 8 \param y, x one number per pair, of the arc tangents atan2(y, x) \param
/// arguments of the logarithms, three per two pairs, 3/2 count in all \param angles, logarithms results
/// \pre has_yardstick()
void yardstick_values(int count, const double* y, const double* x, const double* arguments, double* angles,
                      double* logarithms);

}  // namespace cageproof::benchmarks
