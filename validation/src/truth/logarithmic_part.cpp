// SPDX-License-Identifier: MIT
#include "truth/logarithmic_part.h"

#include "cageproof/core/geometry/exact_geometry.h"
#include "cageproof/core/numbers/gauss_legendre.h"

#include <array>
#include <cmath>

namespace cageproof::validation {
namespace {

// Powers of distances leave double's range where the factor before them brings the product back.
using Wide = long double;
using PlaneVec = std::array<Wide, 2>;

// r^(2 m) as a function of the point, x = xi - eta: itself, its gradient -2 m r^(2m - 2) x, its Hessian.
struct EvenPower {
  Wide value, slope, bend;  // the Hessian is slope I + bend x x', the gradient -slope x

  EvenPower(Wide square, int m)
      : value(std::pow(square, m)),
        slope(m == 0 ? 0 : 2 * m * std::pow(square, m - 1)),
        bend(m < 2 ? 0 : 4 * m * (m - 1) * std::pow(square, m - 2)) {}
  Wide gradient(const PlaneVec& x, int i) const { return -slope * x[i]; }
  Wide hessian(const PlaneVec& x, int i, int j) const { return bend * x[i] * x[j] + (i == j ? slope : 0); }
};

// The derivatives of a point's share, one number after the other.
std::vector<Wide> share(const Logarithm& logarithm, const PlaneVec& x, const PlaneVec& n, Wide height, int order) {
  const EvenPower p(x[0] * x[0] + x[1] * x[1], logarithm.squares);
  const Wide h = logarithm.height ? height : 1;
  const PlaneVec dh = logarithm.height ? PlaneVec{-n[0], -n[1]} : PlaneVec{0, 0};
  if (order == 0) return {h * p.value};
  std::vector<Wide> derivatives;
  for (int i = 0; i < 2; ++i) {
    if (order == 1) derivatives.push_back(h * p.gradient(x, i) + (logarithm.height ? dh[i] * p.value : 0));
    for (int j = 0; order == 2 && j < 2; ++j)
      derivatives.push_back(h * p.hessian(x, i, j) + dh[i] * p.gradient(x, j) + dh[j] * p.gradient(x, i));
  }
  return derivatives;
}

}  // namespace

std::vector<double> logarithmic_part(const Logarithm& logarithm, const Shape& shape,
                                     std::span<const Vec3<double>> corners, const Vec3<double>& point, int order) {
  const int components = (shape.per_corner ? 2 : 1) * shape.entries();
  const std::size_t derivatives = order == 0 ? 1 : order == 1 ? 2 : 4;
  std::vector<double> part(components * derivatives, 0.0);
  const Vec3<double>&a = corners[0], e = corners[1] - a, from = a - point;
  const double length = e.stableNorm();
  const PlaneVec n{e[1] / length, -e[0] / length};
  // Exact: on the line a rounding would be all of it.
  const ExactSegment exact({convert<Mp200>(a), convert<Mp200>(corners[1])}, convert<Mp200>(point));
  const auto height = -static_cast<double>(Mp200(exact.cross / Mp200(length)));
  const auto& rule = gauss_legendre<double>(12);
  for (std::size_t k = 0; k < rule.nodes.size(); ++k) {
    const double t = rule.nodes[k];
    const PlaneVec x{Wide(from[0] + t * e[0]), Wide(from[1] + t * e[1])};
    const std::vector<Wide> one = share(logarithm, x, n, height, order);
    const Wide weight = rule.weights[k] * length * logarithm.factor;
    for (int component = 0; component < components; ++component) {
      const int entry = component % shape.entries();
      if (entry % (shape.columns + 1) != 0) continue;
      const double hat = !shape.per_corner ? 1 : component < shape.entries() ? 1 - t : t;
      for (std::size_t d = 0; d < derivatives; ++d)
        part[component * derivatives + d] += static_cast<double>(weight * hat * one[d]);
    }
  }
  return part;
}

}  // namespace cageproof::validation
