// SPDX-License-Identifier: MIT
#include "defects/probes.h"

#include "cageproof/validation/regime.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <mutex>

namespace cageproof::judge {
namespace {

using validation::Sample;

struct Share {
  std::string_view regime;
  std::uint64_t samples;
};
// As many as a sweep has steps; distances beyond 1e8 sizes and units are tried elsewhere.
constexpr std::array kShares{Share{"generic", 16},   Share{"near-face", 16}, Share{"near-plane", 16},
                             Share{"near-edge", 32}, Share{"near-line", 16}, Share{"near-vertex", 16},
                             Share{"on-face", 8},    Share{"on-edge", 8},    Share{"on-vertex", 8},
                             Share{"on-plane", 8},   Share{"on-line", 8},    Share{"far", 16},
                             Share{"sliver", 10},    Share{"needle", 10}};

void scale(std::vector<Mp100>& tensor, int exponent) {
  for (Mp100& x : tensor) x = ldexp(x, exponent);
}

Sample scaled(Sample sample, int k) {
  for (auto& corner : sample.corners)
    for (double& x : corner) x = std::ldexp(x, k);
  for (double& x : sample.point) x = std::ldexp(x, k);
  return sample;
}

// The step of scales that every sixth generic and near sample is tried in; thresholds of 1e-6 to 1e-13 on lengths,
// areas and volumes lie between.
constexpr std::array kTriedUnits{-42, -21, -10, 10, 21, 42};

std::vector<Probe> made(const Prober& prober, std::uint64_t seed, bool presets) {
  std::vector<Probe> probes;
  const Formula& formula = prober.formula();
  // Truths of quads cost twenty times as much.
  const std::uint64_t step = formula.element == ElementKind::Quad ? 3 : 1;
  for (const auto& [name, samples] : kShares) {
    const validation::Regime& regime = *validation::find_regime(name);
    if (!validation::exists_for(regime, formula.element)) continue;
    for (std::uint64_t i = 0; i < samples; i += step) {
      Sample sample = make_sample(formula, regime, seed, i);
      for (std::size_t p = 0; p < sample.parameters.size(); ++p)
        if (presets || !std::isfinite(sample.parameters[p])) sample.parameters[p] = formula.parameters[p].preset;
      probes.push_back(prober.at(sample, name));
    }
  }
  const std::size_t own = probes.size();
  for (std::size_t i = 0; i < own; i += 4) {
    if (probes[i].regime != "generic" && (!probes[i].regime.starts_with("near") || probes[i].sample.parameter < 1e-4))
      continue;
    for (const int k : kTriedUnits) {
      probes.push_back(prober.scaled(probes[i], k));
      probes.back().regime = "scaled";
    }
  }
  return probes;
}

}  // namespace

Prober::Prober(const Formula& formula, int order)
    : formula_(&formula),
      order_(order),
      source_(validation::truth_source(formula)),
      plain_(EvaluationRegister::instance().with_role(formula.name, Role::Plain)) {}

void Prober::measure_plain(Probe& probe) const {
  if (!plain_) return;
  const auto found = validation::evaluate<double>(*plain_, probe.sample, order_);
  for (int o = 0; o <= order_; ++o) probe.plain[o] = error_of(found, probe, o);
}

Probe Prober::at(const Sample& sample, std::string_view regime) const {
  Probe probe{.regime = regime, .sample = sample, .truth = truth_from(source_, sample, order_)};
  measure_plain(probe);
  return probe;
}

Probe Prober::scaled(const Probe& probe, int k) const {
  const Behaviour behaviour = formula_->behaviour(probe.sample.parameters);
  const Sample sample = judge::scaled(probe.sample, k);
  if (behaviour.logarithmic.factor != 0) return at(sample, probe.regime);
  Probe result = probe;
  result.sample = sample;
  for (int o = 0; o <= order_; ++o) {
    const int exponent = k * (behaviour.degree - o);
    scale(result.truth.tensors.of(o), exponent);
    result.truth.norm[o] = ldexp(result.truth.norm[o], exponent);
    result.truth.conditioned[o] = ldexp(result.truth.conditioned[o], exponent);
  }
  return result;
}

const std::vector<Probe>& probes_of(const Prober& prober, std::uint64_t seed, bool presets) {
  static std::mutex mutex;
  static std::map<std::tuple<std::string_view, int, std::uint64_t, bool>, std::vector<Probe>> known;
  const std::scoped_lock lock(mutex);
  auto& probes = known[{prober.formula().name, prober.order(), seed, presets}];
  if (probes.empty()) probes = made(prober, seed, presets);
  return probes;
}

double error_of(const Result<double>& found, const Probe& probe, int order) {
  static const Mp100 unit = ldexp(Mp100(1), -53);
  if (!probe.truth.exists[order]) return 0;
  return validation::conditioned_error(found, probe.truth, order, unit);
}

double limit_of(const Probe& probe, int order) { return std::max(16384.0, 64 * probe.plain[order]); }

}  // namespace cageproof::judge
