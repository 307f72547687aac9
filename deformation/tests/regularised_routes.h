// SPDX-License-Identifier: MIT
// The densities of [T24] Eq 20-30 and Appendix D by another route: constraint by constraint, by normal equations, in 50
// digits, which squaring the condition leaves more than enough of, with layers next to the cage in place of limits.
#pragma once

#include "support.h"

#include <Eigen/LU>

namespace cageproof::deformation::test {

using Mp = Matrix<Mp50>;

/// A sample's layers: values, and slopes along the outward normal.
struct SampleRows {
  int element;
  Mp hats;                      ///< 1 x vertices
  std::array<Mp, 4> of, slope;  ///< of phi, psi, phibar, psibar
  Mp own;                       ///< times the normal derivatives' data: the normal derivative here
  Mp psi, psi_slope;            ///< an element each, also where there is data a corner
};

/// Columns added up, so many at a time.
inline Mp folded(const Mp& row, int together) {
  Mp sums = Mp::Zero(1, row.cols() / together);
  for (int i = 0; i < row.cols(); ++i) sums(0, i / together) += row(0, i);
  return sums;
}

/// At the centroids of each element's parts by its midpoints.
inline std::vector<SampleRows> sample_rows(const CageCoordinates& layers) {
  const Mp50 third = Mp50(1) / 3, sixth = Mp50(1) / 6;
  const std::vector<std::array<Mp50, 3>> of_triangles{
      {third, third, third}, {4 * sixth, sixth, sixth}, {sixth, 4 * sixth, sixth}, {sixth, sixth, 4 * sixth}};
  const std::vector<std::array<Mp50, 3>> of_segments{{Mp50(0.75), Mp50(0.25), Mp50(0)},
                                                     {Mp50(0.25), Mp50(0.75), Mp50(0)}};
  const CageElements& elements = layers.elements();
  const int d = layers.dimension();
  std::vector<SampleRows> all;
  for (std::size_t e = 0; e < elements.count(); ++e) {
    const auto vertices = elements.vertices_of(e);
    std::vector<Vec3<Mp50>> corners;
    corners.reserve(vertices.size());
    for (const int v : vertices) corners.push_back(convert<Mp50>(elements.vertices()[v]));
    const Vec3<Mp50> u = corners[1] - corners[0];
    Vec3<Mp50> normal(u[1], -u[0], Mp50(0));
    if (d == 3) normal = u.cross(Vec3<Mp50>(corners[2] - corners[0]));
    normal /= Mp50(sqrt(Mp50(normal.dot(normal))));
    for (auto basis : d == 3 ? of_triangles : of_segments) {
      // Samples are points whose basis functions are multiples of 2^-52, and that of the lowest vertex is what the
      // others leave of one.
      const auto lowest = std::ranges::min_element(vertices) - vertices.begin();
      basis[lowest] = 1;
      for (int k = 0; k < d; ++k)
        if (k != lowest) basis[lowest] -= basis[k] = Mp50(std::round(0x1p52 * static_cast<double>(basis[k])) * 0x1p-52);
      SampleRows rows{
          static_cast<int>(e), Mp::Zero(1, static_cast<int>(elements.vertices().size())), {}, {}, {}, {}, {}};
      Vec3<Mp50> point = Mp50("-1e-30") * normal;
      for (int k = 0; k < d; ++k) {
        point += basis[k] * corners[k];
        rows.hats(0, vertices[k]) = basis[k];
      }
      const auto found = layers.at<Mp50>(point, 1);
      for (std::size_t b = 0; b < 4; ++b) {
        const int count = layers.blocks()[b].size;
        rows.of[b] = rows.slope[b] = Mp::Zero(1, count);
        for (int i = 0; i < count; ++i) {
          rows.of[b](0, i) = found[b].value[i];
          for (int c = 0; c < d; ++c) rows.slope[b](0, i) += found[b].gradient[i * d + c] * normal[c];
        }
      }
      const bool affine = layers.blocks()[1].owner == Owner::Corner;
      rows.own = Mp::Zero(1, rows.of[1].cols());
      for (int k = 0; k < d; ++k) rows.own(0, affine ? static_cast<int>(e) * d + k : static_cast<int>(e)) += basis[k];
      rows.psi = folded(rows.of[1], affine ? d : 1);
      rows.psi_slope = folded(rows.slope[1], affine ? d : 1);
      all.push_back(std::move(rows));
    }
  }
  return all;
}

/// Sums of squares of constraints `row` X = `right`, and the X that makes them least.
struct NormalEquations {
  Mp matrix, right;
  void add(const Mp& row, const Mp& value, const Mp50& weight = Mp50(1)) {
    if (matrix.size() == 0) {
      matrix = Mp::Zero(row.cols(), row.cols());
      right = Mp::Zero(row.cols(), value.cols());
    }
    matrix += weight * row.transpose() * row;
    right += weight * row.transpose() * value;
  }
  Mp solution() const { return Eigen::FullPivLU<Mp>(matrix).solve(right); }
};

inline Mp side_by_side(const Mp& left, const Mp& right) {
  Mp both(left.rows(), left.cols() + right.cols());
  both << left, right;
  return both;
}

/// (L'; D') for a pose's vertices and normals, one row per element, or per corner with layers of `biharmonic_affine`.
/// \param kind regularised_1_3, regularised_1_2 or regularised_weber
inline Mp densities_by_constraints(std::string_view kind, const CageCoordinates& layers, const Mp& vertices,
                                   const Mp& normals, const Mp50& gamma_d = Mp50(1)) {
  const std::vector<SampleRows> samples = sample_rows(layers);
  const auto missing = [&](const SampleRows& s) {  // of the values, with no densities
    return Mp(s.hats * vertices - s.of[0] * vertices - s.of[1] * normals);
  };
  NormalEquations equations;
  if (kind == "regularised_weber") {
    NormalEquations slopes;
    for (const SampleRows& s : samples) slopes.add(s.psi, s.hats - s.of[0]);
    const Mp of_laplacians = slopes.solution();
    for (const SampleRows& s : samples) equations.add(s.of[2] + s.of[3] * of_laplacians, missing(s));
    const Mp laplacians = equations.solution();
    return side_by_side(laplacians.transpose(), (of_laplacians * laplacians).transpose()).transpose();
  }
  for (const SampleRows& s : samples) {
    equations.add(side_by_side(s.of[2], s.of[3]), missing(s), kind == "regularised_1_3" ? gamma_d : Mp50(1));
    if (kind == "regularised_1_3") equations.add(side_by_side(s.of[0] - s.hats, s.psi), Mp::Zero(1, vertices.cols()));
    else
      equations.add(side_by_side(s.slope[2], s.slope[3]),
                    s.own * normals - s.slope[0] * vertices - s.slope[1] * normals);
  }
  return equations.solution();
}

}  // namespace cageproof::deformation::test
