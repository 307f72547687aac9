// SPDX-License-Identifier: MIT
// Formulas' rows say what is true of their kernels.
#include "support.h"

#include "cageproof/core/catalogue/evaluation.h"
#include "cageproof/core/catalogue/formula.h"

namespace cageproof::quadrature_ref {
namespace {

std::vector<Vec3<Mp50>> flat_element(ElementKind kind) {
  const auto at = [](double x, double y, double z) { return Vec3<Mp50>(x, y, z); };
  if (kind == ElementKind::Segment) return {at(0, 0, 0), at(2, 1, 0)};
  if (kind == ElementKind::Triangle) return {at(0, 0, 0), at(2, 0, 1), at(0, 1, 2)};
  return {at(0, 0, 0), at(2, 0, 1), at(2, 1, 3), at(0, 1, 2)};
}

// Beyond the element, in its plane or on its line.
Vec3<Mp50> in_plane_point(ElementKind kind) {
  return kind == ElementKind::Segment ? Vec3<Mp50>(6, 3, 0) : Vec3<Mp50>(6, 2, 7);
}

TEST(FormulaRows, say_what_vanishes_in_the_plane) {
  int vanishing = 0, others = 0;
  for (const Formula& formula : catalogue()) {
    const auto integral = EvaluationRegister::instance().with_role(formula.name, Role::Integral);
    if (!integral) continue;
    const auto corners = flat_element(formula.element);
    std::vector<Mp50> parameters;
    parameters.reserve(formula.parameters.size());
    for (const Parameter& parameter : formula.parameters) parameters.emplace_back(parameter.preset);
    Result<Mp50> found;
    (*integral)(Query<Mp50>{corners, in_plane_point(formula.element), 0, parameters}, found);
    Mp50 largest = 0;
    for (const Mp50& x : found.value) largest = std::max<Mp50>(largest, abs(x));
    EXPECT_EQ(largest < Mp50("1e-40"), formula.vanishes_in_plane) << formula.name << ' ' << largest;
    ++(formula.vanishes_in_plane ? vanishing : others);
  }
  EXPECT_GE(vanishing, 13);
  EXPECT_GE(others, 13);
}

}  // namespace
}  // namespace cageproof::quadrature_ref
