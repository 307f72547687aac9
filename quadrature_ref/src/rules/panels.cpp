// SPDX-License-Identifier: MIT
#include "panels.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace cageproof::quadrature_ref {
namespace {

constexpr double kGrowth = 4;

// Sum of the half axes of the ellipse with foci lo, hi through z.
double ellipse_through(double lo, double hi, std::complex<double> z) {
  const double half = (hi - lo) / 2;
  if (!(half > 0)) return std::numeric_limits<double>::infinity();
  const std::complex<double> y = (z - (lo + hi) / 2) / half;
  const std::complex<double> root = std::sqrt(y * y - 1.0);
  return std::max(std::abs(y + root), std::abs(y - root));
}

}  // namespace

int nodes_for(double lo, double hi, const Singularities& singular, double digits) {
  double widest = 1e3;
  for (const std::complex<double>& z : singular) widest = std::min(widest, ellipse_through(lo, hi, z));
  const double half = (hi - lo) / 2;
  double least = std::numeric_limits<double>::infinity();
  // Ellipses rho = widest^(j/16): close to the singularity f is larger than the model, so the outermost is left out.
  for (int j = 4; j < 16; ++j) {
    const double log_rho = std::log(widest) * j / 16;
    const double growth = kGrowth * half * (std::cosh(log_rho) - 1);
    least = std::min(least, (digits * std::numbers::ln10 + growth) / (2 * log_rho));
  }
  return std::isfinite(least) ? std::max(1, static_cast<int>(std::ceil(std::min(least, 1e6)))) : 1;
}

void set_panel_ends(double lo, double hi, const Singularities& singular, const PanelDesign& design,
                    std::vector<double>& ends) {
  const auto fits = [&](double from, double to) {
    return nodes_for(from, to, singular, design.digits) <= design.nodes;
  };
  ends.assign(1, lo);
  while (!fits(ends.back(), hi)) {
    double step = 0.05, too_long = hi - ends.back();
    while (too_long > 1.05 * step) {
      const double middle = std::sqrt(step * too_long);
      (fits(ends.back(), ends.back() + middle) ? step : too_long) = middle;
    }
    ends.push_back(ends.back() + step);
  }
  ends.push_back(hi);
}

}  // namespace cageproof::quadrature_ref
