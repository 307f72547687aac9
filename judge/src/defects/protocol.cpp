// SPDX-License-Identifier: MIT
#include "defects/protocol.h"

#include "conventions/samples.h"
#include "conventions/tensors.h"
#include "defects/desk.h"
#include "defects/threads.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace cageproof::judge {
namespace {

using validation::Sample;

// Blocks and single calls may round differently; a result that depends on its neighbours differs by more.
constexpr double kRounding = 1e-12;

struct Trial {
  const Evaluation& theirs;
  int order;
  std::vector<Sample> samples;

  Block block(std::size_t element, std::size_t points) const {
    Block made{samples[element].corners, {}, samples[element].parameters};
    for (std::size_t p = 0; p < points; ++p)
      made.points.emplace_back(samples[element].point + (samples[p].point - samples[p].corners[0]) / 4);
    return made;
  }
};

using Evidence = std::optional<std::string>;

Evidence writes_past(const Trial& trial) {
  Desk desk(trial.theirs, trial.order);
  for (const std::size_t points : {1, 3, 8}) {
    desk.ask(trial.block(0, points));
    if (desk.wrote_past()) return fmt::format("numbers next to the output changed, in a call with {} points", points);
  }
  return std::nullopt;
}

Evidence reads_past(const Trial& trial) {
  Desk desk(trial.theirs, trial.order);
  for (const std::size_t points : {1, 3}) {
    const Block block = trial.block(1, points);
    const auto first = desk.ask(block, 0, 0);
    for (const double beyond : {1.5, 1e30, -3e-7})
      if (!same(first, desk.ask(block, 0, beyond)) && same(first, desk.ask(block, 0, 0)))
        return fmt::format("the result changes with what lies in memory behind the inputs (0 or {})", beyond);
  }
  return std::nullopt;
}

// Entries that depend on what the output held before the call, counted over pairs of calls.
struct Held {
  std::size_t kept = 0, added = 0, changed = 0;
};
Held held(const Trial& trial) {
  Held found;
  Desk desk(trial.theirs, trial.order);
  for (std::size_t element = 0; element < 6; ++element) {
    const Block block = trial.block(element, 3);
    const auto a = desk.ask(block, 3), b = desk.ask(block, 5), again = desk.ask(block, 3);
    if (!same(a, again)) continue;
    for (std::size_t i = 0; i < a.size(); ++i) {
      if (a[i] == b[i] || (std::isnan(a[i]) && std::isnan(b[i]))) continue;
      ++found.changed;
      if (a[i] == 3 && b[i] == 5) ++found.kept;
      else if (std::abs(b[i] - a[i] - 2) < 1e-6) ++found.added;
    }
  }
  return found;
}

Evidence appended(const Trial& trial) {
  const Held found = held(trial);
  if (found.added == 0 || found.added <= found.kept) return std::nullopt;
  return fmt::format("{} numbers are the result plus what the output held before the call", found.added);
}

Evidence uninitialised(const Trial& trial) {
  const Held found = held(trial);
  if (found.changed == 0) return std::nullopt;
  return fmt::format("{} numbers are what the output held before the call", found.changed);
}

Evidence by_chance(const Trial& trial) {
  Desk desk(trial.theirs, trial.order);
  for (std::size_t element = 0; element < 4; ++element) {
    const Block block = trial.block(element, 1);
    desk.ask(block);
    const auto first = desk.ask(block);
    for (int repeat = 0; repeat < 16; ++repeat)
      if (!same(first, desk.ask(block))) return "the same call, repeated, gives other numbers";
  }
  return std::nullopt;
}

Evidence by_state(const Trial& trial) {
  const Block a = trial.block(0, 1);
  Block b = trial.block(1, 1);
  b.points = a.points;
  Desk one(trial.theirs, trial.order), two(trial.theirs, trial.order), three(trial.theirs, trial.order);
  const auto first = one.ask(a), second = one.ask(b), third = one.ask(a);
  const auto apart = two.ask(b), once_more = three.ask(a);
  if (same(first, second) && same(second, apart)) {
    // The same numbers everywhere are wrong values, and no memory of an element.
    const Block elsewhere{a.corners, trial.block(0, 2).points, a.parameters};
    const auto others = one.ask(elsewhere);
    const auto half = others.size() / 2;
    if (same({others.begin(), others.begin() + static_cast<std::ptrdiff_t>(half)},
             {others.begin() + static_cast<std::ptrdiff_t>(half), others.end()}))
      return std::nullopt;
    return "a second element gives the numbers of the first";
  }
  if (same(second, apart, kRounding) && same(first, third, kRounding) && same(third, once_more, kRounding))
    return std::nullopt;
  return "an element gives other numbers after a call with another element, or in memory where another was";
}

Evidence by_order(const Trial& trial) {
  const Block block = trial.block(0, 8);
  const auto together = Desk(trial.theirs, 0).ask(block);
  const std::size_t size = together.size() / block.points.size();
  for (const bool backward : {false, true}) {
    Desk desk(trial.theirs, 0);
    std::vector<double> apart(together.size());
    for (std::size_t i = 0; i < block.points.size(); ++i) {
      const std::size_t p = backward ? block.points.size() - 1 - i : i;
      const auto answer = desk.ask({block.corners, {block.points[p]}, block.parameters});
      std::ranges::copy(answer, apart.begin() + static_cast<std::ptrdiff_t>(p * size));
    }
    if (!same(together, apart, kRounding))
      return backward ? "points asked in the reverse order give other numbers"
                      : "points asked one by one give other numbers than in a block";
  }
  return std::nullopt;
}

Evidence by_threads(const Trial& trial) {
  std::vector<Block> blocks;
  for (std::size_t i = 0; i < 4; ++i) blocks.push_back(trial.block(i, 1));
  const std::size_t differ = calls_that_differ(trial.theirs, blocks, trial.order);
  if (differ == 0) return std::nullopt;
  return fmt::format("{} of the calls made by four threads at once differ from the same calls of one thread", differ);
}

// Plain numbers, so that a call is easily made again.
Sample in_eighths(Sample sample) {
  for (auto& corner : sample.corners)
    for (double& x : corner) x = std::round(8 * x) / 8;
  for (double& x : sample.point) x = x == 0 ? 0 : (std::floor(8 * x) + 0.5) / 8;
  return sample;
}

struct Attempt {
  std::string_view key;
  Evidence (*find)(const Trial&);
};
// Defects that disturb memory come first. Chance comes before order and state, since each differs by chance as well.
constexpr std::array kAttempts{
    Attempt{"writes_past_output", writes_past}, Attempt{"non_deterministic", by_chance},
    Attempt{"appended_output", appended},       Attempt{"uninitialised_output", uninitialised},
    Attempt{"reads_past_input", reads_past},    Attempt{"order_of_calls", by_order},
    Attempt{"state_between_calls", by_state},   Attempt{"differs_between_threads", by_threads}};

}  // namespace

std::optional<FoundDefect> find_disturbed_calls(const Evaluation& theirs, std::uint64_t seed, int order) {
  Trial trial{theirs, order, convention_samples(theirs.formula(), seed, false, true)};
  for (Sample& sample : trial.samples) sample = in_eighths(sample);
  for (const Attempt& attempt : kAttempts)
    if (Evidence evidence = attempt.find(trial))
      return FoundDefect{
          .defect = &defect_named(attempt.key), .input = trial.samples[0], .cases = 1, .evidence = *evidence};
  return std::nullopt;
}

std::optional<FoundDefect> find_ignored_parameter(const Evaluation& theirs, std::uint64_t seed) {
  const Formula& formula = theirs.formula();
  const auto samples = convention_samples(formula, seed, false, false);
  for (std::size_t p = 0; p < formula.parameters.size(); ++p) {
    Sample one = samples[0], other = samples[0];
    other.parameters[p] = samples[1].parameters[p];
    if (other.parameters[p] == one.parameters[p]) continue;
    const Tensors theirs_one = tensors_of(theirs, one, 0), theirs_other = tensors_of(theirs, other, 0);
    const Tensors ours_one = reference_of(formula, one, 0), ours_other = reference_of(formula, other, 0);
    if (!same(theirs_one[0], theirs_other[0]) || same(ours_one[0], ours_other[0], 1e-9)) continue;
    return FoundDefect{
        .defect = &defect_named("ignored_parameter"),
        .order = 0,
        .input = other,
        .ours = ours_other[0],
        .theirs = theirs_other[0],
        .cases = 1,
        .evidence = fmt::format("{} = {:.6g} and {} = {:.6g} give the same numbers", formula.parameters[p].name,
                                one.parameters[p], formula.parameters[p].name, other.parameters[p])};
  }
  return std::nullopt;
}

}  // namespace cageproof::judge
