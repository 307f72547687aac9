// SPDX-License-Identifier: MIT
#include "cageproof/validation/hunt.h"

#include "cageproof/core/input_error.h"
#include "cageproof/core/catalogue/name_pattern.h"
#include "cageproof/core/parallel.h"
#include "cageproof/validation/promise.h"
#include "checks/element_questions.h"
#include "sampling/mutations.h"
#include "sampling/search_domain.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <mutex>

namespace cageproof::validation {
namespace {

constexpr std::uint64_t climb_length = 120;
// Proposals drawn for one measurement before it is given up: most are within the domain.
constexpr int most_draws = 64;

// An input, how wrong each objective's evaluation is there (negative: not measured), and where it came from.
struct Start {
  Sample sample;
  const Regime* regime = nullptr;
  std::vector<double> errors;
};

struct Counts {
  std::uint64_t evaluations = 0, without_truth = 0, declined = 0;
};

// A search that makes one objective's error large, and the worst that it saw of each.
struct Climb {
  std::size_t objective;
  Start start;
  std::vector<Start> worst;
};

class Hunter {
 public:
  explicit Hunter(const HuntOptions& options) : options_(options), source_(truth_source(*options.formula)) {
    std::vector<std::string_view> known;
    for (const Regime& regime : regimes()) known.push_back(regime.name);
    for (const std::string& name : names_in(options.regimes))
      if (name == hull_regime || name == hunted_regime)
        throw InputError(fmt::format("regime '{}': only `verify` has it; others are {}", name, fmt::join(known, ", ")));
    require_known("regime", options.regimes, known);
    for (const Regime& regime : regimes())
      if (matches(options.regimes, regime.name) && exists_for(regime, options.formula->element))
        regimes_.push_back(&regime);
    if (regimes_.empty())
      throw InputError(fmt::format("no regime of a {} matches '{}'; see `cageproof list`",
                                   name_of(options.formula->element), options.regimes));
    for (const auto& [evaluation, check] : options.objectives) {
      auto question = element_question(*check, evaluation, options.scalar, hunted_regime, options.order);
      if (!question || options.order > evaluation.max_order())
        throw InputError(fmt::format("the check '{}' is not asked of {} in {} at order {}", check->name(),
                                     evaluation.name(), name_of(options.scalar), options.order));
      questions_.push_back(std::move(*question));
    }
    if (options.objectives.empty()) throw InputError("nothing to hunt for");
    largest_told_.assign(options.objectives.size(), -1);
  }

  std::vector<HuntResult> go() {
    const std::size_t objectives = options_.objectives.size();
    std::vector<Start> places(std::max<std::uint64_t>(1, options_.budget * 2 / 5));
    std::vector<std::vector<Counts>> counts(places.size(), std::vector<Counts>(objectives));
    for_each_parallel(places.size(), options_.jobs, [&](std::size_t i) {
      places[i] = sampled(i);
      measure(places[i], counts[i]);
    });
    const std::uint64_t rest = options_.budget - std::min<std::uint64_t>(options_.budget, places.size());
    std::vector<Climb> climbs;
    for (std::size_t k = 0; k < objectives; ++k)
      for (const Start* start : starts_for(k, places, std::max<std::uint64_t>(1, rest / climb_length / objectives)))
        climbs.push_back({k, *start, std::vector<Start>(objectives, *start)});
    const std::size_t explored = counts.size();
    counts.resize(explored + climbs.size(), std::vector<Counts>(objectives));
    for_each_parallel(climbs.size(), options_.jobs, [&](std::size_t i) {
      // The remainder of the budget goes to the first climbs.
      const std::uint64_t steps = rest / climbs.size() + (i < rest % climbs.size() ? 1 : 0);
      climb(climbs[i], i, steps, counts[explored + i]);
    });
    std::vector<HuntResult> results;
    results.reserve(objectives);
    for (std::size_t k = 0; k < objectives; ++k) results.push_back(result_of(k, places, climbs, counts));
    if (climbs.empty())
      throw InputError(fmt::format("{}, order {}: nothing measured at {} inputs, {} without truth, {} declined",
                                   options_.formula->name, options_.order, results.front().evaluations,
                                   results.front().without_truth, results.front().declined));
    return results;
  }

 private:
  Start sampled(std::uint64_t i) const {
    const Regime* regime = regimes_[i % regimes_.size()];
    Start place{make_sample(*options_.formula, *regime, options_.seed, i / regimes_.size()), regime, {}};
    place.sample = rounded_to(options_.scalar, std::move(place.sample));
    return place;
  }

  void measure(Start& place, std::vector<Counts>& counts) {
    place.errors.assign(options_.objectives.size(), -1);
    if (!in_search_domain(*options_.formula, place.sample)) return;
    const ElementAt at(source_, place.sample, options_.order);
    for (std::size_t k = 0; k < questions_.size(); ++k) {
      const Finding finding = questions_[k].ask(at)[options_.order];
      ++counts[k].evaluations;
      counts[k].without_truth += finding.status == Finding::Status::NoTruth;
      counts[k].declined += finding.status == Finding::Status::Declined;
      if (finding.status != Finding::Status::Measured) continue;
      place.errors[k] = std::isnan(finding.error) ? HUGE_VAL : finding.error;
      tell(k, place);
    }
  }

  void tell(std::size_t k, const Start& place) {
    if (!options_.improved) return;
    const std::scoped_lock lock(mutex_);
    if (place.errors[k] <= largest_told_[k]) return;
    largest_told_[k] = place.errors[k];
    options_.improved(options_.objectives[k], case_of(k, place), place.regime->name);
  }

  WorstCase case_of(std::size_t k, const Start& place) const {
    const Sample& s = place.sample;
    return {place.errors[k], s.parameter, s.index, s.corners, s.point, s.parameters, options_.order};
  }

  // The worst of each regime for an objective, then the second worst of each, ...
  static std::vector<const Start*> starts_for(std::size_t k, const std::vector<Start>& places, std::size_t count) {
    std::vector<const Start*> measured;
    for (const Start& place : places)
      if (place.errors[k] >= 0) measured.push_back(&place);
    std::ranges::stable_sort(measured, std::greater(), [k](const Start* p) { return p->errors[k]; });
    std::map<const Regime*, std::size_t> seen;
    std::vector<std::pair<std::size_t, const Start*>> ranked;
    ranked.reserve(measured.size());
    for (const Start* place : measured) ranked.emplace_back(seen[place->regime]++, place);
    std::ranges::stable_sort(ranked, {}, &std::pair<std::size_t, const Start*>::first);
    if (ranked.size() > count) ranked.resize(count);
    std::vector<const Start*> starts;
    starts.reserve(ranked.size());
    for (const auto& [rank, place] : ranked) starts.push_back(place);
    return starts;
  }

  void climb(Climb& climb, std::uint64_t number, std::uint64_t steps, std::vector<Counts>& counts) {
    const auto& [evaluation, check] = options_.objectives[climb.objective];
    const auto stream =
        fmt::format("hunt/{}/{}/{}/{}", options_.formula->name, evaluation.name(), check->name(), options_.order);
    RandomStream random(options_.seed, stream, number);
    Start best = climb.start;
    int last = -1;  // a mutation that worked often works again
    for (std::uint64_t step = 0; step < steps && !std::isinf(best.errors[climb.objective]); ++step) {
      Start next = best;
      const int kind = proposed(best, next, last, random);
      if (kind < 0) continue;
      measure(next, counts);
      for (std::size_t k = 0; k < climb.worst.size(); ++k)
        if (next.errors[k] > climb.worst[k].errors[k]) climb.worst[k] = next;
      // Strictly: else a climb drifts through units and positions that say nothing of the case.
      if (next.errors[climb.objective] <= best.errors[climb.objective]) continue;
      last = kind;
      best = std::move(next);
    }
  }

  // Changes `next` until it may be measured; returns the mutation, or -1 when none was found.
  int proposed(const Start& from, Start& next, int last, RandomStream& random) const {
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

  // Difference of the truth's source and the integral at the sample itself.
  std::optional<double> against_integral(const Start& place) const {
    if (source_.is_integral()) return std::nullopt;
    const ElementQuestion gate = element_question(*find_check("integral"), source_.evaluation, ScalarKind::Digits100,
                                                  hunted_regime, options_.order)
                                     .value();
    const Finding finding = gate.ask(ElementAt(source_, place.sample, options_.order))[options_.order];
    if (finding.status != Finding::Status::Measured) return std::nullopt;
    return finding.error;
  }

  HuntResult result_of(std::size_t k, const std::vector<Start>& places, const std::vector<Climb>& climbs,
                       const std::vector<std::vector<Counts>>& counts) const {
    HuntResult result;
    for (const std::vector<Counts>& c : counts) {
      result.evaluations += c[k].evaluations;
      result.without_truth += c[k].without_truth;
      result.declined += c[k].declined;
    }
    std::vector<const Start*> found;
    found.reserve(climbs.size() + 1);
    for (const Climb& climb : climbs) found.push_back(&climb.worst[k]);
    // Samples that no climb began at count too; the worst of them is enough.
    found.push_back(&*std::ranges::max_element(places, {}, [k](const Start& place) { return place.errors[k]; }));
    std::erase_if(found, [k](const Start* place) { return place->errors[k] < 0; });
    std::ranges::stable_sort(found, std::greater(), [k](const Start* place) { return place->errors[k]; });
    const auto same = [](const Start* a, const Start* b) {
      return a->sample.corners == b->sample.corners && a->sample.point == b->sample.point &&
             a->sample.parameters == b->sample.parameters;
    };
    for (const Start* place : found) {
      if (result.worst.size() == options_.keep) break;
      if (kept_already(found, place, same)) continue;
      result.worst.push_back(
          {case_of(k, *place), place->regime->name, result.worst.empty() ? against_integral(*place) : std::nullopt});
    }
    return result;
  }

  // Whether one before it in the list is the same input.
  template <class Same>
  static bool kept_already(const std::vector<const Start*>& found, const Start* place, const Same& same) {
    for (const Start* before : found) {
      if (before == place) return false;
      if (same(before, place)) return true;
    }
    return false;
  }

  const HuntOptions& options_;
  TruthSource source_;
  std::vector<ElementQuestion> questions_;  // one per objective
  std::vector<const Regime*> regimes_;
  std::mutex mutex_;
  std::vector<double> largest_told_;
};

}  // namespace

std::vector<HuntResult> hunt(const HuntOptions& options) { return Hunter(options).go(); }

}  // namespace cageproof::validation
