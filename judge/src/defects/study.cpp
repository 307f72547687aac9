// SPDX-License-Identifier: MIT
#include "defects/study.h"

#include "conventions/tensors.h"

#include <algorithm>
#include <cmath>

namespace cageproof::judge {

using validation::Sample;

Study::Study(const Evaluation& ours, std::uint64_t seed, int order, bool presets, bool sums_to_one)
    : ours_(ours), prober_(ours.formula(), order) {
  const std::vector<Probe>& probes = probes_of(prober_, seed, presets);
  samples_ = probes.size();
  for (const Probe& probe : probes) {
    if (sums_to_one && place_of(formula().element, probe.sample).in_plane) continue;
    for (int o = 0; o <= order; ++o)
      if (probe.truth.exists[o]) cases_.push_back(ask(probe, o));
  }
  for (int o = 0; o <= order; ++o) patterns_[static_cast<std::size_t>(o)] = pattern_of(*this, o, seed);
}

Result<double> Study::ask(const Sample& sample, int order) const {
  return validation::evaluate<double>(ours_, sample, order);
}

Case Study::ask(const Probe& probe, int order) const {
  Case made{.probe = &probe, .order = order, .found = ask(probe.sample, prober_.order())};
  // An input that the code declined is no defect.
  if (!probe.truth.exists[order] || !made.found.converged) return made;
  for (const double x : made.found.of(order)) made.finite &= std::isfinite(x);
  made.error = error_of(made.found, probe, order);
  made.relative = made.finite ? validation::relative_error(made.found, probe.truth, order) : INFINITY;
  made.bad = made.error > limit_of(probe, order);
  return made;
}

double off_by(const Case& c) {
  double off = 0;
  for (std::size_t i = 0; i < c.found.of(c.order).size(); ++i)
    off = std::max(off, std::abs(c.found.of(c.order)[i] - static_cast<double>(c.probe->truth.tensors.of(c.order)[i])));
  return off;
}

bool is_projected(const Study& study, const Case& c) {
  const Place at = place_of(study.formula().element, c.probe->sample);
  if (at.height == 0 || at.height > 0.01) return false;
  // Their foot may lie a rounding on the other side of the plane.
  for (const double roundings : {0.0, 8.0, -8.0}) {
    Sample foot = c.probe->sample;
    foot.point = at.foot + roundings * at.rounding * at.normal;
    const auto there = study.ask(foot, study.prober().order()).of(c.order);
    const std::vector<double> right = reference_of(study.formula(), foot, c.order)[static_cast<std::size_t>(c.order)];
    double off = 0, moved = 0;
    bool finite = true;
    for (std::size_t i = 0; i < there.size(); ++i) {
      off = std::max(off, std::abs(there[i] - c.found.of(c.order)[i]));
      finite &= std::isfinite(there[i]);
      const auto truth = static_cast<double>(c.probe->truth.tensors.of(c.order)[i]);
      moved = std::max(moved, std::isfinite(right[i]) ? std::abs(right[i] - truth) : INFINITY);
    }
    if (c.finite ? off < 1e-3 * off_by(c) && moved > 0.5 * off_by(c) : !finite) return true;
  }
  return false;
}

}  // namespace cageproof::judge
