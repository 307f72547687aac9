// SPDX-License-Identifier: MIT
// psi = int -G1, [T24] Eq 3, [W12] Section 3.
#include "green_function.h"

namespace cageproof::quadrature_ref {
namespace {

const RegisterKernel register_single_layer{"single_layer", scalar_kernels<NegativeGreenFunction, 2, 3>()};

}  // namespace
}  // namespace cageproof::quadrature_ref
