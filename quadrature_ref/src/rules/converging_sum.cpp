// SPDX-License-Identifier: MIT
#include "converging_sum.h"

#include <cmath>

namespace cageproof::quadrature_ref {
namespace {

constexpr double kNone = -std::numeric_limits<double>::infinity();

// log10 of the square of the Bernstein radius on the longest edge, from the distance of eta to the centroid.
double convergence_rate(const LocalTriangle<Mp200>& t) {
  double reach = 0, half_edge = 0;
  const Vec3<Mp200> centroid = (t.corners[0] + t.corners[1] + t.corners[2]) / Mp200(3);
  for (int k = 0; k < 3; ++k) {
    reach = std::max(reach, static_cast<double>(length(Vec3<Mp200>(t.corners[k] - centroid))));
    half_edge = std::max(half_edge, static_cast<double>(length(t.edges[k])) / 2);
  }
  const double gap = static_cast<double>(length(centroid)) - reach;
  const double axis = 1 + gap / half_edge;
  return 2 * std::log10(axis + std::sqrt(axis * axis - 1));
}

}  // namespace

double agreement(const std::vector<Mp200>& a, const std::vector<Mp200>& b, double most) {
  Mp200 square = 0;
  for (std::size_t i = 0; i < a.size(); ++i) square += (a[i] - b[i]) * (a[i] - b[i]);
  if (square == 0) return most;
  return std::min(most, log10_norm(b) - log10_magnitude(square) / 2);
}

Answer converge(ConvergingSum& sum, double digits, int order) {
  Answer answer;
  const double most = digits + 8;
  double aim = digits + 2;
  Result<Mp200> rough = sum.at(aim);
  for (int attempt = 0; attempt < 4; ++attempt) {
    aim += 6;
    answer.sums = sum.at(aim);
    double least = most;
    for (int o = 0; o <= order; ++o) {
      answer.digits[o] = agreement(rough.of(o), answer.sums.of(o), most);
      least = std::min(least, answer.digits[o]);
    }
    if (least >= digits) break;
    aim += std::max(0.0, digits - least);
    rough = std::move(answer.sums);
    answer.sums = rough;
  }
  answer.sums.nodes = sum.nodes();
  return answer;
}

std::array<double, 3> ConvergingSum::norms(const std::array<double, 3>& mass, const SumWithError& with_error) const {
  // Rising digits relative to the mass until something is left of every order.
  std::array<double, 3> error, norm{};
  std::array<bool, 3> known{};
  for (const double digits : {10.0, 42.0, 92.0, 180.0}) {
    for (int o = 0; o <= order_; ++o) error[o] = known[o] ? norm[o] - 1 : mass[o] - digits;
    const Result<Mp200> sums = with_error(error);
    bool all_known = true;
    for (int o = 0; o <= order_; ++o) {
      if (known[o]) continue;
      norm[o] = std::max(log10_norm(sums.of(o)), error[o]);
      known[o] = mass[o] == kNone || norm[o] > error[o] + 2;
      all_known = all_known && known[o];
    }
    if (all_known) break;
  }
  return norm;
}

FarSum::FarSum(const Integrand& integrand, const LocalTriangle<Mp200>& triangle, const Query<Mp200>& query)
    : ConvergingSum(integrand, query), triangle_(triangle), log10_rate_(convergence_rate(triangle)) {}

template <Scalar W>
Result<Mp200> FarSum::at_precision(int n) {
  Result<W> sums;
  sums.reset(components_, 3, order_);
  add_gauss(convert<W>(triangle_), integrand_.kernels.at<W>(), parameters<W>(), n, order_, sums);
  Result<Mp200> total = empty();
  add(sums, total);
  return total;
}

Result<Mp200> FarSum::at(double digits) {
  const int n = std::clamp(static_cast<int>(std::ceil(digits / log10_rate_)) + 2, 4, 256);
  return digits <= kDigitsIn50    ? at_precision<Mp50>(n)
         : digits <= kDigitsIn100 ? at_precision<Mp100>(n)
                                  : at_precision<Mp200>(n);
}

PolarSum::PolarSum(const Integrand& integrand, PolarFrame<Mp200> frame, const Query<Mp200>& query)
    : ConvergingSum(integrand, query),
      exact_frame_(std::move(frame)),
      frame50_(convert<Mp50>(exact_frame_)),
      frame100_(convert<Mp100>(exact_frame_)) {}

template <Scalar W>
void PolarSum::add_cell(const PolarFrame<W>& frame, const PolarCell& cell, CellPoints points, Result<Mp200>& total) {
  Result<W> sums;
  sums.reset(components_, 3, order_);
  RayCaster<W>(frame, integrand_, parameters<W>(), order_).add_cell(cell, points, sums);
  add(sums, total);
}

Result<Mp200> PolarSum::with_error(const std::array<double, 3>& log10_error) {
  Result<Mp200> total = empty();
  for (std::size_t i = 0; i < cells_.size(); ++i) {
    double digits = 0;
    for (int o = 0; o <= order_; ++o)
      if (mass_[i][o] > kNone) digits = std::max(digits, mass_[i][o] - log10_error[o]);
    CellPoints points = points_for(exact_frame_, cells_[i], std::min(digits, kDigitsIn200));
    if (cells_[i].edge < 0) points.t += more_directions_;
    if (digits <= kDigitsIn50) add_cell(frame50_, cells_[i], points, total);
    else if (digits <= kDigitsIn100) add_cell(frame100_, cells_[i], points, total);
    else add_cell(exact_frame_, cells_[i], points, total);
  }
  return total;
}

void PolarSum::scout() {
  std::array<double, 3> mass;
  mass.fill(kNone);
  RayCaster<Mp50> caster(frame50_, integrand_, parameters<Mp50>(), order_);
  for (const PolarCell& cell : cells_) {
    mass_.push_back(caster.log10_mass(cell));
    for (int o = 0; o <= order_; ++o) mass[o] = std::max(mass[o], mass_.back()[o]);
  }
  norm_ = norms(mass, [&](const auto& error) { return with_error(error); });
}

Result<Mp200> PolarSum::at(double digits) {
  if (!scouted_) {
    cells_ = polar_cells(exact_frame_, digits > 50 ? PanelDesign{64, 60} : PanelDesign{32, 30});
    scout();
    scouted_ = true;
  }
  more_directions_ = 4 - more_directions_;
  std::array<double, 3> error;
  for (int o = 0; o <= order_; ++o) error[o] = norm_[o] - digits;
  return with_error(error);
}

}  // namespace cageproof::quadrature_ref
