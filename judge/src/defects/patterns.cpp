// SPDX-License-Identifier: MIT
// Patterns of an implementation's errors, seen over all samples.
#include "defects/closed_sum.h"
#include "defects/ladder.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace cageproof::judge {
namespace {

// Slope of the straight line through the points; 0 for fewer than three.
double slope_of(const std::vector<std::array<double, 2>>& points) {
  if (points.size() < 3) return 0;
  const auto n = static_cast<double>(points.size());
  double x = 0, y = 0, xx = 0, xy = 0;
  for (const auto& p : points) {
    x += p[0] / n;
    y += p[1] / n;
  }
  for (const auto& p : points) {
    xx += (p[0] - x) * (p[0] - x);
    xy += (p[0] - x) * (p[1] - y);
  }
  return xx > 0 ? xy / xx : 0;
}

struct Count {
  std::size_t all = 0, bad = 0;
};

template <class Wanted>
Count count(const Study& study, int order, Wanted&& wanted) {
  Count found;
  for (const Case& c : study.cases())
    if (c.order == order && wanted(c)) {
      ++found.all;
      if (c.bad) ++found.bad;
    }
  return found;
}

// Exponent that errors grow with, of what `size_of` gives, where they are at least sixteen units and a digit is right.
template <class Wanted, class Size, class Error>
double growth(const Study& study, int order, Wanted&& wanted, Size&& size_of, Error&& error_of_case) {
  std::vector<std::array<double, 2>> points;
  for (const Case& c : study.cases())
    if (c.order == order && wanted(c))
      if (const double e = error_of_case(c); std::isfinite(e) && e > 16 && c.relative < 0.1)
        points.push_back({std::log10(size_of(c)), std::log10(e)});
  return slope_of(points);
}

// Counts the generic results that satisfy a relation between theirs and the truth.
template <class Relation>
bool mostly(const Study& study, Relation&& holds) {
  const Count bad = count(study, 0, [](const Case& c) { return c.probe->regime == "generic" && c.bad && c.finite; });
  const Count held =
      count(study, 0, [&](const Case& c) { return c.probe->regime == "generic" && c.bad && c.finite && holds(c); });
  return bad.all > 0 && 10 * held.all >= 9 * bad.all;
}

std::vector<double> truth_of(const Case& c) {
  std::vector<double> truth;
  truth.reserve(c.probe->truth.tensors.value.size());
  for (const Mp100& x : c.probe->truth.tensors.value) truth.push_back(static_cast<double>(x));
  return truth;
}

// Relations must hold to a thousandth of the error: one of few digits satisfies them all.
constexpr double kShare = 1e-3;

bool proportional(const Case& c) {
  const std::vector<double> truth = truth_of(c);
  const auto& found = c.found.value;
  const double tt = std::inner_product(truth.begin(), truth.end(), truth.begin(), 0.0);
  const double factor = std::inner_product(truth.begin(), truth.end(), found.begin(), 0.0) / tt;
  for (std::size_t i = 0; i < truth.size(); ++i)
    if (!(std::abs(found[i] - factor * truth[i]) <= kShare * off_by(c))) return false;
  return truth.size() > 1;
}

bool same_sum(const Formula& formula, const Case& c) {
  const std::vector<double> truth = truth_of(c);
  const auto entries = static_cast<std::size_t>(formula.shape.entries());
  for (std::size_t e = 0; e < entries; ++e) {
    double difference = 0;
    for (std::size_t i = e; i < truth.size(); i += entries) difference += c.found.value[i] - truth[i];
    if (!(std::abs(difference) <= kShare * off_by(c))) return false;
  }
  return formula.tensors() > 1;
}

// Next to a feature, and nowhere else, relative errors grow as the distance falls, or are not finite. Exponent of one
// over the distance; 1 where all are not finite.
double slope_near(const Study& study, int order, std::string_view regime, std::span<const std::string_view> clean) {
  const auto near = [&](const Case& c) { return c.probe->regime == regime; };
  const Count elsewhere = count(study, order, [&](const Case& c) {
    return std::ranges::count(clean, c.probe->regime) > 0 || (near(c) && c.probe->sample.parameter > 0.05);
  });
  if (elsewhere.bad > 0 || count(study, order, near).bad < 3) return 0;
  std::vector<std::array<double, 2>> points;
  for (const Case& c : study.cases())
    if (c.order == order && near(c) && c.bad && c.finite && c.relative > 0)
      points.push_back({-std::log10(c.probe->sample.parameter), std::log10(std::min(c.relative, 1.0))});
  const Count infinite = count(study, order, [&](const Case& c) { return near(c) && !c.finite; });
  if (points.size() < 3) return infinite.all >= 3 ? 1 : 0;
  // Where errors grow until nothing is left, results that are not finite have no digit.
  for (const Case& c : study.cases())
    if (c.order == order && near(c) && !c.finite) points.push_back({-std::log10(c.probe->sample.parameter), 0});
  return slope_of(points);
}

constexpr std::array<std::string_view, 3> kCleanByEdges{"generic", "near-face", "near-plane"};
constexpr std::array<std::string_view, 2> kCleanByPlane{"generic", "near-face"};

double height_of_projections(const Study& study, int order) {
  std::size_t projected = 0;
  double height = 0;
  for (const Case& c : study.cases()) {
    const bool clearly_off = c.probe->regime.starts_with("near") && c.probe->sample.parameter > 1e-13;
    if (c.order != order || !c.bad || !c.finite || !clearly_off || !is_projected(study, c)) continue;
    ++projected;
    height = std::max(height, place_of(study.formula().element, c.probe->sample).height);
  }
  return projected < 3 ? 0 : height;
}

}  // namespace

Pattern pattern_of(const Study& study, int order, std::uint64_t seed) {
  const auto in = [](std::string_view a, std::string_view b = {}) {
    return [a, b](const Case& c) { return c.probe->regime == a || (!b.empty() && c.probe->regime == b); };
  };
  Pattern found;
  const Count generic = count(study, order, in("generic"));
  const Count beside = count(
      study, order, [](const Case& c) { return c.probe->regime == "near-face" && c.probe->sample.parameter > 1e-5; });
  found.quadrature = beside.bad > 0 && errors_rise_towards(study, order, seed);
  for (const Case& c : study.cases())
    if (c.order == order && c.bad && c.probe->regime == "generic")
      found.generic_error = std::max(found.generic_error, c.relative);
  found.everywhere = 2 * generic.bad >= generic.all && generic.bad > 0;
  if (found.everywhere) {
    found.in_proportion = order == 0 && mostly(study, proportional);
    found.right_in_sum = order == 0 && mostly(study, [&](const Case& c) { return same_sum(study.formula(), c); });
    found.right_when_closed = order == 1 && closed_sum_is_right(study.evaluation(), order);
    return found;
  }
  found.edge_slope = slope_near(study, order, "near-edge", kCleanByEdges);
  found.plane_slope = slope_near(study, order, "near-plane", kCleanByPlane);
  found.projected_below = height_of_projections(study, order);
  const auto theirs = [](const Case& c) { return c.error; };
  const auto plain = [order](const Case& c) { return c.probe->plain[order]; };
  const auto distance = [](const Case& c) { return c.probe->sample.parameter; };
  const auto thinness = [](const Case& c) { return 1 / c.probe->sample.parameter; };
  found.far = generic.bad == 0 && count(study, order, in("far")).bad > 1;
  found.far_slope = growth(study, order, in("far"), distance, theirs);
  found.plain_far_slope = growth(study, order, in("far"), distance, plain);
  found.sliver = generic.bad == 0 && count(study, order, in("sliver", "needle")).bad > 1;
  found.sliver_slope = growth(study, order, in("sliver", "needle"), thinness, theirs);
  found.plain_sliver_slope = growth(study, order, in("sliver", "needle"), thinness, plain);
  return found;
}

}  // namespace cageproof::judge
