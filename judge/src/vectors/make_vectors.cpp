// SPDX-License-Identifier: MIT
#include "cageproof/judge/vectors.h"

#include "cageproof/core/input_error.h"
#include "cageproof/core/parallel.h"
#include "cageproof/reports/worst_file.h"
#include "cageproof/validation/hunt.h"
#include "cageproof/validation/regime.h"
#include "cageproof/validation/stored_cases.h"

#include <fmt/format.h>

#include <algorithm>

namespace cageproof::judge {
namespace {

using namespace validation;

// Prime to every sweep's length, so that all decades are visited.
constexpr std::uint64_t stride = 7;

std::vector<TestVector> candidates_of(const Formula& formula, const VectorOptions& options) {
  std::vector<TestVector> found;
  const auto add = [&](Sample sample, std::string_view regime) {
    TestVector vector;
    vector.sample = std::move(sample);
    vector.regime = regime;
    if (is_finite(vector.sample)) found.push_back(std::move(vector));
  };
  // Regimes in turn, so that a limit on the number leaves none out.
  for (int i = 0; i < options.samples; ++i)
    for (const Regime& regime : regimes())
      if (exists_for(regime, formula.element))
        add(make_sample(formula, regime, options.seed, stride * static_cast<std::uint64_t>(i)), regime.name);
  std::vector<TestVector> stored;
  for (const auto& line : reports::parse_worst(stored_worst_cases(), stored_cases_file)) {
    if (line.subject != formula.name || line.scalar != "double") continue;
    const auto& worst = line.worst;
    const bool known = std::ranges::any_of(stored, [&](const TestVector& v) {
      return v.sample.corners == worst.corners && v.sample.point == worst.point;
    });
    if (known) continue;
    TestVector vector;
    vector.sample = {worst.corners, worst.point, worst.parameters, worst.parameter, worst.sample};
    vector.regime = hunted_regime;
    stored.push_back(std::move(vector));
  }
  // First, because a limit on the number must keep them.
  found.insert(found.begin(), stored.begin(), stored.end());
  return found;
}

// Doubles must hold a truth with all their digits, or it is exactly zero.
bool fits_doubles(const Truth& truth, int order) {
  static const Mp100 least("1e-280"), most("1e280");
  const auto& norm = truth.norm[order];
  return truth.exists[order] && truth.conditioned[order] < most && norm < most && (norm == 0 || norm > least);
}

bool fails(const KnownDefect& defect, const Formula& formula, const TestVector& vector) {
  static const Mp100 u = unit_roundoff<double>();
  int highest = 2;
  while (highest > 0 && !vector.has[highest]) --highest;
  for (int order = highest; order >= 0; --order) {
    const auto wrong = defect.result(formula, vector.sample, order);
    if (!wrong) continue;
    for (int o = 0; o <= order; ++o)
      if (vector.has[o] && !(conditioned_error(*wrong, vector.truth, o, u) <= vector_bound)) return true;
    return false;
  }
  return false;
}

void fill(TestVector& vector, const Formula& formula, const TruthSource& source) {
  vector.truth = truth_from(source, vector.sample, 2);
  for (int o = 0; o < 3; ++o) vector.has[o] = fits_doubles(vector.truth, o);
  if (!vector.has[0]) return;
  for (const KnownDefect& defect : known_defects())
    if (fails(defect, formula, vector)) vector.defects.emplace_back(defect.name);
}

void prove(TestVector& vector, const Evaluation& certified) {
  const Result<Mp50> ball = evaluate<Mp50>(certified, vector.sample, 0);
  const auto& radius = ball.radius_of(0);
  if (!ball.converged || radius.size() != ball.value.size()) return;
  std::vector<Mp100> about;
  for (std::size_t i = 0; i < radius.size(); ++i) {
    if (!isfinite(radius[i]) || !isfinite(ball.value[i])) return;
    const Mp100 off = abs(Mp100(ball.value[i]) - vector.truth.tensors.value[i]);
    if (off > Mp100(radius[i]) + abs(vector.truth.tensors.value[i]) * Mp100("1e-30"))
      throw InputError("a truth lies outside of its proven interval: this is an error of Cageproof, please report it");
    // The printed truth has 40 digits, and the printed radius three, rounded by half a hundredth at most.
    about.push_back(Mp100("1.01") * (off + Mp100(radius[i]) + abs(vector.truth.tensors.value[i]) * Mp100("1e-39")));
  }
  vector.radius = std::move(about);
}

}  // namespace

VectorSet make_vectors(const Formula& formula, const VectorOptions& options) {
  const TruthSource source = truth_source(formula);
  VectorSet set{&formula, {}, 0, 0};
  std::vector<TestVector> found = candidates_of(formula, options);
  for_each_parallel(found.size(), options.jobs, [&](std::size_t i) { fill(found[i], formula, source); });
  std::size_t numbers = 0;
  for (TestVector& vector : found) {
    if (!vector.has[0]) continue;
    ++set.candidates;
    if (vector.defects.empty()) {
      ++set.without_defect;
      continue;
    }
    if (numbers >= options.numbers) continue;
    for (int o = 0; o < 3; ++o)
      if (vector.has[o]) numbers += vector.truth.tensors.of(o).size();
    set.vectors.push_back(std::move(vector));
  }
  const auto certified = EvaluationRegister::instance().with_role(formula.name, Role::Enclosure);
  if (certified && certified->supports<Mp50>()) {
    const std::size_t proven = (set.vectors.size() + options.proof_stride - 1) / options.proof_stride;
    for_each_parallel(proven, options.jobs,
                      [&](std::size_t i) { prove(set.vectors[i * options.proof_stride], *certified); });
  }
  return set;
}

}  // namespace cageproof::judge
