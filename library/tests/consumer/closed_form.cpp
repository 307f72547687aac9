// SPDX-License-Identifier: MIT
// A program that asks for formulas themselves, by the headers that take Eigen: the solid angle of an octant's triangle.
#include <cageproof/core/catalogue/evaluation.h>

#include <cmath>
#include <cstdio>
#include <numbers>

int main() {
  using namespace cageproof;
  const Evaluation evaluation = evaluation_named("triangle.solid_angle", "closed_form");
  const std::vector<Vec3<double>> corners{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
  Result<double> result;
  evaluation(Query<double>{corners, Vec3<double>(0, 0, 0), 0, {}}, result);
  std::printf("%.17g\n", result.value.at(0));
  return std::abs(std::abs(result.value[0]) - std::numbers::pi / 2) < 1e-15 ? 0 : 1;
}
