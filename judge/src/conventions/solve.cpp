// SPDX-License-Identifier: MIT
// Solves for the convention: tries every arrangement of every formula of the same shape, with the factor that fits.
#include "conventions/samples.h"
#include "conventions/sentence.h"
#include "conventions/tensors.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace cageproof::judge {
namespace {

using validation::Sample;

constexpr double kTolerance = 1e-9;

double dot(const std::vector<double>& a, const std::vector<double>& b) {
  return std::inner_product(a.begin(), a.end(), b.begin(), 0.0);
}

// The factor that maps a to b; NaN where none does.
double factor_between(const std::vector<double>& a, const std::vector<double>& b) {
  const double factor = dot(a, b) / dot(a, a);
  double residual = 0;
  for (std::size_t i = 0; i < a.size(); ++i) residual = std::max(residual, std::abs(b[i] - factor * a[i]));
  const bool fits = residual <= kTolerance * std::sqrt(dot(b, b)) && factor != 0;
  return fits ? factor : std::nan("");
}

bool all_equal(const std::vector<double>& x) {
  return std::ranges::all_of(x, [&](double y) { return std::abs(y - x[0]) <= kTolerance * std::abs(x[0]); });
}

// All ways to give a number of -2 ... 2 to each parameter, the zeros first.
std::vector<std::vector<int>> powers_of(const Formula& formula) {
  std::vector<std::vector<int>> powers{std::vector<int>(formula.parameters.size(), 0)};
  for (std::size_t p = 0; p < formula.parameters.size(); ++p) {
    if (formula.parameters[p].whole) continue;
    const auto before = powers;
    for (const int power : {1, -1, 2, -2})
      for (std::vector<int> row : before) {
        row[p] = power;
        powers.push_back(std::move(row));
      }
  }
  return powers;
}

std::vector<Arrangement> arrangements_of(const Formula& formula) {
  std::vector<Arrangement> all;
  std::vector<int> corners(static_cast<std::size_t>(formula.tensors()));
  std::iota(corners.begin(), corners.end(), 0);
  const bool matrices = formula.shape.rows > 1 && formula.shape.rows == formula.shape.columns;
  const bool weights = formula.shape.per_corner && formula.shape.entries() == 1;
  do {
    const auto order = std::ranges::is_sorted(corners) ? std::vector<int>{} : corners;
    all.push_back({.corners = order});
    if (matrices) all.push_back({.corners = order, .transposed = true});
    if (weights) all.push_back({.corners = order, .normalised = true});
  } while (std::ranges::next_permutation(corners).found);
  std::ranges::stable_sort(all, {}, [](const Arrangement& a) {
    return (a.corners.empty() ? 0 : 2) + (a.transposed ? 1 : 0) + (a.normalised ? 4 : 0);
  });
  return all;
}

struct Pairs {
  std::vector<Sample> samples;
  std::vector<Tensors> theirs;
};

// The factor and the powers that map ours to theirs at all samples.
bool solve_factor(const Formula& formula, const Pairs& pairs, const std::vector<Tensors>& ours, Convention& found) {
  std::vector<double> factors;
  for (std::size_t s = 0; s < ours.size(); ++s) {
    factors.push_back(factor_between(ours[s][0], pairs.theirs[s][0]));
    if (std::isnan(factors.back())) return false;
  }
  for (const std::vector<int>& powers : powers_of(formula)) {
    found.factor = 1;
    found.powers = powers;
    std::vector<double> constant(factors);
    for (std::size_t s = 0; s < constant.size(); ++s)
      constant[s] /= scale_of(formula, found, pairs.samples[s].parameters);
    if (!all_equal(constant)) continue;
    std::ranges::nth_element(constant, constant.begin() + static_cast<std::ptrdiff_t>(constant.size() / 2));
    found.factor = constant[constant.size() / 2];
    if (std::abs(found.factor - 1) < kTolerance) found.factor = 1;
    return true;
  }
  return false;
}

void solve_gradient(const Formula& formula, const Pairs& pairs, const std::vector<Tensors>& ours, Convention& found) {
  for (const int sign : {1, -1})
    for (const bool first : {false, true}) {
      bool fits = !ours[0][1].empty();
      for (std::size_t s = 0; fits && s < ours.size(); ++s) {
        const auto& g = pairs.theirs[s][1];
        const double factor = factor_between(ours[s][1], first ? component_first(g, formula.dim()) : g);
        const double wanted = sign * scale_of(formula, found, pairs.samples[s].parameters);
        fits = std::abs(factor - wanted) <= kTolerance * std::abs(wanted);
      }
      if (!fits) continue;
      found.gradient_known = true;
      found.derivative_sign = sign;
      found.derivative_first = first;
      return;
    }
}

std::optional<Convention> fit(const Formula& formula, const Pairs& pairs, int order) {
  std::vector<Tensors> reference;
  reference.reserve(pairs.samples.size());
  for (const Sample& sample : pairs.samples) reference.push_back(reference_of(formula, sample, order));
  for (const Arrangement& arrangement : arrangements_of(formula)) {
    std::vector<Tensors> ours;
    ours.reserve(reference.size());
    for (const Tensors& tensors : reference) ours.push_back(arranged(formula, tensors, arrangement));
    Convention found{.formula = std::string(formula.name),
                     .corners = arrangement.corners,
                     .transposed = arrangement.transposed,
                     .normalised = arrangement.normalised};
    if (!solve_factor(formula, pairs, ours, found)) continue;
    solve_gradient(formula, pairs, ours, found);
    return found;
  }
  return std::nullopt;
}

// Whether their normals point inward. A layer that jumps then has, on the element, the limit from the other side: their
// value on the reversed element is our limit, and their value times the sign is not.
bool has_inward_normals(const Evaluation& theirs, const Convention& found, std::uint64_t seed) {
  const Formula& formula = formula_named(found.formula);
  if (found.factor > 0 || formula.flip_sign > 0 || found.normalised) return false;
  Convention turned = found;
  turned.factor = -found.factor;
  turned.reversed = true;
  const Evaluation by_sign = in_our_convention(theirs, found), by_turning = in_our_convention(theirs, turned);
  int sign = 0, turn = 0;
  for (Sample sample : convention_samples(formula, seed, false, true)) {
    sample = on_element(sample, formula.element);
    const auto wanted = reference_of(formula, sample, 0)[0];
    if (!std::ranges::all_of(wanted, [](double x) { return std::isfinite(x); }) || dot(wanted, wanted) == 0) continue;
    const auto is_wanted = [&](const Evaluation& e) {
      return std::abs(factor_between(wanted, tensors_of(e, sample, 0)[0]) - 1) < 1e-6;
    };
    sign += is_wanted(by_sign);
    turn += is_wanted(by_turning);
  }
  return turn > sign;
}

// The formula itself first, then those on the same element that have as many numbers and the same parameters.
std::vector<const Formula*> formulas_like(const Formula& formula) {
  std::vector<const Formula*> alike{&formula};
  for (const Formula& other : catalogue())
    if (other.name != formula.name && other.element == formula.element && other.components() == formula.components() &&
        other.parameters.size() <= formula.parameters.size() && other.shape.entries() == formula.shape.entries())
      alike.push_back(&other);
  return alike;
}

}  // namespace

bool Convention::is_ours(std::string_view registered_for) const {
  return formula == registered_for && factor == 1 && corners.empty() && !reversed && !transposed && !normalised &&
         derivative_sign == 1 && !derivative_first && std::ranges::all_of(powers, [](int p) { return p == 0; });
}

std::optional<Convention> find_convention(const Evaluation& theirs, std::uint64_t seed, bool presets) {
  const int order = std::min(1, theirs.max_order());
  for (const bool far : {false, true}) {
    Pairs pairs{convention_samples(theirs.formula(), seed, far, presets), {}};
    for (const Sample& sample : pairs.samples) pairs.theirs.push_back(tensors_of(theirs, sample, order));
    for (const Formula* formula : formulas_like(theirs.formula()))
      if (auto found = fit(*formula, pairs, order)) {
        found->from_afar = far;
        if (has_inward_normals(theirs, *found, seed)) {
          found->factor = -found->factor;
          found->reversed = true;
        }
        found->sentence = sentence_of(*found, theirs.formula());
        return found;
      }
  }
  return std::nullopt;
}

}  // namespace cageproof::judge
