// SPDX-License-Identifier: MIT
// Closed forms on segments against integrals of kernels that tests state themselves, and in double against themselves
// in 100 digits.
#pragma once

#include "cageproof/closed_form/segment/engine/closed_form.h"
#include "segment_kernels.h"
#include "thinned.h"

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

/// Per order, the truth's norm and the conditioned error in units of u. `moved` holds, per input, the difference that a
/// step makes, divided by the step, times the input.
struct ConditionedErrors {
  std::array<double, 3> truth{}, error{};
};

template <class F>
ConditionedErrors conditioned_errors(const SegmentSample& sample, Parameters given = {}) {
  const std::vector<Mp100> parameters(given.begin(), given.end());
  const auto truth = evaluate<F, Mp100>(sample, given);
  std::array<Mp100, 3> size;
  for (int o = 0; o <= 2; ++o) size[o] = norm(part(truth, o));
  const Mp100 step("1e-60");
  std::array<Vec3<Mp100>, 3> inputs{convert<Mp100>(sample.s[0]), convert<Mp100>(sample.s[1]),
                                    convert<Mp100>(sample.point)};
  ConditionedErrors errors;
  for (int o = 0; o <= 2; ++o) errors.truth[o] = static_cast<double>(size[o]);
  for (Vec3<Mp100>& v : inputs)
    for (int c = 0; c < 2; ++c) {
      const Mp100 kept = v[c], move = step * kept;
      if (kept == 0) continue;
      v[c] = kept + move;
      // One evaluation has all orders.
      const auto moved = closed_form<F, 2, Mp100>({inputs[0], inputs[1]}, inputs[2], parameters);
      v[c] = kept;
      for (int o = 0; o <= 2; ++o) size[o] += norm(difference<Mp100>(part(moved, o), part(truth, o))) / step;
    }
  const auto found = evaluate<F, double>(sample, given);
  for (int o = 0; o <= 2; ++o) {
    const Mp100 off = norm(difference<Mp100>(part(truth, o), part(found, o)));
    const double error = static_cast<double>(Mp100(off / size[o] / Mp100(unit_roundoff<double>())));
    errors.error[o] = std::isnan(error) ? std::numeric_limits<double>::infinity() : error;
  }
  return errors;
}

template <class F>
double conditioned_error(const SegmentSample& sample, int order, Parameters given = {}) {
  return conditioned_errors<F>(sample, given).error[order];
}

template <class F, class K>
void expect_exact_in_all_regimes(std::array<double, 3> promise, const K& kernel = {}, Parameters given = {}) {
  for (const auto& [name, make] : segment_regimes()) {
    std::array<double, 3> worst{};
    std::array<int, 3> measured{};
    for (int i = 0; i < 96; i += test_stride()) {
      const SegmentSample sample = make(i);
      if (i % 13 == 0) expect_integral<F, K>(sample, name + ", sample " + std::to_string(i), kernel, given);
      const ConditionedErrors errors = conditioned_errors<F>(sample, given);
      for (int o = 0; o <= 2; ++o) {
        // Powers of lengths may leave a double's range.
        if (!(errors.truth[o] > 1e-290 && errors.truth[o] < 1e300)) continue;
        ++measured[o];
        worst[o] = std::max(worst[o], errors.error[o]);
      }
    }
    for (int o = 0; o <= 2; ++o) {
      // Far away terms cancel, and double's result is taken until its bound is a thousand units: the table's promise.
      EXPECT_LE(worst[o], name == "far" ? 64 : promise[o]) << name << ", order " << o;
      EXPECT_GE(measured[o], 20 / test_stride()) << name << ", order " << o;
    }
    testing::Test::RecordProperty(
        name, std::to_string(worst[0]) + " " + std::to_string(worst[1]) + " " + std::to_string(worst[2]));
  }
}

}  // namespace cageproof::closed_form::segment
