// SPDX-License-Identifier: MIT
// Plane elasticity by Goursat's functions, from the boundary's values by least squares, without any layer: a second
// route to what `elastic` coordinates approximate.
#pragma once

#include <Eigen/QR>

#include <algorithm>
#include <cmath>
#include <complex>
#include <numbers>
#include <vector>

namespace cageproof::solved::test {

/// u + i v = kappa phi(z) - z conj(phi'(z)) - conj(psi(z)), kappa = 3 - 4 nu, of plane strain with 2 mu = 1 (any other
/// scales phi and psi). Both functions are polynomials and poles outside the polygon, which come exponentially near to
/// its corners (Gopal and Trefethen 2019, of harmonic functions).
class GoursatElasticity {
 public:
  using C = std::complex<double>;

  /// \param corners counter-clockwise, of a polygon of size about one \param values at corners, affine on edges
  GoursatElasticity(std::vector<C> corners, const std::vector<C>& values, double nu, int poles, int degree)
      : corners_(std::move(corners)), values_(values), kappa_(3 - 4 * nu), degree_(degree) {
    const std::size_t n = corners_.size();
    for (const C& corner : corners_) centre_ += corner / static_cast<double>(n);
    for (std::size_t k = 0; k < n; ++k) {
      const C next = corners_[(k + 1) % n] - corners_[k], last = corners_[(k + n - 1) % n] - corners_[k];
      double turn = std::arg(last / next);  // the inner angle
      if (turn < 0) turn += 2 * std::numbers::pi;
      const C outward = -next / std::abs(next) * std::polar(1., turn / 2);
      for (int j = 1; j <= poles; ++j)
        poles_.push_back({corners_[k] + outward * distance(j, poles), distance(j, poles)});
    }
    solve();
  }

  C displacement(const C& z) const {
    C sum = 0;
    for (Eigen::Index c = 0; c < solution_.size(); ++c) sum += solution_[c] * column(c, z);
    return sum;
  }
  /// The largest difference from the data, between the points that were solved for.
  double residual() const {
    double worst = 0;
    for (std::size_t e = 0; e < corners_.size(); ++e)
      for (int k = 0; k < 997; ++k) {
        const double t = (1 - std::cos(std::numbers::pi * (k + 0.5) / 997)) / 2;
        worst = std::max(worst, std::abs(displacement(on(corners_, e, t)) - on(values_, e, t)));
      }
    return worst;
  }

 private:
  struct Pole {
    C place;
    double size;
  };
  static double distance(int j, int poles) { return std::exp(-4 * (std::sqrt(poles) - std::sqrt(j))); }
  static C on(const std::vector<C>& of, std::size_t e, double t) {
    return (1 - t) * of[e] + t * of[(e + 1) % of.size()];
  }
  Eigen::Index functions() const { return degree_ + 1 + static_cast<Eigen::Index>(poles_.size()); }
  // Function f and its derivative.
  std::pair<C, C> at(Eigen::Index f, const C& z) const {
    if (f > degree_) {
      const Pole& pole = poles_[f - degree_ - 1];
      const C value = pole.size / (z - pole.place);
      return {value, -value / (z - pole.place)};
    }
    const C w = z - centre_;
    return {std::pow(w, static_cast<int>(f)), f == 0 ? C(0) : double(f) * std::pow(w, static_cast<int>(f) - 1)};
  }
  // phi's functions times 1 and i, each with a psi that puts the origin where it is centred; then psi's own.
  C column(Eigen::Index c, const C& z) const {
    const C unit = c % 2 == 0 ? C(1) : C(0, 1);
    const Eigen::Index f = c / 2 % functions();
    const auto [value, slope] = at(f, z);
    const C from = f > degree_ ? poles_[f - degree_ - 1].place : centre_;
    if (c / 2 < functions()) return kappa_ * unit * value - (z - from) * std::conj(unit * slope);
    return -std::conj(unit * value);
  }
  void solve() {
    constexpr int points = 200;
    const Eigen::Index count = 4 * functions(), rows = 2 * points * static_cast<Eigen::Index>(corners_.size());
    Eigen::MatrixXd matrix(rows, count);
    Eigen::VectorXd right(rows);
    for (std::size_t e = 0; e < corners_.size(); ++e)
      for (int k = 0; k < points; ++k) {
        // As dense next to corners as poles are.
        const double s = std::tanh(10. * (2. * k / (points - 1) - 1)), t = (1 + s / std::tanh(10.)) / 2;
        const C z = on(corners_, e, t), value = on(values_, e, t);
        const Eigen::Index row = 2 * (static_cast<Eigen::Index>(e) * points + k);
        for (Eigen::Index c = 0; c < count; ++c) {
          const C entry = column(c, z);
          matrix(row, c) = entry.real();
          matrix(row + 1, c) = entry.imag();
        }
        right[row] = value.real();
        right[row + 1] = value.imag();
      }
    Eigen::ColPivHouseholderQR<Eigen::MatrixXd> factors(matrix);
    factors.setThreshold(1e-14);
    solution_ = factors.solve(right);
  }

  std::vector<C> corners_, values_;
  double kappa_;
  int degree_;
  C centre_ = 0;
  std::vector<Pole> poles_;
  Eigen::VectorXd solution_;
};

}  // namespace cageproof::solved::test
