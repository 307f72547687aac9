// SPDX-License-Identifier: MIT
#include "triangle_sums.h"

#include "gauss.h"

#include <cmath>

namespace cageproof::quadrature_ref {
namespace {

// By how many directions every second sum's rings have more, so that comparing two sums tests the directions as well.
constexpr int kMoreDirections = 4;

// log10 of the square of the Bernstein radius on the longest edge, from the distance of eta to the centroid.
double convergence_rate(const TriangleFrame<Mp200>& t) {
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

FarSum::FarSum(const Integrand& integrand, const TriangleFrame<Mp200>& triangle, const Query<Mp200>& query)
    : ConvergingSum(integrand, query), triangle_(triangle), log10_rate_(convergence_rate(triangle)) {}

template <Scalar W>
Result<Mp200> FarSum::at_precision(int n) {
  Result<W> sums = empty<W>();
  std::vector<Node<W>> row;
  add_gauss(convert<W>(triangle_), integrand_.kernel<W>(), task<W>(), gauss_nodes<W>(n), row, sums);
  Result<Mp200> total = empty();
  add(sums, total);
  return total;
}

Result<Mp200> FarSum::at(double digits) {
  // Far away one more point gains many digits: rules for a few more would be the same one, and would agree in any case.
  const int n = std::clamp(static_cast<int>(std::ceil(digits / log10_rate_)) + 2, 4, 256) + (finer_ ? 1 : 0);
  finer_ = !finer_;
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
  Result<W> sums = empty<W>();
  RayCaster<W>(frame, integrand_, task<W>()).add_cell(cell, points, sums);
  add(sums, total);
}

Result<Mp200> PolarSum::with_error(const std::array<double, 3>& log10_error) {
  Result<Mp200> total = empty();
  std::vector<double> digits_in(cells_.size());
  std::vector<CellPoints> points_in(cells_.size());
  double work = 0;
  do {
    work = 0;
    for (std::size_t i = 0; i < cells_.size(); ++i) {
      double& digits = digits_in[i];
      digits = 0;
      for (int o = 0; o <= order_; ++o)
        if (mass_[i][o] > kNoMass && !declines(o)) digits = std::max(digits, mass_[i][o] - log10_error[o]);
      CellPoints& points = points_in[i];
      points = points_for(exact_frame_, cells_[i], std::min(digits, kDigitsIn200));
      if (finer_) {
        points.t += cells_[i].edge < 0 ? kMoreDirections : 1;
        ++points.w;
      }
      work += points.t * points.w * (digits <= kDigitsIn50 ? 1 : digits <= kDigitsIn100 ? 1.5 : 3);
    }
  } while (too_much(work));
  for (std::size_t i = 0; i < cells_.size(); ++i) {
    const double digits = digits_in[i];
    const CellPoints points = points_in[i];
    if (digits <= kDigitsIn50) add_cell(frame50_, cells_[i], points, total);
    else if (digits <= kDigitsIn100) add_cell(frame100_, cells_[i], points, total);
    else add_cell(exact_frame_, cells_[i], points, total);
  }
  return total;
}

void PolarSum::scout() {
  std::array<double, 3> mass;
  mass.fill(kNoMass);
  RayCaster<Mp50> caster(frame50_, integrand_, task<Mp50>());
  for (const PolarCell& cell : cells_) {
    mass_.push_back(caster.log10_mass(cell));
    for (int o = 0; o <= order_; ++o) mass[o] = std::max(mass[o], mass_.back()[o]);
  }
  find_log10_norms(mass, [&](const auto& error) { return with_error(error); });
}

Result<Mp200> PolarSum::at(double digits) {
  if (!scouted_) {
    set_polar_cells(exact_frame_, digits > 50 ? PanelDesign{64, 60} : PanelDesign{32, 30}, cells_);
    scout();
    scouted_ = true;
  }
  Result<Mp200> sums = with_error(error_of(digits));
  finer_ = !finer_;
  return sums;
}

}  // namespace cageproof::quadrature_ref
