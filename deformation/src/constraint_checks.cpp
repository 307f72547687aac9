// SPDX-License-Identifier: MIT
#include "constraint_checks.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <cmath>

namespace cageproof::deformation {

std::string place_text(const Vec3<double>& point, int dimension) {
  return fmt::format("({})", fmt::join(point.data(), point.data() + dimension, ", "));
}

void check_finite(const std::string& name, const Vec3<double>& point, int dimension) {
  for (int c = 0; c < dimension; ++c)
    if (!std::isfinite(point[c])) throw ConstraintError(fmt::format("{} is not finite", name));
}

template <Scalar R>
void check_inside(const std::string& name, const std::vector<Vec3<double>>& points, const CoordinateTable<R>& phi,
                  int dimension) {
  for (std::size_t p = 0; p < points.size(); ++p) {
    R sum = 0;
    for (std::size_t i = 0; i < phi.stride[0]; ++i) sum += phi.tensors[0][p * phi.stride[0] + i];
    if (!(sum > R(0.5)))
      throw ConstraintError(fmt::format("{}[{}] at {} is outside the cage", name, p, place_text(points[p], dimension)));
  }
}

std::vector<Vec3<double>> targets_of(const Constraints& constraints) {
  std::vector<Vec3<double>> targets;
  targets.reserve(constraints.positions.size());
  for (const Constraints::Position& position : constraints.positions) targets.push_back(position.to);
  return targets;
}

void check_targets(const std::vector<Vec3<double>>& targets, const Constraints& constraints, int dimension) {
  if (targets.size() != constraints.positions.size())
    throw ConstraintError(
        fmt::format("{} targets for {} positional constraints", targets.size(), constraints.positions.size()));
  for (std::size_t i = 0; i < targets.size(); ++i) check_finite(fmt::format("target {}", i), targets[i], dimension);
}

template void check_inside<double>(const std::string&, const std::vector<Vec3<double>>&, const CoordinateTable<double>&,
                                   int);
template void check_inside<Mp50>(const std::string&, const std::vector<Vec3<double>>&, const CoordinateTable<Mp50>&,
                                 int);

}  // namespace cageproof::deformation
