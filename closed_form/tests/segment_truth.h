// SPDX-License-Identifier: MIT
// Closed forms on segments against integrals of kernels that tests state themselves, and in double against themselves
// in 100 digits.
#pragma once

#include "cageproof/closed_form/segment/engine/closed_form.h"
#include "segment_samples.h"

#include <gtest/gtest.h>

namespace cageproof::closed_form::segment {

template <class F, Scalar R>
using Tensors = Jet<R, F::components, 2>;

/// The parts of derivative order o, one number after the other.
template <Scalar R, int C>
std::vector<R> part(const Jet<R, C, 2>& jet, int order) {
  std::vector<R> x;
  for (int c = 0; c < C; ++c) {
    if (order == 0) x.push_back(jet.value[c]);
    for (int i = 0; i < 2; ++i) {
      if (order == 1) x.push_back(jet.gradient[c][i]);
      for (int j = 0; order == 2 && j < 2; ++j) x.push_back(jet.hessian[c](i, j));
    }
  }
  return x;
}

template <Scalar R>
R norm(const std::vector<R>& x) {
  R sum = 0;
  for (const R& y : x) sum += y * y;
  using std::sqrt;
  return sqrt(sum);
}

template <Scalar R, Scalar S>
std::vector<R> difference(const std::vector<R>& a, const std::vector<S>& b) {
  std::vector<R> d;
  for (std::size_t i = 0; i < a.size(); ++i) d.push_back(R(a[i]) - R(b[i]));
  return d;
}

using Parameters = std::span<const double>;

/// The closed form in R. \param given its parameters
template <class F, Scalar R>
Tensors<F, R> evaluate(const SegmentSample& sample, Parameters given = {}) {
  const std::vector<R> parameters(given.begin(), given.end());
  return closed_form<F, 2, R>({convert<R>(sample.s[0]), convert<R>(sample.s[1])}, convert<R>(sample.point), parameters);
}

/// Over 2 pi, the integral of a kernel of the test's own, `add(weight, t, x, y, nx, ny, sum)`, over panels that double
/// away from the point of the segment that is nearest. Their integrands are analytic one panel's length around.
template <class K>
Jet<Mp100, K::components, 2> integral(const SegmentSample& sample, const K& kernel = {}) {
  const auto& rule = gauss_legendre<Mp100>(60);
  const Vec3<Mp100> a = convert<Mp100>(sample.s[0]), e = convert<Mp100>(sample.s[1]) - a,
                    from = convert<Mp100>(sample.point) - a;
  const Mp100 length = sqrt(Mp100(e.dot(e))), nx = e[1] / length, ny = -e[0] / length;
  const Mp100 nearest = std::clamp(Mp100(from.dot(e) / e.dot(e)), Mp100(0), Mp100(1));
  const Vec3<Mp100> arm = from - nearest * e;
  const Mp100 first = sqrt(Mp100(arm.dot(arm))) / length;
  Jet<Mp100, K::components, 2> sum;
  for (const int side : {-1, 1}) {
    const Mp100 whole = side > 0 ? Mp100(1 - nearest) : nearest;
    Mp100 begin = 0, width = first;
    while (begin < whole) {
      const Mp100 end = std::min(Mp100(begin + width), whole);
      for (std::size_t j = 0; j < rule.nodes.size(); ++j) {
        const Mp100 step = side * (begin + (end - begin) * rule.nodes[j]), t = nearest + step;
        // From the nearest point, where differences are small.
        kernel.add(rule.weights[j] * (end - begin) * length, t, step * e[0] - arm[0], step * e[1] - arm[1], nx, ny,
                   sum);
      }
      begin = end;
      width *= 2;
    }
  }
  const Mp100 turn = 1 / (2 * pi<Mp100>());
  for (int c = 0; c < K::components; ++c) {
    sum.value[c] *= turn;
    sum.gradient[c] *= turn;
    sum.hessian[c] *= turn;
  }
  return sum;
}

template <class F, class K>
void expect_integral(const SegmentSample& sample, const std::string& what, const K& kernel = {},
                     Parameters given = {}) {
  const auto found = evaluate<F, Mp100>(sample, given);
  const auto truth = integral<K>(sample, kernel);
  for (int o = 0; o <= 2; ++o) {
    const auto t = part(truth, o);
    EXPECT_LE(static_cast<double>(norm(difference<Mp100>(t, part(found, o))) / norm(t)), 1e-30)
        << what << ", order " << o;
  }
}

/// The conditioned error of an order in units of u; `moved` are the differences for a step of each input, over the
/// step, times the input.
template <class F>
double conditioned_error(const SegmentSample& sample, int order, Parameters given = {}) {
  const std::vector<Mp100> parameters(given.begin(), given.end());
  const auto truth = part(evaluate<F, Mp100>(sample, given), order);
  Mp100 size = norm(truth);
  const Mp100 step("1e-60");
  std::array<Vec3<Mp100>, 3> inputs{convert<Mp100>(sample.s[0]), convert<Mp100>(sample.s[1]),
                                    convert<Mp100>(sample.point)};
  for (Vec3<Mp100>& v : inputs)
    for (int c = 0; c < 2; ++c) {
      const Mp100 kept = v[c], move = step * kept;
      if (kept == 0) continue;
      v[c] = kept + move;
      const auto moved = part(closed_form<F, 2, Mp100>({inputs[0], inputs[1]}, inputs[2], parameters), order);
      v[c] = kept;
      size += norm(difference<Mp100>(moved, truth)) / step;
    }
  const auto found = part(evaluate<F, double>(sample, given), order);
  const double error =
      static_cast<double>(Mp100(norm(difference<Mp100>(truth, found)) / size / Mp100(unit_roundoff<double>())));
  return std::isnan(error) ? std::numeric_limits<double>::infinity() : error;
}

template <class F, class K>
void expect_exact_in_all_regimes(std::array<double, 3> promise, const K& kernel = {}, Parameters given = {}) {
  for (const auto& [name, make] : segment_regimes()) {
    std::array<double, 3> worst{};
    std::array<int, 3> measured{};
    for (int i = 0; i < 96; ++i) {
      const SegmentSample sample = make(i);
      if (i % 13 == 0) expect_integral<F, K>(sample, name + ", sample " + std::to_string(i), kernel, given);
      for (int o = 0; o <= 2; ++o) {
        // Powers of lengths may leave a double's range.
        const auto size = static_cast<double>(norm(part(evaluate<F, Mp100>(sample, given), o)));
        if (!(size > 1e-290 && size < 1e300)) continue;
        ++measured[o];
        worst[o] = std::max(worst[o], conditioned_error<F>(sample, o, given));
      }
    }
    for (int o = 0; o <= 2; ++o) {
      EXPECT_LE(worst[o], promise[o]) << name << ", order " << o;
      EXPECT_GE(measured[o], 20) << name << ", order " << o;
    }
    testing::Test::RecordProperty(
        name, std::to_string(worst[0]) + " " + std::to_string(worst[1]) + " " + std::to_string(worst[2]));
  }
}

}  // namespace cageproof::closed_form::segment
