// SPDX-License-Identifier: MIT
#include "spherical_derivatives.h"

#include "cageproof/core/geometry/quad_geometry.h"

#include <algorithm>

namespace cageproof::adaptive_qmvc {
namespace {

using Wide = SecondOrder<Mp200>;
using Point = Vec3<Mp200>;

// Below this, derivatives in 200 digits have lost about half of them.
constexpr double kVanished = 1e-40;

CornerWeights<Wide> unknown(const CornerWeights<Wide>& w) {
  return without_derivatives<Wide>({w[0].value, w[1].value, w[2].value, w[3].value});
}

// Derivatives of weights that are odd in the distance from a plane, at it: along the normal, and mixed ones.
struct OddDerivatives {
  Mp200 slope;  // along the normal
  Point mixed;  // of the slope, within the plane
};

std::array<OddDerivatives, 4> odd_derivatives(const CornerWeights<Wide>& w, const Point& normal) {
  std::array<OddDerivatives, 4> found;
  for (std::size_t k = 0; k < 4; ++k) {
    Point gradient, along;
    for (std::size_t i = 0; i < 3; ++i) {
      gradient[i] = w[k].gradient[i];
      along[i] = 0;
      for (std::size_t j = 0; j < 3; ++j) along[i] += w[k].hessian[Wide::entry(i, j)] * normal[j];
    }
    found[k].slope = gradient.dot(normal);
    found[k].mixed = along - along.dot(normal) * normal;
  }
  return found;
}

bool agree(const std::array<OddDerivatives, 4>& a, const std::array<OddDerivatives, 4>& b) {
  constexpr double kSame = 1e-60;
  Mp200 slopes = 0, mixed = 0, slope_difference = 0, mixed_difference = 0;
  for (std::size_t k = 0; k < 4; ++k) {
    slopes += a[k].slope * a[k].slope;
    mixed += a[k].mixed.squaredNorm();
    slope_difference += (a[k].slope - b[k].slope) * (a[k].slope - b[k].slope);
    mixed_difference += (a[k].mixed - b[k].mixed).squaredNorm();
  }
  return slope_difference <= kSame * slopes && mixed_difference <= kSame * mixed;
}

// Next to the plane the weights are an odd function of the height above it, so that derivatives in the plane differ
// from those a little above by the square of that height. Where two heights disagree, no such function exists.
CornerWeights<Wide> in_plane(const Quad<Mp200>& q, const Point& eta) {
  Mp200 extent = 0;
  for (const Point& corner : q) extent = std::max(extent, Mp200((corner - eta).norm()));
  const Point normal = Point((q[2] - q[0]).cross(q[3] - q[1])).normalized();
  const Mp200 height = normal.dot(eta - q[0]);
  const auto above = [&](double step) {
    return odd_derivatives(SphericalQuad<Wide>(q, Point(eta + (step * extent - height) * normal)).weights, normal);
  };
  const auto low = above(1e-40), high = above(3e-40);
  CornerWeights<Wide> weights;
  for (std::size_t k = 0; k < 4; ++k) {
    weights[k].value = low[k].slope * height;
    for (std::size_t i = 0; i < 3; ++i) {
      weights[k].gradient[i] = low[k].slope * normal[i] + height * low[k].mixed[i];
      for (std::size_t j = i; j < 3; ++j)
        weights[k].hessian[Wide::entry(i, j)] = low[k].mixed[i] * normal[j] + low[k].mixed[j] * normal[i];
    }
  }
  return agree(low, high) ? weights : unknown(weights);
}

}  // namespace

CornerWeights<Wide> spherical_weights_in_200_digits(const Quad<double>& q, const Point& eta) {
  const Quad<Mp200> corners{convert<Mp200>(q[0]), convert<Mp200>(q[1]), convert<Mp200>(q[2]), convert<Mp200>(q[3])};
  const SphericalQuad<Wide> plain(corners, eta);
  if (plain.remainder > kVanished) return plain.weights;
  if (is_planar(q)) return in_plane(corners, eta);
  return unknown(plain.weights);
}

}  // namespace cageproof::adaptive_qmvc
