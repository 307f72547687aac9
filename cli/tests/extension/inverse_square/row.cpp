// SPDX-License-Identifier: MIT
// A formula without a closed form has its row and its kernel; its truth is then the integral.
#include "cageproof/core/catalogue/formula.h"

namespace cageproof {
namespace {

const RegisterFormula registered{{.name = "triangle.inverse_square",
                                  .symbol = "s_t",
                                  .source = "docs/adding_a_formula.md",
                                  .definition = "int_t 1/r^2",
                                  .element = ElementKind::Triangle,
                                  .shape = {},
                                  .degree = 0,
                                  .flip_sign = 1,
                                  .laplacian = {},
                                  .face_jump = {.diverges = true},
                                  .parameters = {}}};

}  // namespace
}  // namespace cageproof
