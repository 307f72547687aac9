// SPDX-License-Identifier: MIT
#include "constraint_rows.h"

#include "../constraint_checks.h"

#include "cageproof/core/input_error.h"
#include "cageproof/deformation/stress.h"

#include <fmt/format.h>

#include <cmath>

namespace cageproof::deformation {
namespace {

void check_weight(const char* name, double weight) {
  if (!std::isfinite(weight) || weight < 0)
    throw InputError(fmt::format("{} = {}: a weight must be finite and at least 0", name, weight));
}

// One row per point and derivative, from `first` on, for each component that is not served alike.
template <Scalar R>
void put_rows(const CageCoordinates& coordinates, const std::string& name, const std::vector<Vec3<double>>& points,
              int order, const R& root, Eigen::Index first, ConstraintRows<R>& rows) {
  if (points.empty()) return;
  const int d = coordinates.dimension();
  const auto width = static_cast<Eigen::Index>(derivative_count(d, order));
  std::vector<Vec3<R>> at;
  at.reserve(points.size());
  for (const Vec3<double>& p : points) at.push_back(convert<R>(p));
  const auto tables = coordinates.at<R>(at, order);
  check_inside(name, points, tables[0], d);
  for (std::size_t p = 0; p < points.size(); ++p) {
    const Eigen::Index row = (first + static_cast<Eigen::Index>(p) * width) * rows.components;
    Eigen::Index column = 0;
    for (const CoordinateTable<R>& table : tables) {
      const R* from = &table.tensors[order][p * table.stride[order]];
      const R* const end = from + table.stride[order];
      for (; from != end; column += rows.components)
        for (int r = 0; r < rows.components; ++r)
          for (int c = 0; c < rows.components; ++c)
            for (Eigen::Index i = 0; i < width; ++i)
              rows.matrix(row + i * rows.components + r, column + c) = root * *from++;
    }
    if (!rows.matrix.middleRows(row, width * rows.components).allFinite())
      throw ConstraintError(
          fmt::format("{}[{}] at {} is on the cage, where the coordinates have no derivatives of order {}", name, p,
                      place_text(points[p], d), order));
  }
}

template <Scalar R>
Eigen::Matrix<R, Eigen::Dynamic, 1> units_of(const CageCoordinates& coordinates, double size) {
  const R h(size);
  const std::array<R, 4> of_blocks{h, R(1), R(1 / h), R(1 / h / h)};
  Eigen::Index count = 0;
  for (const CoordinateBlock& block : coordinates.blocks()) count += block.size;
  Eigen::Matrix<R, Eigen::Dynamic, 1> units(count);
  Eigen::Index first = 0;
  for (std::size_t b = 0; b < coordinates.blocks().size(); ++b) {
    units.segment(first, coordinates.blocks()[b].size).setConstant(of_blocks[b]);
    first += coordinates.blocks()[b].size;
  }
  return units;
}

std::vector<Vec3<double>> places_of(const auto& constraints) {
  std::vector<Vec3<double>> points;
  points.reserve(constraints.size());
  for (const auto& constraint : constraints) points.push_back(constraint.at);
  return points;
}

}  // namespace

void check_constraints(const Constraints& constraints, const VariationalOptions& options, int dimension) {
  if (options.subspace == Subspace::Elastic && !has_stress(options.nu))
    throw InputError(fmt::format("nu = {}: must be between -1 and 1/2, both excluded, or infinite", options.nu));
  check_weight("alpha", options.alpha);
  check_weight("beta", options.beta);
  check_weight("gamma", options.gamma);
  if (options.steps < 1) throw InputError(fmt::format("steps = {}: must be at least 1", options.steps));
  if (!std::isfinite(options.tolerance) || options.tolerance < 0)
    throw InputError(fmt::format("tolerance = {}: must be finite and at least 0", options.tolerance));
  if (constraints.positions.empty() && constraints.orientations.empty() && constraints.rotations.empty() &&
      constraints.hessians.empty())
    throw ConstraintError("there are no constraints");
  for (std::size_t i = 0; i < constraints.positions.size(); ++i) {
    check_finite(fmt::format("positions[{}].at", i), constraints.positions[i].at, dimension);
    check_finite(fmt::format("positions[{}].to", i), constraints.positions[i].to, dimension);
  }
  for (std::size_t i = 0; i < constraints.orientations.size(); ++i) {
    check_finite(fmt::format("orientations[{}].at", i), constraints.orientations[i].at, dimension);
    for (int c = 0; c < dimension; ++c)
      check_finite(fmt::format("orientations[{}].jacobian[{}]", i, c),
                   constraints.orientations[i].jacobian.row(c).transpose(), dimension);
  }
  for (std::size_t i = 0; i < constraints.rotations.size(); ++i)
    check_finite(fmt::format("rotations[{}]", i), constraints.rotations[i], dimension);
  for (std::size_t i = 0; i < constraints.hessians.size(); ++i)
    check_finite(fmt::format("hessians[{}]", i), constraints.hessians[i], dimension);
}

template <Scalar R>
ConstraintRows<R> constraint_rows(const CageCoordinates& coordinates, const Constraints& constraints,
                                  const VariationalOptions& options, double size) {
  using std::sqrt;
  const int d = coordinates.dimension();
  const auto count = [](const auto& list) { return static_cast<Eigen::Index>(list.size()); };
  ConstraintRows<R> rows;
  rows.units = units_of<R>(coordinates, size);
  rows.orientations = count(constraints.positions);
  rows.rotations = rows.orientations + d * count(constraints.orientations);
  rows.hessians = rows.rotations + d * count(constraints.rotations);
  rows.root_alpha = sqrt(R(options.alpha));
  rows.root_beta = sqrt(R(options.beta));
  rows.components = coordinates.blocks().front().shape.rows;
  rows.matrix.resize((rows.hessians + d * d * count(constraints.hessians)) * rows.components,
                     rows.units.size() * rows.components);
  put_rows<R>(coordinates, "positions", places_of(constraints.positions), 0, R(1), 0, rows);
  put_rows<R>(coordinates, "orientations", places_of(constraints.orientations), 1, rows.root_alpha, rows.orientations,
              rows);
  put_rows<R>(coordinates, "rotations", constraints.rotations, 1, rows.root_beta, rows.rotations, rows);
  put_rows<R>(coordinates, "hessians", constraints.hessians, 2, R(sqrt(R(options.gamma))), rows.hessians, rows);
  for (Eigen::Index k = 0; k < rows.matrix.cols(); ++k) rows.matrix.col(k) *= rows.units[k / rows.components];
  return rows;
}

template ConstraintRows<double> constraint_rows<double>(const CageCoordinates&, const Constraints&,
                                                        const VariationalOptions&, double);
template ConstraintRows<Mp50> constraint_rows<Mp50>(const CageCoordinates&, const Constraints&,
                                                    const VariationalOptions&, double);

}  // namespace cageproof::deformation
