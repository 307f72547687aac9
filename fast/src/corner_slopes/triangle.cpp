// SPDX-License-Identifier: MIT
#include "cageproof/core/numbers/gauss_legendre.h"
#include "cageproof/core/numbers/linear.h"
#include "cageproof/fast/layer_slopes.h"

#include <cmath>
#include <limits>
#include <numbers>

namespace cageproof::fast {
namespace {

using Vec = Vec3<double>;
constexpr double kQuarterPi = 1 / (4 * std::numbers::pi);

// Integrals over a side of 1/r and 1/r^3 with its ends' hat functions.
struct SideMoments {
  std::array<double, 2> of_inverse;
  std::array<double, 3> of_cube;  // of both ends': first twice, both, second twice
};

// \param a, b the ends seen from the point
SideMoments side_moments(const Vec& a, const Vec& b, double length, const Vec& along) {
  // Seen under small angles the logarithm and its companions cancel, and Gauss points are as good.
  constexpr double far = 1.5;
  if (const double distance = ((a + b) / 2).norm(); distance > far * length) {
    static const GaussLegendre<double>&many = gauss_legendre<double>(14), &some = gauss_legendre<double>(9),
                 &few = gauss_legendre<double>(6);
    const GaussLegendre<double>& rule = distance > 8 * length ? few : distance > 3 * length ? some : many;
    SideMoments found{};
    for (std::size_t i = 0; i < rule.nodes.size(); ++i) {
      const double v = rule.nodes[i], u = 1 - v, r = (u * a + v * b).norm(), w = rule.weights[i] * length / r;
      const double cube = w / (r * r);
      found.of_inverse[0] += u * w, found.of_inverse[1] += v * w;
      found.of_cube[0] += u * u * cube, found.of_cube[1] += u * v * cube, found.of_cube[2] += v * v * cube;
    }
    return found;
  }
  const double s0 = a.dot(along), s1 = b.dot(along), r0 = a.norm(), r1 = b.norm();
  const double square = along.cross(a).squaredNorm();  // of the distance from the line
  const bool spans = s0 < 0 && s1 > 0;
  // Of 1/r; of s/r; of 1/r^3, s/r^3 and s^2/r^3.
  const double inverse = spans     ? std::log((r1 + s1) * ((r0 - s0) / square))
                         : s0 >= 0 ? std::log((r1 + s1) / (r0 + s0))
                                   : std::log((r0 - s0) / (r1 - s1));
  const double first = length * (s0 + s1) / (r0 + r1);
  const double cube = spans ? (s1 / r1 - s0 / r0) / square : length * (s0 + s1) / (r0 * r1 * (s1 * r0 + s0 * r1));
  const double first_cube = first / (r0 * r1), second_cube = inverse - square * cube;
  const double l = length, l2 = length * length;
  return {{(s1 * inverse - first) / l, (first - s0 * inverse) / l},
          {(second_cube - 2 * s1 * first_cube + s1 * s1 * cube) / l2,
           (-second_cube + (s0 + s1) * first_cube - s0 * s1 * cube) / l2,
           (second_cube - 2 * s0 * first_cube + s0 * s0 * cube) / l2}};
}

// int Gamma_j (x - p).n/(4 pi r^3) = det/(4 pi) int Gamma_j/r^3 du dv, and int 1/(4 pi r), differentiated under the
// integral.
LayerSlopes by_gauss(const std::array<Vec, 3>& corners, const std::array<Vec, 3>& from_point, bool is_very_far) {
  static const GaussLegendre<double>&many = gauss_legendre<double>(8), &few = gauss_legendre<double>(5);
  const GaussLegendre<double>& rule = is_very_far ? few : many;
  const Vec first = corners[1] - corners[0], second = corners[2] - corners[0], across = first.cross(second);
  const double area_element = across.norm(), det = from_point[0].dot(across);
  std::array<double, 3> cubes{};
  std::array<std::array<Vec, 3>, 3> fifths;
  for (auto& row : fifths) row.fill(Vec::Zero());
  LayerSlopes found;
  found.single.fill(Vec::Zero());
  double whole = 0;
  for (std::size_t i = 0; i < rule.nodes.size(); ++i)
    for (std::size_t k = 0; k < rule.nodes.size(); ++k) {
      const double u = rule.nodes[i], v = (1 - u) * rule.nodes[k], w = rule.weights[i] * rule.weights[k] * (1 - u);
      const std::array<double, 3> hats{1 - u - v, u, v};
      const Vec y = from_point[0] + u * first + v * second;
      const double r = y.norm(), inverse = w / r, cube = inverse / (r * r);
      whole += inverse;
      for (int m = 0; m < 3; ++m) {
        found.single[m] -= hats[m] * cube * y;
        cubes[m] += hats[m] * cube;
        const Vec part = (3 * hats[m] * cube / (r * r)) * y;
        for (int j = 0; j < 3; ++j) fifths[j][m] -= hats[j] * part;
      }
    }
  for (int m = 0; m < 3; ++m) {
    const Vec side = corners[(m + 2) % 3] - corners[(m + 1) % 3];
    const Vec by_det = from_point[(m + 1) % 3].cross(side);
    // The area element's gradient is across/|across| x (corner m + 1 to corner m + 2), turned.
    const Vec by_area = side.cross(across) / -area_element;
    found.single[m] = kQuarterPi * (area_element * found.single[m] + whole * by_area);
    for (int j = 0; j < 3; ++j) found.doubled[j][m] = kQuarterPi * (cubes[j] * by_det + det * fifths[j][m]);
  }
  return found;
}

}  // namespace

LayerSlopes triangle_layer_slopes(const std::array<Vec, 3>& corners, const Vec& point, double single,
                                  const std::array<double, 3>& doubled) {
  std::array<Vec, 3> y, sides;
  double size = 0;
  for (int k = 0; k < 3; ++k) {
    y[k] = corners[k] - point;
    sides[k] = corners[(k + 1) % 3] - corners[k];
    size = std::max(size, sides[k].norm());
  }
  constexpr double far = 5;
  if (const double distance = ((y[0] + y[1] + y[2]) / 3).norm(); distance > far * size)
    return by_gauss(corners, y, distance > 25 * size);
  // From the corner between the two shorter sides, where least cancels.
  int widest = 0;
  for (int k = 1; k < 3; ++k)
    if (sides[(k + 1) % 3].norm() > sides[(widest + 1) % 3].norm()) widest = k;
  const Vec across = sides[widest].cross(-sides[(widest + 2) % 3]);
  const double twice_area = across.norm();
  const Vec n = across / twice_area;
  std::array<Vec, 3> gradients;  // of hat functions
  for (int k = 0; k < 3; ++k) gradients[k] = n.cross(sides[(k + 1) % 3]) / twice_area;
  LayerSlopes found;
  for (int m = 0; m < 3; ++m) {
    found.single[m] = -doubled[m] * n;
    for (int j = 0; j < 3; ++j)
      found.doubled[j][m] = single * gradients[j].dot(gradients[m]) * n - doubled[m] * gradients[j];
  }
  for (int e = 0; e < 3; ++e) {
    const double length = sides[e].norm();
    const Vec along = sides[e] / length, outward = along.cross(n), turn = along.cross(y[e]);
    const SideMoments of = side_moments(y[e], y[(e + 1) % 3], length, along);
    for (int end = 0; end < 2; ++end) {
      const int m = (e + end) % 3;
      const double moment = kQuarterPi * of.of_inverse[end];
      found.single[m] += moment * outward;
      for (int j = 0; j < 3; ++j) found.doubled[j][m] += moment * along.cross(gradients[j]);
      for (int other = 0; other < 2; ++other)
        found.doubled[(e + other) % 3][m] += kQuarterPi * of.of_cube[end + other] * turn;
    }
  }
  return found;
}

}  // namespace cageproof::fast
