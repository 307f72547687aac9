// SPDX-License-Identifier: MIT
#include "cageproof/validation/regime.h"

#include "element/draws.h"
#include "element/element_sampling.h"

#include "cageproof/core/input_error.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace cageproof::validation {
namespace {

std::vector<double> decades(int from, int to, int step = 1) {
  std::vector<double> values;
  for (int exponent = from; step > 0 ? exponent <= to : exponent >= to; exponent += step)
    values.push_back(std::pow(10.0, exponent));
  return values;
}

const SampleMaker* maker_of(const Regime& regime, ElementKind element) {
  const auto makers = sampling_of(element).regimes;
  const auto found = std::ranges::find(makers, regime.name, &SampleMaker::regime);
  return found == makers.end() ? nullptr : &*found;
}

// Kinds of values that a parameter takes at a sample, where the formula allows them.
enum class Stratum { Within, Highest, Infinity, Zero, Negative, Preset };

// Few samples see few strata: the first is a value at which no term vanishes, successive ones step through all. The
// second sample of costly checks is the eighth; its stratum differs between regimes. On the element it is generic
// again, because the first one has no derivatives there.
Stratum stratum_of(const Regime& regime, std::uint64_t seed, std::uint64_t index) {
  RandomStream random(seed, regime.name, 0);
  const std::uint64_t shift = regime.name.starts_with("on-") ? 3 : random.below(6);
  return static_cast<Stratum>((index + index / 7 * shift) % 6);
}

double make_parameter(const Parameter& p, Stratum stratum, RandomStream& random) {
  const double number = random.uniform(), sign = random_sign(random);
  if (p.whole) return std::floor(p.lowest) + 1 + std::floor(number * (p.highest - std::floor(p.lowest) - 1));
  switch (stratum) {
    case Stratum::Highest:
      if (p.includes_highest) return p.highest;
      break;
    case Stratum::Infinity:
      if (p.includes_infinity) return sign * HUGE_VAL;
      break;
    case Stratum::Zero:
      if (p.allows(0)) return 0;
      break;
    case Stratum::Negative:
      if (p.lowest < 0) return p.lowest * number;
      break;
    case Stratum::Preset: return p.preset;
    case Stratum::Within: break;
  }
  if (std::isinf(p.highest)) return p.preset * std::exp2(6 * number - 3);
  const double lowest = std::max(p.lowest, 0.0);
  return lowest + (p.highest - lowest) * number;
}

}  // namespace

const std::vector<Regime>& regimes() {
  static const std::string_view distance = "distance / size";
  static const std::vector<Regime> all{
      {"generic", "", {}, "well-shaped element, point within one size of its centroid"},
      {"near-face", distance, decades(-1, -16, -1), "projection inside the element"},
      {"near-plane", distance, decades(-1, -16, -1), "projection 0.1 to 1 sizes outside the element"},
      {"near-edge", distance, decades(-1, -16, -1), "next to an edge, in its span"},
      {"near-line", distance, decades(-1, -16, -1), "next to an edge's line, 0.1 to 1 lengths beyond its ends"},
      {"near-vertex", distance, decades(-1, -16, -1), "next to a corner, any direction"},
      {"on-face", "", {}, "exactly inside the element, and one ulp off"},
      {"on-edge", "", {}, "exactly on an edge, and one ulp off"},
      {"on-vertex", "", {}, "exactly at a corner, and one ulp off"},
      {"on-plane", "", {}, "exactly in the plane (on the bilinear surface) outside the element, and one ulp off"},
      {"on-line", "", {}, "exactly on an edge's line beyond its ends, and one ulp off"},
      {"aligned", distance, decades(0, -16, -1),
       "corners in small integers, in planes and along edges of the axes; steps along axes off exact points, and over "
       "the centres of symmetric elements"},
      {"tiny",
       "",
       {},
       "as aligned, at distances of 1e-17 to 5e-324, in units of 1e-315 to 1e298, 1e9 to 1e110 away, or tilted by a "
       "denormal"},
      {"far", distance, decades(1, 8), "many sizes away"},
      {"sliver", "height / size", decades(-1, -10, -1), "cap: one corner close to the opposite edge"},
      {"needle", "width / size", decades(-1, -10, -1), "one short edge"},
      {"scaled", "unit", decades(-100, 100, 20), "generic, in another unit of length"},
      {"offset", "offset / size", decades(1, 8), "generic, far from the origin"},
  };
  return all;
}

const Regime* find_regime(std::string_view name) {
  const auto found = std::ranges::find(regimes(), name, &Regime::name);
  return found == regimes().end() ? nullptr : &*found;
}

bool exists_for(const Regime& regime, ElementKind element) { return maker_of(regime, element) != nullptr; }

Sample make_sample(const Formula& formula, const Regime& regime, std::uint64_t seed, std::uint64_t index) {
  const SampleMaker* maker = maker_of(regime, formula.element);
  if (maker == nullptr)
    throw InputError(fmt::format("the regime {} does not exist for a {}", regime.name, name_of(formula.element)));
  RandomStream random(seed, fmt::format("{}/{}", formula.name, regime.name), index);
  Sample sample;
  sample.index = index;
  sample.parameter = regime.parameters.empty() ? 0 : regime.parameters[index % regime.parameters.size()];
  maker->make(sample.parameter, random, sample);
  const Stratum stratum = stratum_of(regime, seed, index);
  sample.parameters.reserve(formula.parameters.size());
  for (const Parameter& p : formula.parameters) sample.parameters.push_back(make_parameter(p, stratum, random));
  return sample;
}

}  // namespace cageproof::validation
