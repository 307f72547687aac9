// SPDX-License-Identifier: MIT
// Thickness and its constraints by explicit sums.
#pragma once

#include "support.h"

#include "cageproof/deformation/constrained.h"

namespace cageproof::deformation::test {

/// The same problem by another route: second derivatives of coordinates 1e-25 inside of the samples, in 50 digits, and
/// gradients of explicit sums.
struct ThicknessLoops {
  ThicknessLoops(const CageCoordinates& coordinates, const Constraints& constraints, int samples)
      : elements(coordinates.elements()), positions(constraints.positions) {
    for (std::size_t e = 0; e < elements.count(); ++e) {
      const auto ends = elements.corners(e);
      const Vec n = elements.normals()[e];
      for (int q = 0; q < samples; ++q) {
        const Mp50 along = Mp50(2 * q + 1) / (2 * samples);
        const Vec3<Mp50> at =
            convert<Mp50>(ends[0]) + along * convert<Mp50>(Vec(ends[1] - ends[0])) - Mp50("1e-25") * convert<Mp50>(n);
        const auto found = coordinates.at<Mp50>(at, 2);
        for (std::size_t b = 0; b < 2; ++b) {
          auto& row = bending[b].emplace_back();
          for (std::size_t k = 0; k < found[b].of(2).size() / 4; ++k) {
            Mp50 sum = 0;
            for (int i = 0; i < 4; ++i) sum += Mp50(n[i / 2]) * Mp50(n[i % 2]) * found[b].of(2)[4 * k + i];
            row.push_back(static_cast<double>(sum));
          }
        }
      }
    }
    for (const auto& position : positions) {
      const auto found = coordinates.at<double>(position.at, 0);
      for (std::size_t b = 0; b < 2; ++b) values[b].push_back(found[b].value);
    }
  }

  std::array<Vec, 2> normal_and_direction(const Eigen::VectorXd& f, std::size_t e, double* length) const {
    const auto ends = elements.vertices_of(e);
    const Vec edge(f[2 * ends[1]] - f[2 * ends[0]], f[2 * ends[1] + 1] - f[2 * ends[0] + 1], 0);
    *length = edge.norm();
    const Vec along = edge / *length;
    return {Vec(along[1], -along[0], 0), along};
  }

  // Value of a row of coordinates and the gradient of its dot product with a force.
  Vec value(const std::vector<double>& alpha, const std::vector<double>& beta, const Eigen::VectorXd& f) const {
    Vec sum = Vec::Zero();
    double length = 0;
    for (std::size_t v = 0; v < alpha.size(); ++v) sum += alpha[v] * Vec(f[2 * v], f[2 * v + 1], 0);
    for (std::size_t e = 0; e < beta.size(); ++e) sum += beta[e] * normal_and_direction(f, e, &length)[0];
    return sum;
  }
  void add_gradient(const std::vector<double>& alpha, const std::vector<double>& beta, const Vec& force,
                    const Eigen::VectorXd& f, Eigen::VectorXd& into) const {
    for (std::size_t v = 0; v < alpha.size(); ++v)
      for (int c = 0; c < 2; ++c) into[2 * v + c] += alpha[v] * force[c];
    for (std::size_t e = 0; e < beta.size(); ++e) {
      double length = 0;
      const auto [normal, along] = normal_and_direction(f, e, &length);
      const Vec on_edge = -beta[e] * along.dot(force) / length * normal;
      const auto ends = elements.vertices_of(e);
      for (int c = 0; c < 2; ++c) {
        into[2 * ends[1] + c] += on_edge[c];
        into[2 * ends[0] + c] -= on_edge[c];
      }
    }
  }

  double energy(const Eigen::VectorXd& f) const {
    double sum = 0;
    for (std::size_t s = 0; s < bending[0].size(); ++s) sum += value(bending[0][s], bending[1][s], f).squaredNorm();
    return sum;
  }
  Eigen::VectorXd energy_gradient(const Eigen::VectorXd& f) const {
    Eigen::VectorXd found = Eigen::VectorXd::Zero(f.size());
    for (std::size_t s = 0; s < bending[0].size(); ++s)
      add_gradient(bending[0][s], bending[1][s], 2 * value(bending[0][s], bending[1][s], f), f, found);
    return found;
  }
  Eigen::VectorXd misfit(const Eigen::VectorXd& f) const {
    Eigen::VectorXd found(2 * positions.size());
    for (std::size_t p = 0; p < positions.size(); ++p)
      found.segment(2 * p, 2) = (value(values[0][p], values[1][p], f) - positions[p].to).head(2);
    return found;
  }
  // A column a constraint.
  Eigen::MatrixXd constraint_gradients(const Eigen::VectorXd& f) const {
    Eigen::MatrixXd found(f.size(), 2 * positions.size());
    for (std::size_t p = 0; p < positions.size(); ++p)
      for (int c = 0; c < 2; ++c) {
        Eigen::VectorXd one = Eigen::VectorXd::Zero(f.size());
        add_gradient(values[0][p], values[1][p], Vec::Unit(c), f, one);
        found.col(2 * p + c) = one;
      }
    return found;
  }

  CageElements elements;
  std::vector<Constraints::Position> positions;
  std::array<std::vector<std::vector<double>>, 2> bending, values;
};

}  // namespace cageproof::deformation::test
