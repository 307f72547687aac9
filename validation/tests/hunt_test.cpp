// SPDX-License-Identifier: MIT
// Hunts are shown evaluations that are wrong at a known place.
#include "cageproof/validation/hunt.h"

#include "cageproof/core/input_error.h"
#include "cageproof/reports/worst_file.h"
#include "sampling/mutations.h"
#include "sampling/search_domain.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <tuple>

namespace cageproof::validation {
namespace {

const Formula& formula() { return *find_formula("triangle.single_layer"); }

// Distance to the line of the first edge, in lengths of it.
double edge_distance(std::span<const Vec3<double>> corners, const Vec3<double>& point) {
  const Vec3<double> edge = corners[1] - corners[0], to = point - corners[0];
  const double length = edge.stableNorm();
  const Vec3<double> along = edge / length;
  return along.cross(Vec3<double>(to / length)).norm();
}

// Adds an error of 1e-6 of the truth, largest at distance 1e-5 to the first edge: a peak one decade wide.
Evaluation with_peak() {
  const Evaluation good = evaluation_named(formula().name, "closed_form");
  Evaluation bad(formula().name, "closed_form", {.description = "wrong next to an edge", .role = Role::Recommended});
  bad.set_point<double>([good](const Query<double>& query, Result<double>& result) {
    good(query, result);
    const double decades = std::log10(edge_distance(query.corners, query.point)) + 5;
    for (double& x : result.value) x *= 1 + 1e-6 * std::exp(-decades * decades);
  });
  return bad;
}

HuntOptions peak_options() {
  HuntOptions options;
  options.formula = &formula();
  options.objectives = {{with_peak(), find_check("truth")}};
  options.regimes = "generic";  // 0.1 sizes away: the samples see exp(-16) of the peak
  options.budget = 1500;
  return options;
}

bool same(const HuntResult& a, const HuntResult& b) {
  return a.evaluations == b.evaluations && a.without_truth == b.without_truth &&
         std::ranges::equal(a.worst, b.worst, [](const HuntedCase& x, const HuntedCase& y) {
           return x.worst.error == y.worst.error && x.worst.corners == y.worst.corners &&
                  x.worst.point == y.worst.point && x.regime == y.regime && x.against_integral == y.against_integral;
         });
}

TEST(hunt, climbs_to_a_peak_that_samples_do_not_see) {
  const HuntOptions options = peak_options();
  const HuntResult found = hunt(options)[0];
  ASSERT_EQ(found.worst.size(), options.keep);
  EXPECT_LE(found.evaluations, options.budget);
  EXPECT_GT(found.evaluations, options.budget * 9 / 10);
  const WorstCase& worst = found.worst.front().worst;
  EXPECT_NEAR(std::log10(edge_distance(worst.corners, worst.point)), -5, 0.5);
  EXPECT_EQ(found.worst.front().regime, "generic");
  ASSERT_TRUE(found.worst.front().against_integral);
  EXPECT_LE(*found.worst.front().against_integral, 1e-30);
  // Most of the peak's height, where conditioning does not hide it.
  EXPECT_GT(worst.error, 1e-6 / unit_roundoff<double>() / 50);
}

TEST(hunt, is_the_same_for_any_number_of_threads) {
  HuntOptions options = peak_options();
  options.budget = 700;
  options.jobs = 1;
  const HuntResult one = hunt(options)[0];
  options.jobs = 2;
  EXPECT_TRUE(same(one, hunt(options)[0]));
  options.seed = 2;
  EXPECT_FALSE(same(one, hunt(options)[0]));
}

TEST(hunt, looks_for_several_things_at_once) {
  HuntOptions options = peak_options();
  const Evaluation good = evaluation_named(formula().name, "closed_form");
  options.objectives.push_back({evaluation_named(formula().name, "accurate"), find_check("relative")});
  options.objectives.push_back({Evaluation(formula().name, "nan_in_planes", good.facts()), find_check("truth")});
  options.objectives[2].evaluation.set_point<double>([good](const Query<double>& query, Result<double>& result) {
    good(query, result);
    if (query.point[2] == query.corners[1][2]) result.value[0] = std::numeric_limits<double>::quiet_NaN();
  });
  options.budget *= 3;
  const std::vector<HuntResult> found = hunt(options);
  ASSERT_EQ(found.size(), 3u);
  for (const HuntResult& result : found) {
    EXPECT_EQ(result.evaluations, found[0].evaluations);
    ASSERT_EQ(result.worst.size(), options.keep);
    for (std::size_t i = 1; i < result.worst.size(); ++i) {
      EXPECT_LE(result.worst[i].worst.error, result.worst[i - 1].worst.error);
      EXPECT_NE(std::tie(result.worst[i].worst.corners, result.worst[i].worst.point),
                std::tie(result.worst[i - 1].worst.corners, result.worst[i - 1].worst.point));
    }
  }
  EXPECT_GT(found[0].worst.front().worst.error, 1e-6 / unit_roundoff<double>() / 50);
  EXPECT_LT(found[1].worst.front().worst.error, 256);
  EXPECT_TRUE(std::isinf(found[2].worst.front().worst.error));
}

TEST(hunt, finds_results_that_are_not_finite) {
  HuntOptions options = peak_options();
  const Evaluation good = options.objectives[0].evaluation;
  options.objectives[0].evaluation.set_point<double>([good](const Query<double>& query, Result<double>& result) {
    good(query, result);
    if (query.point[2] == query.corners[1][2]) result.value[0] = std::numeric_limits<double>::quiet_NaN();
  });
  const HuntResult found = hunt(options)[0];
  EXPECT_TRUE(std::isinf(found.worst.front().worst.error));
}

TEST(hunt, finds_elements_in_planes_and_along_edges_of_the_axes) {
  // Wrong where several coordinates meet, which no number of random steps and no single snap brings about.
  const auto in_plane = [](const Query<double>& query) {
    for (int c = 0; c < 3; ++c)
      if (query.corners[0][c] == query.corners[1][c] && query.corners[0][c] == query.corners[2][c]) return true;
    return false;
  };
  const auto along_axis = [](const Query<double>& query) {
    const Vec3<double> edge = query.corners[1] - query.corners[0];
    return (edge.array() != 0).count() == 1;
  };
  const auto of_few_bits = [](const Query<double>& query) {
    for (const Vec3<double>& v : query.corners)
      for (const double x : v)
        if (512 * x != std::nearbyint(512 * x)) return false;
    return true;
  };
  using Place = std::function<bool(const Query<double>&)>;
  for (const Place& is_wrong : {Place(in_plane), Place(along_axis), Place(of_few_bits)}) {
    HuntOptions options = peak_options();
    const Evaluation good = evaluation_named(formula().name, "closed_form");
    options.objectives[0].evaluation.set_point<double>(
        [good, is_wrong](const Query<double>& query, Result<double>& result) {
          good(query, result);
          if (is_wrong(query)) result.value[0] = std::numeric_limits<double>::quiet_NaN();
        });
    EXPECT_TRUE(std::isinf(hunt(options)[0].worst.front().worst.error));
  }
}

TEST(hunt, makes_coordinates_next_to_nothing) {
  HuntOptions options = peak_options();
  options.objectives[0].evaluation.set_point<double>([](const Query<double>& query, Result<double>& result) {
    result.reset(1, 3, query.order);
    const Vec3<double>& corner = query.corners[1];
    if (corner.cwiseAbs().maxCoeff() > 1e-3 && (corner.array() != 0 && corner.array().abs() < 1e-200).any())
      result.value[0] = std::numeric_limits<double>::quiet_NaN();
  });
  EXPECT_TRUE(std::isinf(hunt(options)[0].worst.front().worst.error));
}

TEST(hunt, refuses_what_cannot_be_asked) {
  HuntOptions options = peak_options();
  options.regimes = "nonsense";
  EXPECT_THROW(hunt(options), InputError);
  options = peak_options();
  options.objectives[0].check = find_check("integral");
  EXPECT_THROW(hunt(options), InputError);
  options = peak_options();
  options.scalar = ScalarKind::Float;
  EXPECT_THROW(hunt(options), InputError);
}

TEST(hunt, measures_quads) {
  HuntOptions options;
  options.formula = find_formula("quad.mean_value");
  options.objectives = {{evaluation_named(options.formula->name, "riemann-4"), find_check("truth")}};
  options.regimes = "near-*";
  options.budget = 60;
  const HuntResult found = hunt(options)[0];
  EXPECT_GT(found.evaluations, 40u);
  ASSERT_FALSE(found.worst.empty());
  EXPECT_EQ(found.worst.front().worst.corners.size(), 4u);
  EXPECT_GT(found.worst.front().worst.error, 1e6);
}

TEST(hunt, that_measures_nothing_is_an_error) {
  HuntOptions options = peak_options();
  options.budget = 20;
  options.objectives[0].evaluation.set_point<double>([](const Query<double>& query, Result<double>& result) {
    result.reset(1, 3, query.order);
    result.converged = false;
  });
  EXPECT_THROW(hunt(options), InputError);
}

TEST(search_domain, holds_every_sample_of_the_regimes_and_nothing_degenerate) {
  for (const Regime& regime : regimes())
    for (std::uint64_t i = 0; i < 60; ++i)
      EXPECT_TRUE(in_search_domain(formula(), make_sample(formula(), regime, 3, i))) << regime.name << ' ' << i;
  const Sample good{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {0.25, 0.25, 0}, {}, 0, 0};
  EXPECT_TRUE(in_search_domain(formula(), good));
  Sample bad = good;
  bad.corners[2] = {3, 0, 0};
  EXPECT_FALSE(in_search_domain(formula(), bad)) << "no area";
  bad.corners[2] = bad.corners[1];
  EXPECT_FALSE(in_search_domain(formula(), bad)) << "two corners in one place";
  bad = good;
  bad.point[1] = HUGE_VAL;
  EXPECT_FALSE(in_search_domain(formula(), bad)) << "not finite";
  bad = good;
  bad.point[2] = 5e-324;
  EXPECT_TRUE(in_search_domain(formula(), bad)) << "as near as doubles tell";
  bad = good;
  bad.corners[2] = {0, 0.0625, 0};
  bad.point = {0.5, 0, 0};
  EXPECT_FALSE(in_search_domain(formula(), bad)) << "on the border of a sliver";
  bad.point[2] = 1e-16;
  EXPECT_TRUE(in_search_domain(formula(), bad)) << "next to it";
  bad = good;
  bad.parameters = {1};
  EXPECT_FALSE(in_search_domain(formula(), bad)) << "a parameter too many";
}

TEST(search_domain, holds_samples_of_every_kind_of_element_and_nothing_degenerate) {
  for (const ElementKind kind : element_kinds) {
    const Formula& of_kind = *std::ranges::find(catalogue(), kind, &Formula::element);
    for (const Regime& regime : regimes()) {
      if (!exists_for(regime, kind)) continue;
      int inside = 0;
      for (std::uint64_t i = 0; i < 60; ++i) inside += in_search_domain(of_kind, make_sample(of_kind, regime, 3, i));
      // Quads on an edge or at a corner may be thinner than the domain's border allows; needles made of a quad with a
      // short side, or with three corners close to each other, are thinner than the domain; one in four aligned quads
      // has two corners in one.
      EXPECT_GE(inside, regime.name.starts_with("on-")                        ? 30
                        : regime.name == "needle" || regime.name == "aligned" ? 40
                                                                              : 60)
          << name_of(kind) << ' ' << regime.name;
    }
    Sample sample = make_sample(of_kind, *find_regime("generic"), 3, 0);
    EXPECT_TRUE(in_search_domain(of_kind, sample));
    const Sample good = sample;
    sample.corners[1] = sample.corners[0];
    EXPECT_FALSE(in_search_domain(of_kind, sample)) << name_of(kind);
    sample = good;
    sample.corners.push_back(sample.point);
    EXPECT_FALSE(in_search_domain(of_kind, sample)) << name_of(kind);
  }
  const Formula& plane = *std::ranges::find(catalogue(), ElementKind::Segment, &Formula::element);
  Sample off = make_sample(plane, *find_regime("generic"), 3, 0);
  off.point[2] = 0.5;
  EXPECT_FALSE(in_search_domain(plane, off)) << "not in the plane";
  const Formula& quads = *find_formula("quad.mean_value");
  const Sample bow_tie{{{0, 0, 0}, {1, 1, 0}, {1, 0, 0}, {0, 1, 0}}, {0.2, 0.3, 1}, {}, 0, 0};
  EXPECT_FALSE(in_search_domain(quads, bow_tie)) << "crosses itself";
}

TEST(search_domain, keeps_parameters_where_the_formula_is_defined) {
  const Formula& kelvin = *find_formula("triangle.kelvin_displacement");
  Sample sample{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {0.25, 0.25, 1}, {1, 0.3}, 0, 0};
  EXPECT_TRUE(in_search_domain(kelvin, sample));
  sample.parameters[1] = 0.7;
  EXPECT_FALSE(in_search_domain(kelvin, sample));
  sample.parameters = {-1, 0.3};
  EXPECT_FALSE(in_search_domain(kelvin, sample));
}

TEST(mutations, of_every_kind_of_element_change_samples_and_never_leave_their_space) {
  for (const ElementKind kind : element_kinds) {
    const Formula& of_kind = *std::ranges::find(catalogue(), kind, &Formula::element);
    for (const Mutation& mutation : mutations()) {
      int changed = 0, inside = 0;
      for (std::uint64_t i = 0; i < 100; ++i) {
        RandomStream random(1, mutation.name, i);
        const Sample before = make_sample(of_kind, *find_regime("near-line"), 1, i);
        Sample after = before;
        mutation.apply(of_kind, after, random);
        changed += after.point != before.point || after.corners != before.corners;
        inside += in_search_domain(of_kind, after);
        for (int c = of_kind.dim(); c < 3; ++c) {
          EXPECT_EQ(after.point[c], 0) << mutation.name;
          for (const auto& corner : after.corners) EXPECT_EQ(corner[c], 0) << mutation.name;
        }
      }
      if (mutation.name == "change parameter") continue;  // none of these formulas has any
      EXPECT_GT(changed, 30) << name_of(kind) << ' ' << mutation.name;
      EXPECT_GT(inside, 20) << name_of(kind) << ' ' << mutation.name;
    }
  }
}

TEST(mutations, change_samples_in_units_whose_products_leave_the_exponent_range) {
  for (const double unit : {1e-250, 1e250})
    for (const Mutation& mutation : mutations()) {
      int changed = 0, inside = 0;
      for (std::uint64_t i = 0; i < 100; ++i) {
        RandomStream random(1, mutation.name, i);
        Sample before = make_sample(formula(), *find_regime("near-line"), 1, i);
        for (Vec3<double>& corner : before.corners) corner *= unit;
        before.point *= unit;
        Sample after = before;
        mutate(mutation, formula(), after, random);
        changed += after.point != before.point || after.corners != before.corners;
        inside += in_search_domain(formula(), after);
      }
      if (mutation.name == "change parameter") continue;  // the formula has none
      EXPECT_GT(changed, 30) << unit << ' ' << mutation.name;
      EXPECT_GT(inside, 20) << unit << ' ' << mutation.name;
    }
}

TEST(mutations, each_changes_samples_and_stays_mostly_where_a_search_may_look) {
  const Formula& kelvin = *find_formula("triangle.kelvin_displacement");
  for (const Mutation& mutation : mutations()) {
    int changed = 0, inside = 0;
    for (std::uint64_t i = 0; i < 100; ++i) {
      RandomStream random(1, mutation.name, i);
      const Sample before = make_sample(kelvin, *find_regime("near-edge"), 1, i);
      Sample after = before;
      mutation.apply(kelvin, after, random);
      changed +=
          after.point != before.point || after.corners != before.corners || after.parameters != before.parameters;
      inside += in_search_domain(kelvin, after);
    }
    EXPECT_GT(changed, 30) << mutation.name;
    EXPECT_GT(inside, 20) << mutation.name;
  }
}

}  // namespace
}  // namespace cageproof::validation
