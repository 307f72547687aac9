// SPDX-License-Identifier: MIT
// [T24] Eq 37-40 by loops over constraints: energies, their gradients, and nearest rotations by quaternions.
#pragma once

#include "variational_cases.h"

#include <Eigen/Eigenvalues>

#include <functional>

namespace cageproof::deformation::test {

/// The rotation that maximises the inner product with a matrix: Horn's quaternion (1987) in space, an angle in the
/// plane.
inline Mat rotation_by_quaternion(const Mat& j, int d) {
  if (d == 2) {
    Mat r = Mat::Zero();
    const double angle = std::atan2(j(1, 0) - j(0, 1), j(0, 0) + j(1, 1));
    r(0, 0) = r(1, 1) = std::cos(angle);
    r(1, 0) = std::sin(angle);
    r(0, 1) = -r(1, 0);
    return r;
  }
  Eigen::Matrix4d n;
  n << j(0, 0) + j(1, 1) + j(2, 2), j(2, 1) - j(1, 2), j(0, 2) - j(2, 0), j(1, 0) - j(0, 1),  //
      j(2, 1) - j(1, 2), j(0, 0) - j(1, 1) - j(2, 2), j(1, 0) + j(0, 1), j(0, 2) + j(2, 0),   //
      j(0, 2) - j(2, 0), j(1, 0) + j(0, 1), j(1, 1) - j(0, 0) - j(2, 2), j(2, 1) + j(1, 2),   //
      j(1, 0) - j(0, 1), j(0, 2) + j(2, 0), j(2, 1) + j(1, 2), j(2, 2) - j(0, 0) - j(1, 1);
  const Eigen::Vector4d q = Eigen::SelfAdjointEigenSolver<Eigen::Matrix4d>(n).eigenvectors().col(3);
  return Eigen::Quaterniond(q[0], q[1], q[2], q[3]).toRotationMatrix();
}

inline Mat nearest_of(const Mat& j, Nearest nearest, int d) {
  const Mat r = rotation_by_quaternion(j, d);
  return nearest == Nearest::Rotation ? r : Mat(j.cwiseProduct(r).sum() / d * r);
}

/// One constraint's part of the energy: weight |derivatives - target|^2. Row c, column k: component c, derivative k.
struct Term {
  Vec at;
  int order;
  double weight;
  Eigen::MatrixXd target;
};

/// The terms of an energy, with these Jacobians at the points of rotations.
inline std::vector<Term> terms_of(const Constraints& constraints, const VariationalOptions& options,
                                  const std::vector<Mat>& nearest, int d) {
  std::vector<Term> terms;
  terms.reserve(constraints.positions.size() + constraints.orientations.size() + nearest.size());
  for (const auto& [at, to] : constraints.positions) terms.push_back({at, 0, 1, to.head(d)});
  for (const auto& [at, jacobian] : constraints.orientations)
    terms.push_back({at, 1, options.alpha, jacobian.topLeftCorner(d, d)});
  for (std::size_t p = 0; p < nearest.size(); ++p)
    terms.push_back({constraints.rotations[p], 1, options.beta, nearest[p].topLeftCorner(d, d)});
  for (const Vec& at : constraints.hessians) terms.push_back({at, 2, options.gamma, Eigen::MatrixXd::Zero(d, d * d)});
  return terms;
}

/// A map as a function: f, or its derivatives.
using Map = std::function<Images<double>(const Vec&, int)>;

inline Map identity(int d) {
  return [d](const Vec& at, int order) {
    Images<double> images;
    images.tensors[0].assign(at.data(), at.data() + d);
    if (order > 0)
      for (int i = 0; i < d * d; ++i) images.tensors[1].push_back(i % (d + 1) == 0 ? 1 : 0);
    if (order > 1) images.tensors[2].assign(d * d * d, 0);
    return images;
  };
}

/// The map after so many steps.
inline Map map_after(int steps, const Cage& cage, const Constraints& constraints, VariationalOptions options) {
  if (steps == 0) return identity(cage.dimension());
  options.steps = steps;
  options.tolerance = 0;
  const Variational<double> model(cage, constraints, options);
  const std::shared_ptr<const Posed<double>> posed = model.pose();
  return [model, posed](const Vec& at, int order) { return model.images(*posed, std::vector<Vec>{at}, order); };
}

inline std::vector<Mat> nearest_at(const Map& map, const Constraints& constraints, Nearest nearest, int d) {
  std::vector<Mat> found;
  for (const Vec& at : constraints.rotations) {
    const Images<double> images = map(at, 1);
    Mat j = Mat::Zero();
    for (int c = 0; c < d; ++c)
      for (int k = 0; k < d; ++k) j(c, k) = images.tensors[1][c * d + k];
    found.push_back(nearest_of(j, nearest, d));
  }
  return found;
}

/// The difference of a map's derivatives from a term's target.
inline Eigen::MatrixXd miss(const Map& map, const Term& term) {
  const Images<double> images = map(term.at, term.order);
  Eigen::MatrixXd found = -term.target;
  for (Eigen::Index c = 0; c < found.rows(); ++c)
    for (Eigen::Index k = 0; k < found.cols(); ++k)
      found(c, k) += images.tensors[term.order][static_cast<std::size_t>(c * found.cols() + k)];
  return found;
}

inline double energy_of(const Map& map, const std::vector<Term>& terms) {
  double sum = 0;
  for (const Term& term : terms) sum += term.weight * miss(map, term).squaredNorm();
  return sum;
}

/// How component `row` of a map, one of its derivatives, changes with component `column` of a coefficient.
inline double entry(const CoordinateTable<double>& table, const CoordinateBlock& block, int order,
                    Eigen::Index coefficient, int row, int column, Eigen::Index derivative) {
  const auto width = static_cast<Eigen::Index>(table.stride[order]) / (block.size * block.entries());
  const int d = block.shape.rows;
  if (d == 1) return row == column ? table.tensors[order][coefficient * width + derivative] : 0;
  return table.tensors[order][((coefficient * d + row) * d + column) * width + derivative];
}

/// The energy's gradient by the coefficients: one row per coefficient, block by block, one column per component.
inline Eigen::MatrixXd gradient_of(const CageCoordinates& coordinates, const Map& map, const std::vector<Term>& terms) {
  const int d = coordinates.dimension();
  std::vector<Eigen::MatrixXd> of_blocks;
  of_blocks.reserve(coordinates.blocks().size());
  for (const CoordinateBlock& block : coordinates.blocks())
    of_blocks.emplace_back(Eigen::MatrixXd::Zero(block.size, d));
  for (const Term& term : terms) {
    const Eigen::MatrixXd error = miss(map, term);
    const auto tables = coordinates.at<double>(std::vector<Vec>{term.at}, term.order);
    for (std::size_t b = 0; b < of_blocks.size(); ++b)
      for (Eigen::Index i = 0; i < of_blocks[b].rows(); ++i)
        for (Eigen::Index k = 0; k < error.cols(); ++k)
          for (int c = 0; c < d; ++c)
            for (int row = 0; row < d; ++row)
              of_blocks[b](i, c) +=
                  2 * term.weight * error(row, k) * entry(tables[b], coordinates.blocks()[b], term.order, i, row, c, k);
  }
  Eigen::Index rows = 0;
  for (const Eigen::MatrixXd& block : of_blocks) rows += block.rows();
  Eigen::MatrixXd all(rows, d);
  rows = 0;
  for (const Eigen::MatrixXd& block : of_blocks) {
    all.middleRows(rows, block.rows()) = block;
    rows += block.rows();
  }
  return all;
}

}  // namespace cageproof::deformation::test
