// SPDX-License-Identifier: MIT
// psi^k = int -Gamma_k G1, [T24] Eq 43: the single layer's kernel, in rows with one tensor per corner.
#include "green_function.h"

namespace cageproof::quadrature_ref {
namespace {

const RegisterKernel register_affine_single_layer{"affine_single_layer", scalar_kernels<NegativeGreenFunction, 2, 3>()};

}  // namespace
}  // namespace cageproof::quadrature_ref
