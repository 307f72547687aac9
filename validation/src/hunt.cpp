// SPDX-License-Identifier: MIT
#include "cageproof/validation/hunt.h"

#include "cageproof/core/input_error.h"
#include "cageproof/validation/campaign.h"
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

// A sample, how wrong the evaluation is there (negative: not measured), and where it came from.
struct Place {
  Sample sample;
  const Regime* regime = nullptr;
  double error = -1;
};

struct Counts {
  std::uint64_t evaluations = 0, without_truth = 0, declined = 0;
};

class Hunter {
 public:
  explicit Hunter(const HuntOptions& options) : options_(options) {
    for (const Regime& regime : regimes())
      if (matches(options.regimes, regime.name)) regimes_.push_back(&regime);
    if (regimes_.empty())
      throw InputError(fmt::format("no regime matches '{}'; see `cageproof list`", options.regimes));
    if (!options.evaluation.supports(options.scalar) || options.order > options.evaluation.max_order() ||
        !options.check->applies(*options.formula, options.evaluation, options.scalar, hunted_regime))
      throw InputError(fmt::format("the check '{}' is not asked of {} in {} at order {}", options.check->name(),
                                   options.evaluation.name(), name_of(options.scalar), options.order));
  }

  HuntResult go() {
    std::vector<Place> places(std::max<std::uint64_t>(1, options_.budget * 2 / 5));
    std::vector<Counts> counts(places.size());
    for_each_parallel(places.size(), options_.jobs, [&](std::size_t i) {
      places[i] = sampled(i);
      measure(places[i], counts[i]);
    });
    const std::uint64_t rest = options_.budget - std::min<std::uint64_t>(options_.budget, places.size());
    std::vector<Place> climbs = starts_from(std::move(places), std::max<std::uint64_t>(1, rest / climb_length));
    const std::size_t explored = counts.size();
    counts.resize(explored + climbs.size());
    for_each_parallel(climbs.size(), options_.jobs, [&](std::size_t i) {
      // The first climbs take what does not divide.
      const std::uint64_t steps = rest / climbs.size() + (i < rest % climbs.size() ? 1 : 0);
      climb(climbs[i], i, steps, counts[explored + i]);
    });
    return result_from(std::move(climbs), counts);
  }

 private:
  Place sampled(std::uint64_t i) const {
    const Regime* regime = regimes_[i % regimes_.size()];
    Place place{make_sample(*options_.formula, *regime, options_.seed, i / regimes_.size()), regime, -1};
    place.sample = rounded_to(options_.scalar, std::move(place.sample));
    return place;
  }

  void measure(Place& place, Counts& counts) {
    place.error = -1;
    if (!in_search_domain(*options_.formula, place.sample)) return;
    ++counts.evaluations;
    const Truth truth = truth_from(options_.reference, place.sample, options_.order);
    const Finding finding = options_.check->measure(
        {*options_.formula, options_.evaluation, options_.scalar, place.sample, options_.order, truth})[options_.order];
    counts.without_truth += finding.status == Finding::Status::NoTruth;
    counts.declined += finding.status == Finding::Status::Declined;
    if (finding.status != Finding::Status::Measured) return;
    place.error = std::isnan(finding.error) ? HUGE_VAL : finding.error;
    tell(place);
  }

  void tell(const Place& place) {
    if (!options_.improved) return;
    const std::scoped_lock lock(mutex_);
    if (place.error <= largest_told_) return;
    largest_told_ = place.error;
    options_.improved(case_of(place), place.regime->name);
  }

  WorstCase case_of(const Place& place) const {
    const Sample& s = place.sample;
    return {place.error, s.parameter, s.index, s.corners, s.point, s.parameters, options_.order};
  }

  // The worst of each regime, then the second worst of each, ...
  static std::vector<Place> starts_from(std::vector<Place> places, std::size_t count) {
    std::erase_if(places, [](const Place& place) { return place.error < 0; });
    std::ranges::stable_sort(places, std::greater(), &Place::error);
    std::vector<std::pair<std::size_t, Place>> ranked;
    std::vector<std::pair<const Regime*, std::size_t>> seen;
    for (Place& place : places) {
      auto at = std::ranges::find(seen, place.regime, &std::pair<const Regime*, std::size_t>::first);
      if (at == seen.end()) at = seen.insert(seen.end(), {place.regime, 0});
      ranked.emplace_back(at->second++, std::move(place));
    }
    std::ranges::stable_sort(ranked, {}, &std::pair<std::size_t, Place>::first);
    if (ranked.size() > count) ranked.resize(count);
    std::vector<Place> starts;
    for (auto& [rank, place] : ranked) starts.push_back(std::move(place));
    return starts;
  }

  void climb(Place& best, std::uint64_t number, std::uint64_t steps, Counts& counts) {
    const auto stream = fmt::format("hunt/{}/{}/{}", options_.formula->name, options_.check->name(), options_.order);
    RandomStream random(options_.seed, stream, number);
    int last = -1;  // what worked goes on working more often than not
    for (std::uint64_t step = 0; step < steps && !std::isinf(best.error); ++step) {
      Place next = best;
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
  int proposed(const Place& from, Place& next, int last, RandomStream& random) const {
    const auto all = mutations();
    for (int draw = 0; draw < most_draws; ++draw) {
      next.sample = from.sample;
      const bool again = last >= 0 && random.below(2) == 0;
      const int kind = again ? last : random.below(static_cast<int>(all.size()));
      all[kind].apply(*options_.formula, next.sample, random);
      while (random.below(4) == 0)
        all[random.below(static_cast<int>(all.size()))].apply(*options_.formula, next.sample, random);
      next.sample = rounded_to(options_.scalar, std::move(next.sample));
      const bool changed = next.sample.corners != from.sample.corners || next.sample.point != from.sample.point ||
                           next.sample.parameters != from.sample.parameters;
      if (changed && in_search_domain(*options_.formula, next.sample)) return kind;
    }
    return -1;
  }

  // What lets the truth's source stand in for the integral, asked at the sample itself.
  std::optional<double> against_integral(const Place& place) const {
    const Check* gate = find_check("integral");
    const Truth none;
    const Finding finding = gate->measure({*options_.formula, options_.reference, ScalarKind::Digits100, place.sample,
                                           options_.order, none})[options_.order];
    if (finding.status != Finding::Status::Measured) return std::nullopt;
    return finding.error;
  }

  HuntResult result_from(std::vector<Place> climbs, const std::vector<Counts>& counts) const {
    HuntResult result;
    for (const Counts& c : counts) {
      result.evaluations += c.evaluations;
      result.without_truth += c.without_truth;
      result.declined += c.declined;
    }
    std::ranges::stable_sort(climbs, std::greater(), &Place::error);
    if (climbs.size() > options_.keep) climbs.resize(options_.keep);
    for (const Place& place : climbs)
      result.worst.push_back({case_of(place), place.regime->name, against_integral(place)});
    return result;
  }

  const HuntOptions& options_;
  std::vector<const Regime*> regimes_;
  std::mutex mutex_;
  double largest_told_ = -1;
};

}  // namespace

HuntResult hunt(const HuntOptions& options) { return Hunter(options).go(); }

}  // namespace cageproof::validation
