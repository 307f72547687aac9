// SPDX-License-Identifier: MIT
#include "cageproof/validation/hunt.h"

#include "cageproof/core/input_error.h"
#include "cageproof/validation/parallel.h"
#include "cageproof/validation/promise.h"
#include "mutations.h"
#include "search_domain.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <mutex>

namespace cageproof::validation {
namespace {

constexpr std::uint64_t climb_length = 120;
// Proposals drawn for one measurement before it is given up: most are within the domain.
constexpr int most_draws = 64;

// A place to climb from: a sample, how wrong the evaluation is there (negative: not measured), and where it came from.
struct Climber {
  Sample sample;
  const Regime* regime = nullptr;
  double error = -1;
};

struct Counts {
  std::uint64_t evaluations = 0, without_truth = 0, declined = 0;
};

class Hunter {
 public:
  explicit Hunter(const HuntOptions& options) : options_(options), source_(truth_source(*options.formula)) {
    for (const Regime& regime : regimes())
      if (matches(options.regimes, regime.name) && exists_for(regime, options.formula->element))
        regimes_.push_back(&regime);
    if (regimes_.empty())
      throw InputError(fmt::format("no regime of a {} matches '{}'; see `cageproof list`",
                                   name_of(options.formula->element), options.regimes));
    if (!options.evaluation.supports(options.scalar) || options.order > options.evaluation.max_order() ||
        !options.check->applies(*options.formula, options.evaluation, options.scalar, hunted_regime))
      throw InputError(fmt::format("the check '{}' is not asked of {} in {} at order {}", options.check->name(),
                                   options.evaluation.name(), name_of(options.scalar), options.order));
  }

  HuntResult go() {
    std::vector<Climber> places(std::max<std::uint64_t>(1, options_.budget * 2 / 5));
    std::vector<Counts> counts(places.size());
    for_each_parallel(places.size(), options_.jobs, [&](std::size_t i) {
      places[i] = sampled(i);
      measure(places[i], counts[i]);
    });
    const std::uint64_t rest = options_.budget - std::min<std::uint64_t>(options_.budget, places.size());
    std::vector<Climber> climbs = starts_from(std::move(places), std::max<std::uint64_t>(1, rest / climb_length));
    const std::size_t explored = counts.size();
    counts.resize(explored + climbs.size());
    for_each_parallel(climbs.size(), options_.jobs, [&](std::size_t i) {
      // The remainder of the budget goes to the first climbs.
      const std::uint64_t steps = rest / climbs.size() + (i < rest % climbs.size() ? 1 : 0);
      climb(climbs[i], i, steps, counts[explored + i]);
    });
    return result_from(std::move(climbs), counts);
  }

 private:
  Climber sampled(std::uint64_t i) const {
    const Regime* regime = regimes_[i % regimes_.size()];
    Climber place{make_sample(*options_.formula, *regime, options_.seed, i / regimes_.size()), regime, -1};
    place.sample = rounded_to(options_.scalar, std::move(place.sample));
    return place;
  }

  void measure(Climber& place, Counts& counts) {
    place.error = -1;
    if (!in_search_domain(*options_.formula, place.sample)) return;
    ++counts.evaluations;
    const Truth truth = truth_from(source_, place.sample, options_.order);
    const Finding finding = options_.check->measure(
        {*options_.formula, options_.evaluation, options_.scalar, place.sample, options_.order, truth})[options_.order];
    counts.without_truth += finding.status == Finding::Status::NoTruth;
    counts.declined += finding.status == Finding::Status::Declined;
    if (finding.status != Finding::Status::Measured) return;
    place.error = std::isnan(finding.error) ? HUGE_VAL : finding.error;
    tell(place);
  }

  void tell(const Climber& place) {
    if (!options_.improved) return;
    const std::scoped_lock lock(mutex_);
    if (place.error <= largest_told_) return;
    largest_told_ = place.error;
    options_.improved(case_of(place), place.regime->name);
  }

  WorstCase case_of(const Climber& place) const {
    const Sample& s = place.sample;
    return {place.error, s.parameter, s.index, s.corners, s.point, s.parameters, options_.order};
  }

  // The worst of each regime, then the second worst of each, ...
  static std::vector<Climber> starts_from(std::vector<Climber> places, std::size_t count) {
    std::erase_if(places, [](const Climber& place) { return place.error < 0; });
    std::ranges::stable_sort(places, std::greater(), &Climber::error);
    std::vector<std::pair<std::size_t, Climber>> ranked;
    std::vector<std::pair<const Regime*, std::size_t>> seen;
    for (Climber& place : places) {
      auto at = std::ranges::find(seen, place.regime, &std::pair<const Regime*, std::size_t>::first);
      if (at == seen.end()) at = seen.insert(seen.end(), {place.regime, 0});
      ranked.emplace_back(at->second++, std::move(place));
    }
    std::ranges::stable_sort(ranked, {}, &std::pair<std::size_t, Climber>::first);
    if (ranked.size() > count) ranked.resize(count);
    std::vector<Climber> starts;
    starts.reserve(ranked.size());
    for (auto& [rank, place] : ranked) starts.push_back(std::move(place));
    return starts;
  }

  void climb(Climber& best, std::uint64_t number, std::uint64_t steps, Counts& counts) {
    const auto stream = fmt::format("hunt/{}/{}/{}", options_.formula->name, options_.check->name(), options_.order);
    RandomStream random(options_.seed, stream, number);
    int last = -1;  // what worked goes on working more often than not
    for (std::uint64_t step = 0; step < steps && !std::isinf(best.error); ++step) {
      Climber next = best;
      const int kind = proposed(best, next, last, random);
      if (kind < 0) continue;
      measure(next, counts);
      // Strictly: else a climb drifts through units and positions that say nothing of the case.
      if (next.error <= best.error) continue;
      last = kind;
      best = std::move(next);
    }
  }

  // Changes `next` until it may be measured; returns the mutation, or -1 when none was found.
  int proposed(const Climber& from, Climber& next, int last, RandomStream& random) const {
    const int count = static_cast<int>(mutations().size());
    for (int draw = 0; draw < most_draws; ++draw) {
      next.sample = from.sample;
      const bool again = last >= 0 && random.below(2) == 0;
      const int kind = again ? last : random.below(count);
      mutate(mutations()[kind], *options_.formula, next.sample, random);
      while (random.below(4) == 0) mutate(mutations()[random.below(count)], *options_.formula, next.sample, random);
      next.sample = rounded_to(options_.scalar, std::move(next.sample));
      const bool changed = next.sample.corners != from.sample.corners || next.sample.point != from.sample.point ||
                           next.sample.parameters != from.sample.parameters;
      if (changed && in_search_domain(*options_.formula, next.sample)) return kind;
    }
    return -1;
  }

  // What lets the truth's source stand in for the integral, asked at the sample itself.
  std::optional<double> against_integral(const Climber& place) const {
    if (source_.is_integral) return std::nullopt;
    const Check* gate = find_check("integral");
    const Truth none;
    const Finding finding = gate->measure({*options_.formula, source_.evaluation, ScalarKind::Digits100, place.sample,
                                           options_.order, none})[options_.order];
    if (finding.status != Finding::Status::Measured) return std::nullopt;
    return finding.error;
  }

  HuntResult result_from(std::vector<Climber> climbs, const std::vector<Counts>& counts) const {
    HuntResult result;
    for (const Counts& c : counts) {
      result.evaluations += c.evaluations;
      result.without_truth += c.without_truth;
      result.declined += c.declined;
    }
    if (climbs.empty())
      throw InputError(
          fmt::format("{} of {}, {}, order {}: nothing measured at {} inputs, {} without truth, {} declined",
                      options_.evaluation.name(), options_.formula->name, options_.check->name(), options_.order,
                      result.evaluations, result.without_truth, result.declined));
    std::ranges::stable_sort(climbs, std::greater(), &Climber::error);
    if (climbs.size() > options_.keep) climbs.resize(options_.keep);
    for (const Climber& place : climbs)
      result.worst.push_back({case_of(place), place.regime->name, against_integral(place)});
    return result;
  }

  const HuntOptions& options_;
  TruthSource source_;
  std::vector<const Regime*> regimes_;
  std::mutex mutex_;
  double largest_told_ = -1;
};

}  // namespace

HuntResult hunt(const HuntOptions& options) { return Hunter(options).go(); }

}  // namespace cageproof::validation
