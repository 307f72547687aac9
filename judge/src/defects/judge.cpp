// SPDX-License-Identifier: MIT
#include "cageproof/judge/verdict.h"

#include "defects/protocol.h"
#include "defects/shrink.h"
#include "defects/signatures.h"

#include "cageproof/core/input_error.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>

namespace cageproof::judge {
namespace {

using validation::Sample;

const Signature& explaining(const Study& study, const Case& c) {
  return *std::ranges::find_if(signatures(), [&](const Signature& s) { return s.explains(study, c); });
}

std::vector<double> in_double(const std::vector<Mp100>& tensor) {
  std::vector<double> numbers;
  numbers.reserve(tensor.size());
  for (const Mp100& x : tensor) numbers.push_back(static_cast<double>(x));
  return numbers;
}

bool is_ambiguous(const Study& study, const Case& c) {
  return place_of(study.formula().element, c.probe->sample).ambiguous;
}

// The finding of one defect from all the cases that it explains.
FoundDefect finding_of(const Study& study, const Signature& signature, const std::vector<const Case*>& cases) {
  const int dim = study.formula().dim();
  const Case& shortest = **std::ranges::min_element(cases, {}, [&](const Case* c) {
    return std::tuple(c->order, is_ambiguous(study, *c), length_of(c->probe->sample, dim));
  });
  const int order = shortest.order;
  const auto shows = [&](const Sample& sample) {
    const Probe probe = study.prober().at(sample);
    const Case c = study.ask(probe, order);
    return c.bad && &explaining(study, c) == &signature;
  };
  const Sample input = shrunk(shortest.probe->sample, study.formula().element, shows);
  const Probe probe = study.prober().at(input);
  const Case smallest = study.ask(probe, order);
  return {.defect = &defect_named(signature.key),
          .order = order,
          .input = input,
          .ours = in_double(probe.truth.tensors.of(order)),
          .theirs = smallest.found.of(order),
          .error = smallest.error,
          .cases = cases.size(),
          .evidence = signature.evidence(study, smallest)};
}

using Explained = std::map<const Signature*, std::vector<const Case*>>;

// A rounding off an edge or the plane, several defects look alike: what is found elsewhere explains such cases, and
// only where nothing is they count by themselves.
Explained explained_by_signature(const Study& study) {
  Explained clear, ambiguous;
  for (const Case& c : study.cases())
    if (c.bad) (is_ambiguous(study, c) ? ambiguous : clear)[&explaining(study, c)].push_back(&c);
  if (clear.empty()) return ambiguous;
  for (auto& [signature, cases] : clear)
    if (const auto more = ambiguous.find(signature); more != ambiguous.end())
      cases.insert(cases.end(), more->second.begin(), more->second.end());
  return clear;
}

std::vector<FoundDefect> findings_of(const Study& study) {
  const Explained explained = explained_by_signature(study);
  std::vector<FoundDefect> findings;
  for (const Signature& signature : signatures())
    if (const auto found = explained.find(&signature); found != explained.end())
      findings.push_back(finding_of(study, signature, found->second));
  return findings;
}

}  // namespace

Verdict judge(const Evaluation& theirs, const JudgeOptions& options) {
  if (!theirs.supports<double>())
    throw InputError(fmt::format("{} of {} has no double: judge needs one", theirs.name(), theirs.formula().name));
  const int order = std::min({1, options.max_order, theirs.max_order()});
  Verdict verdict;
  if (auto disturbed = find_disturbed_calls(theirs, options.seed, order)) {
    verdict.convention_sentence = "not looked for, because calls disturb each other";
    verdict.values_judged = false;
    verdict.findings.push_back(std::move(*disturbed));
    return verdict;
  }
  verdict.convention = find_convention(theirs, options.seed);
  bool presets = false;
  if (!verdict.convention)
    if (auto ignored = find_ignored_parameter(theirs, options.seed)) {
      verdict.findings.push_back(std::move(*ignored));
      presets = true;
      verdict.convention = find_convention(theirs, options.seed, presets);
    }
  verdict.convention_sentence = verdict.convention ? verdict.convention->sentence
                                                   : "none fits all generic samples, so that yours is taken for ours";
  const Evaluation ours =
      in_our_convention(theirs, verdict.convention.value_or(Convention{.formula = std::string(theirs.formula().name)}));
  const Study study(ours, options.seed, order, presets, verdict.convention && verdict.convention->normalised);
  verdict.samples = study.samples();
  std::ranges::move(findings_of(study), std::back_inserter(verdict.findings));
  return verdict;
}

}  // namespace cageproof::judge
