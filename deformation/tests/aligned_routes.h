// SPDX-License-Identifier: MIT
// [T24] Eq 31-36 by another route: second derivatives as differences of the layers' values in 100 digits next to the
// cage, and normal equations as the paper prints them, in 50, which squaring the condition leaves enough of.
#pragma once

#include "regularised_routes.h"

namespace cageproof::deformation::test {

/// The quantities whose squares are summed: Laplacians, all second derivatives, those along the normal.
enum class Operator { Laplacian, Hessian, Normal };

/// An operator of phi, psi, phibar and psibar, rows of samples one below the other.
using OfLayers = std::array<Mp, 4>;

/// The outward unit normal of corners somewhere.
inline Vec3<Mp50> unit_normal(const std::vector<Vec3<Mp50>>& corners) {
  const Vec3<Mp50> u = corners[1] - corners[0];
  Vec3<Mp50> normal(u[1], -u[0], Mp50(0));
  if (corners.size() == 3) normal = u.cross(Vec3<Mp50>(corners[2] - corners[0]));
  return normal / Mp50(sqrt(Mp50(normal.dot(normal))));
}

/// Second derivatives of all layers at a point, [which of d^2] of [layer], as second differences of values.
inline std::vector<std::array<Mp, 4>> second_differences(const CageCoordinates& layers, const Vec3<Mp100>& point,
                                                         const Mp100& step) {
  using Values = std::vector<Result<Mp100>>;
  const int d = layers.dimension();
  const auto at = [&](int i, int j, int sign) {
    Vec3<Mp100> there = point;
    if (i >= 0) there[i] += sign * step;
    if (j >= 0) there[j] += sign * step;
    return layers.at<Mp100>(there, 0);
  };
  const Values middle = at(-1, -1, 0);
  std::vector<Values> after, before;
  after.reserve(d);
  before.reserve(d);
  for (int i = 0; i < d; ++i) after.push_back(at(i, -1, 1)), before.push_back(at(i, -1, -1));
  std::vector<std::array<Mp, 4>> found(d * d);
  for (int i = 0; i < d; ++i)
    for (int j = i; j < d; ++j) {
      const Values beyond = i == j ? Values() : at(i, j, 1), behind = i == j ? Values() : at(i, j, -1);
      for (std::size_t b = 0; b < 4; ++b) {
        Mp row(1, layers.blocks()[b].size);
        for (int k = 0; k < row.cols(); ++k) {
          const auto value = [&](const Values& of) { return of[b].value[k]; };
          Mp100 second = value(after[i]) - 2 * value(middle) + value(before[i]);
          if (i != j)
            second = (value(beyond) + value(behind) + 2 * value(middle) - value(after[i]) - value(before[i]) -
                      value(after[j]) - value(before[j])) /
                     2;
          row(0, k) = Mp50(second / step / step);
        }
        found[i * d + j][b] = found[j * d + i][b] = row;
      }
    }
  return found;
}

/// Second derivatives at the samples of level 1, 1e-26 inside of the cage, and the rest normals there.
struct SecondDerivatives {
  std::vector<Vec3<Mp50>> normals;
  std::vector<std::vector<std::array<Mp, 4>>> found;  ///< [sample], as second_differences

  explicit SecondDerivatives(const CageCoordinates& layers) {
    const CageElements& elements = layers.elements();
    for (const SampleRows& sample : sample_rows(layers)) {
      std::vector<Vec3<Mp50>> corners;
      for (const Vec& corner : elements.corners(sample.element)) corners.push_back(convert<Mp50>(corner));
      normals.push_back(unit_normal(corners));
      Vec3<Mp50> point = Mp50("-1e-26") * normals.back();
      for (int k = 0; k < static_cast<int>(corners.size()); ++k)
        point += sample.hats(0, elements.vertices_of(sample.element)[k]) * corners[k];
      Vec3<Mp100> wide;
      for (int c = 0; c < 3; ++c) wide[c] = Mp100(point[c]);
      found.push_back(second_differences(layers, wide, Mp100("4e-27")));
    }
  }

  OfLayers under(Operator op, const CageCoordinates& layers) const {
    const int d = layers.dimension(), rows = op == Operator::Hessian ? d * d : 1,
              count = static_cast<int>(found.size());
    OfLayers all;
    for (std::size_t b = 0; b < 4; ++b) {
      all[b] = Mp::Zero(rows * count, layers.blocks()[b].size);
      for (int s = 0; s < count; ++s)
        for (int i = 0; i < d; ++i)
          for (int j = 0; j < d; ++j) {
            const Mp& row = found[s][i * d + j][b];
            if (op == Operator::Hessian) all[b].row(rows * s + i * d + j) = row;
            else if (op == Operator::Normal) all[b].row(s) += normals[s][i] * normals[s][j] * row;
            else if (i == j) all[b].row(s) += row;
          }
    }
    return all;
  }
};

/// Lam_V and Lam_N, and what Section 3.1 makes of vertices and normal derivatives.
struct AlignedRoute {
  Mp densities;  ///< of (V'; N'), (L'; D') = densities (V'; N')
  Mp of_vertices, of_normals;
  Mp gram;  ///< Lam_N^T Lam_N

  AlignedRoute(Operator op, const CageCoordinates& layers, const SecondDerivatives& derivatives) {
    const int n = layers.blocks()[0].size, m = layers.blocks()[1].size;
    const Mp all = Mp::Identity(n + m, n + m);
    densities = densities_by_constraints("regularised_1_3", layers, all.topRows(n), all.bottomRows(m));
    const OfLayers of = derivatives.under(op, layers);
    const Mp whole = side_by_side(of[0], of[1]) + side_by_side(of[2], of[3]) * densities;
    of_vertices = whole.leftCols(n);
    of_normals = whole.rightCols(m);
    gram = of_normals.transpose() * of_normals;
  }

  Mp50 energy(const Mp& vertices, const Mp& normals) const {
    return (of_vertices * vertices + of_normals * normals).squaredNorm();
  }

  /// Eq 34 on stacked unknowns, those of an element together; with gamma_a = 0 the free minimum.
  Mp softly(const Mp& vertices, const Mp& units, const Mp50& gamma_a) const {
    const int m = static_cast<int>(units.rows()), d = static_cast<int>(units.cols());
    const Mp right = of_normals.transpose() * (of_vertices * vertices);
    Mp matrix = Mp::Zero(d * m, d * m), stacked(d * m, 1);
    for (int t = 0; t < m; ++t)
      for (int c = 0; c < d; ++c) {
        stacked(d * t + c, 0) = -right(t, c);
        for (int other = 0; other < m; ++other) matrix(d * t + c, d * other + c) += gram(t, other);
        for (int k = 0; k < d; ++k)
          matrix(d * t + c, d * t + k) += gamma_a * ((c == k ? Mp50(1) : Mp50(0)) - units(t, c) * units(t, k));
      }
    return Eigen::FullPivLU<Mp>(matrix).solve(stacked).reshaped(d, m).transpose();
  }

  /// The normal equations of Eq 33: Lam_N^T Lam_N times n' n'^T, entry by entry, and their right side.
  std::pair<Mp, Mp> along(const Mp& vertices, const Mp& units) const {
    const Mp pull = of_normals.transpose() * (of_vertices * vertices);
    return {gram.cwiseProduct(units * units.transpose()), -pull.cwiseProduct(units).rowwise().sum()};
  }
};

}  // namespace cageproof::deformation::test
