// SPDX-License-Identifier: MIT
// Conventions are found by solving, named in one sentence, and undone exactly.
#include "cageproof/judge/convention.h"

#include "cageproof/validation/regime.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>

namespace cageproof::judge {
namespace {

using Change = std::function<void(const Query<double>&, Result<double>&)>;

// The closed form, changed.
Evaluation changed(std::string_view formula, Change change) {
  const Evaluation closed = evaluation_named(formula, "closed_form");
  Evaluation evaluation(formula, "changed", {.description = "test", .role = Role::Foreign, .max_order = 1});
  evaluation.set_point<double>(
      [closed, change = std::move(change)](const Query<double>& query, Result<double>& result) {
        closed(query, result);
        change(query, result);
      });
  return evaluation;
}

void scale(Result<double>& result, double factor) {
  for (int o = 0; o < 2; ++o)
    for (double& x : result.of(o)) x *= factor;
}

// Holds `theirs` in its convention against the closed form at fresh samples.
void expect_undone(const Evaluation& theirs, const Convention& convention) {
  const Evaluation ours = in_our_convention(theirs, convention);
  const Evaluation closed = evaluation_named(convention.formula, "closed_form");
  for (std::uint64_t i = 0; i < 4; ++i) {
    auto sample = make_sample(closed.formula(), *validation::find_regime("generic"), 77, i);
    if (!sample.parameters.empty()) sample.parameters = {1.5, 0.125};
    const auto found = validation::evaluate<double>(ours, sample, 1);
    const auto wanted = validation::evaluate<double>(closed, sample, 1);
    for (int o = 0; o < 2; ++o)
      for (std::size_t k = 0; k < wanted.of(o).size(); ++k)
        EXPECT_NEAR(found.of(o)[k], wanted.of(o)[k], 1e-12 * (1 + std::abs(wanted.of(o)[k]))) << o << ' ' << k;
  }
}

void expect_sentence(const Evaluation& theirs, std::string_view sentence) {
  const auto convention = find_convention(theirs, 1);
  ASSERT_TRUE(convention);
  EXPECT_EQ(convention->sentence, sentence);
  expect_undone(theirs, *convention);
}

TEST(conventions, constants_have_names) {
  constexpr double pi = std::numbers::pi;
  EXPECT_EQ(name_of_constant(1), "1");
  EXPECT_EQ(name_of_constant(-1 / (4 * pi)), "-1/(4 pi)");
  EXPECT_EQ(name_of_constant(4 * pi), "4 pi");
  EXPECT_EQ(name_of_constant(pi), "pi");
  EXPECT_EQ(name_of_constant(1 / pi), "1/pi");
  EXPECT_EQ(name_of_constant(3 / (8 * pi)), "3/(8 pi)");
  EXPECT_EQ(name_of_constant(-0.5), "-1/2");
  EXPECT_EQ(name_of_constant(2.0 / 3), "2/3");
  EXPECT_EQ(name_of_constant(3.7), "");
  EXPECT_EQ(name_of_constant(4 * pi * (1 + 1e-6)), "");
}

TEST(conventions, corners_factor_and_sign_of_derivatives_at_once) {
  const Evaluation theirs = changed("triangle.affine_single_layer", [](const auto&, Result<double>& r) {
    scale(r, 4 * std::numbers::pi);
    std::rotate(r.value.begin(), r.value.begin() + 2, r.value.end());
    std::rotate(r.gradient.begin(), r.gradient.begin() + 6, r.gradient.end());
    for (double& x : r.gradient) x = -x;
  });
  expect_sentence(theirs,
                  "yours is ours times 4 pi, with corners in the order 3, 1, 2, and derivatives by the element's "
                  "position instead of the point's");
}

TEST(conventions, matrices_by_columns_and_elastic_moduli) {
  const Evaluation theirs = changed("triangle.kelvin_traction", [](const Query<double>& q, Result<double>& r) {
    Result<double> turned = r;
    for (std::size_t k = 0; k < 27; ++k) {
      const std::size_t from = k / 9 * 9 + k % 3 * 3 + k % 9 / 3;
      turned.value[k] = r.value[from];
      for (std::size_t i = 0; i < 3 && !r.gradient.empty(); ++i) turned.gradient[3 * k + i] = r.gradient[3 * from + i];
    }
    r = turned;
    scale(r, (1 - q.parameters[1]) * 8);
  });
  expect_sentence(theirs, "yours is ours times 8 (1 - nu), with rows and columns swapped");
}

TEST(conventions, gradients_stored_by_the_derivative) {
  const Evaluation theirs = changed("triangle.double_layer", [](const auto&, Result<double>& r) {
    const auto g = r.gradient;
    for (std::size_t c = 0; c < 3 && !g.empty(); ++c)
      for (std::size_t i = 0; i < 3; ++i) r.gradient[3 * i + c] = g[3 * c + i];
  });
  expect_sentence(theirs, "yours is ours, and gradients stored with the derivative's index first");
}

TEST(conventions, angles_in_place_of_half_angles) {
  expect_sentence(changed("triangle.mean_value", [](const auto&, Result<double>& r) { scale(r, 2); }),
                  "yours is ours times 2 (angles in place of half angles)");
}

TEST(conventions, a_constant_without_a_name_is_still_one) {
  expect_sentence(changed("segment.single_layer", [](const auto&, Result<double>& r) { scale(r, 3.7); }),
                  "yours is ours times 3.7 (a constant without a name)");
}

TEST(conventions, normalised_values_and_their_gradients) {
  const Evaluation theirs = changed("segment.mean_value", [](const auto&, Result<double>& r) {
    const double sum = r.value[0] + r.value[1];
    for (double& x : r.value) x /= sum;
    for (std::size_t i = 0; i < 2 && !r.gradient.empty(); ++i) {
      const double by_i = r.gradient[i] + r.gradient[2 + i];
      for (std::size_t c = 0; c < 2; ++c) r.gradient[2 * c + i] = (r.gradient[2 * c + i] - r.value[c] * by_i) / sum;
    }
  });
  expect_sentence(theirs, "yours is ours, divided by the sum over the corners");
}

TEST(conventions, none_depends_on_the_sample) {
  EXPECT_FALSE(
      find_convention(changed("triangle.solid_angle",
                              [](const Query<double>& q, Result<double>& r) { scale(r, 1 + 1e-6 * q.point[0]); }),
                      1));
  EXPECT_FALSE(find_convention(changed("triangle.double_layer",
                                       [](const Query<double>& q, Result<double>& r) {
                                         if (q.point[0] > 0) std::swap(r.value[0], r.value[1]);
                                       }),
                               1));
}

TEST(conventions, a_gradient_that_fits_none_is_not_claimed) {
  const auto found = find_convention(changed("triangle.solid_angle",
                                             [](const auto&, Result<double>& r) {
                                               for (double& x : r.gradient) x *= 2;
                                             }),
                                     1);
  ASSERT_TRUE(found);
  EXPECT_EQ(found->sentence, "yours is ours");
  EXPECT_FALSE(found->gradient_known);
}

}  // namespace
}  // namespace cageproof::judge
