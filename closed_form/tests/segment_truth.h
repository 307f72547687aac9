// SPDX-License-Identifier: MIT
// Closed forms on segments against integrals of kernels that tests state themselves, and in double against themselves
// in 100 digits.
#pragma once

#include "cageproof/closed_form/segment/engine/closed_form.h"
#include "segment_kernels.h"

#include <gtest/gtest.h>

namespace cageproof::closed_form::segment {

template <class F, Scalar R>
using Tensors = Jet<R, F::components, 2>;

using Parameters = std::span<const double>;

/// The closed form in R. \param given its parameters
template <class F, Scalar R>
Tensors<F, R> evaluate(const SegmentSample& sample, Parameters given = {}) {
  const std::vector<R> parameters(given.begin(), given.end());
  return closed_form<F, 2, R>({convert<R>(sample.s[0]), convert<R>(sample.s[1])}, convert<R>(sample.point), parameters);
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
      // Far away terms cancel, and double's result is taken until its bound is a thousand units: the table's promise.
      EXPECT_LE(worst[o], name == "far" ? 64 : promise[o]) << name << ", order " << o;
      EXPECT_GE(measured[o], 20) << name << ", order " << o;
    }
    testing::Test::RecordProperty(
        name, std::to_string(worst[0]) + " " + std::to_string(worst[1]) + " " + std::to_string(worst[2]));
  }
}

}  // namespace cageproof::closed_form::segment
