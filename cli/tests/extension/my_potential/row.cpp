// SPDX-License-Identifier: MIT
// A formula from outside the catalogue's file, first of its three edits: the row.
#include "cageproof/core/catalogue/formula.h"

namespace cageproof {
namespace {

const RegisterFormula registered{{.name = "triangle.my_potential",
                                  .symbol = "m_t",
                                  .source = "docs/adding_a_formula.md",
                                  .definition = "int_t 1/r",
                                  .element = ElementKind::Triangle,
                                  .shape = {},
                                  .degree = 1,
                                  .flip_sign = 1,
                                  .laplacian = {Laplacian::Kind::Zero},
                                  .face_jump = {},
                                  .parameters = {}}};

}  // namespace
}  // namespace cageproof
