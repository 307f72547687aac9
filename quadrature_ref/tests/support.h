// SPDX-License-Identifier: MIT
// Helpers that the room's tests share: evaluating by name, norm-wise comparison, and one sample of every regime.
#pragma once

#include "cageproof/core/catalogue/evaluation.h"
#include "cageproof/core/numbers/random_stream.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>

namespace cageproof::quadrature_ref {

inline const std::array<std::string, 6> kFormulas{"triangle.single_layer",
                                                  "triangle.double_layer",
                                                  "triangle.solid_angle",
                                                  "triangle.biharmonic_single_layer",
                                                  "triangle.biharmonic_double_layer",
                                                  "triangle.mean_value"};

struct Sample {
  std::string regime;
  Triangle<double> corners;
  Vec3<double> point;
};

template <Scalar R>
Result<R> evaluate(const std::string& formula, const std::string& evaluation, const Triangle<R>& corners,
                   const Vec3<R>& point, int order) {
  const auto found = EvaluationRegister::instance().find(formula, evaluation);
  if (!found) throw std::runtime_error("no evaluation " + evaluation + " of " + formula);
  Result<R> result;
  (*found)(Query<R>{corners, point, order}, result);
  return result;
}

template <Scalar R>
Result<R> evaluate(const std::string& formula, const std::string& evaluation, const Sample& sample, int order) {
  const auto& c = sample.corners;
  return evaluate<R>(formula, evaluation, {convert<R>(c[0]), convert<R>(c[1]), convert<R>(c[2])},
                     convert<R>(sample.point), order);
}

template <Scalar R>
double log10_of(const R& x) {
  using std::log10;
  return x == 0 ? -1e9 : static_cast<double>(R(log10(x)));
}

/// log10 of |a - b| / |b|, norm-wise; -1e9 where they are equal.
template <Scalar A, Scalar B>
double log10_error(const std::vector<A>& a, const std::vector<B>& b) {
  using std::sqrt;
  EXPECT_EQ(a.size(), b.size());
  Mp100 difference = 0, norm = 0;
  for (std::size_t i = 0; i < b.size(); ++i) {
    const auto away = Mp100(a[i]) - Mp100(b[i]);
    difference += away * away;
    norm += Mp100(b[i]) * Mp100(b[i]);
  }
  if (difference == 0) return -1e9;
  return log10_of(Mp100(sqrt(Mp100(difference / norm))));
}

/// A point at every distance from every feature, slivers, needles, far, scaled and moved.
inline std::vector<Sample> regime_samples(std::uint64_t seed) {
  RandomStream random(seed, "quadrature-regimes", 0);
  const auto uniform = [&](double low, double high) { return random.uniform(low, high); };
  const auto direction = [&] { return Vec3<double>(uniform(-1, 1), uniform(-1, 1), uniform(-1, 1)).normalized(); };
  std::vector<Sample> samples;
  for (const double h : {1e-1, 1e-4, 1e-9, 1e-16}) {
    const Triangle<double> t{Vec3<double>(uniform(0, .2), uniform(0, .2), uniform(0, .2)),
                             Vec3<double>(uniform(.9, 1.2), uniform(0, .2), uniform(-.3, .3)),
                             Vec3<double>(uniform(.2, .8), uniform(.7, 1), uniform(-.3, .3))};
    const Vec3<double> n = (t[1] - t[0]).cross(t[2] - t[0]).normalized();
    const Vec3<double> u = (t[1] - t[0]).normalized();
    const double angle = uniform(0, 6.28);
    const Vec3<double> across = std::cos(angle) * u.cross(n) + std::sin(angle) * n;
    const Vec3<double> centroid = (t[0] + t[1] + t[2]) / 3;
    samples.push_back({"near-face", t, centroid + .1 * (t[1] - t[0]) - h * n});
    samples.push_back({"near-edge", t, t[0] + uniform(.2, .8) * (t[1] - t[0]) + h * across});
    samples.push_back({"near-line", t, t[0] - uniform(.2, .8) * (t[1] - t[0]) + h * across});
    samples.push_back({"near-vertex", t, t[1] + h * direction()});
    samples.push_back({"near-plane", t, centroid + 1.1 * u.cross(n) + h * n});
    samples.push_back({"generic", t, centroid + .8 * direction()});
    samples.push_back({"far", t, centroid + direction() * 1.6 / std::sqrt(h)});
    Triangle<double> thin = t;
    thin[2] = t[0] + .4 * (t[1] - t[0]) + std::max(h, 1e-10) * (t[2] - t[0]);
    samples.push_back({"sliver", thin, centroid + .3 * direction()});
    thin = t;
    thin[1] = t[0] + std::max(h, 1e-10) * (t[1] - t[0]);
    samples.push_back({"needle", thin, centroid + .5 * direction()});
    const double unit = h == 1e-1 ? 1e100 : h == 1e-4 ? 1e-100 : 1;
    const Vec3<double> move = h == 1e-9 ? Vec3<double>(3e8, -1e8, 2e8) : Vec3<double>(0, 0, 0);
    const auto moved = [&](const Vec3<double>& x) -> Vec3<double> { return unit * x + move; };
    samples.push_back({"scaled-or-moved", {moved(t[0]), moved(t[1]), moved(t[2])}, moved(centroid + .4 * n + .2 * u)});
  }
  return samples;
}

}  // namespace cageproof::quadrature_ref
