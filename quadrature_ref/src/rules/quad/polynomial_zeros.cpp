// SPDX-License-Identifier: MIT
#include "polynomial_zeros.h"

#include <cmath>

namespace cageproof::quadrature_ref {
namespace {

using ComplexDouble = std::complex<double>;

// Start values: each segment of the Newton polygon's upper hull gives one per unit of its length, on its radius.
std::vector<ComplexDouble> starts(const std::array<double, 5>& c, int degree) {
  std::vector<ComplexDouble> zeros;
  for (int i = 0; i < degree;) {
    int next = i + 1;
    double steepest = -1e300;
    for (int j = i + 1; j <= degree; ++j) {
      if (c[j] == 0) continue;
      const double slope = (std::log(std::abs(c[j])) - std::log(std::abs(c[i]))) / (j - i);
      if (slope >= steepest) {
        steepest = slope;
        next = j;
      }
    }
    for (int k = i; k < next; ++k)
      zeros.push_back(std::polar(std::exp(-steepest), 0.7 + 2 * k + 6.2831853 * k / degree));
    i = next;
  }
  return zeros;
}

}  // namespace

std::vector<ComplexDouble> polynomial_zeros(const std::array<double, 5>& coefficients) {
  const std::array<double, 5>& c = coefficients;
  int degree = 4;
  while (degree > 0 && !(std::abs(c[degree]) > std::abs(c[0]) * 1e-240)) --degree;
  std::vector<ComplexDouble> zeros = starts(c, degree);
  for (int step = 0; step < 80; ++step) {
    double change = 0;
    for (int i = 0; i < degree; ++i) {
      // For a zero outside the unit circle the inverse is iterated, because its powers cannot overflow.
      const ComplexDouble z = zeros[i];
      const bool outside = std::abs(z) > 1;
      const ComplexDouble y = outside ? 1. / z : z;
      ComplexDouble value = 0, slope = 0;
      for (int k = 0; k <= degree; ++k) {
        slope = slope * y + value;
        value = value * y + c[outside ? k : degree - k];
      }
      if (value == 0.) continue;
      ComplexDouble newton = slope / value;  // of the polynomial in y
      if (outside) newton = static_cast<double>(degree) * y - y * y * newton;
      for (int j = 0; j < degree; ++j)
        if (j != i) newton -= 1. / (z - zeros[j]);
      const ComplexDouble move = 1. / newton;
      if (!std::isfinite(move.real()) || !std::isfinite(move.imag())) continue;
      zeros[i] -= move;
      change = std::max(change, std::abs(move) / std::abs(zeros[i]));
    }
    if (change < 1e-10) break;
  }
  return zeros;
}

}  // namespace cageproof::quadrature_ref
