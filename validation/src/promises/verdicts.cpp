// SPDX-License-Identifier: MIT
#include "verdicts.h"

#include "cageproof/core/coordinates/whole_evaluation.h"
#include "cageproof/reports/broken_groups.h"
#include "cageproof/validation/check.h"
#include "cageproof/validation/promise.h"
#include "cageproof/validation/regime.h"
#include "run/report_order.h"

#include <fmt/format.h>

namespace cageproof::validation {
namespace {

bool has_use(const RowKey& row, Check::Use use) {
  const Check* check = find_check(row.check);
  return check && check->use() == use;
}

// Whether an evaluation may say that it could not meet its tolerance. The gate and the proofs name the recommended one,
// but what declines there is the integral or the enclosure.
bool may_decline(const ResultRow& row) {
  if (has_use(row, Check::Use::Gate) || has_use(row, Check::Use::Proof)) return true;
  return !row.role.empty() && row.role != name_of(Role::Recommended) && row.role != name_of(Role::ClosedForm) &&
         row.role != name_of(Role::Stated);
}

// The role of the row's evaluation: for a single element's row that of its formula's, for a cage's row that of the
// formulas that its kind sums.
std::optional<Role> registered_role(const RowKey& row) {
  const auto& known = EvaluationRegister::instance();
  if (row.section == RowKey::Section::Element) {
    const auto evaluation = known.find(row.subject, row.evaluation);
    return evaluation ? std::optional(evaluation->role()) : std::nullopt;
  }
  if (row.section == RowKey::Section::Deformer) return std::nullopt;
  if (const WholeEvaluation* whole = find_whole_evaluation(row.evaluation)) return whole->role;
  const CoordinateKind* kind = find_coordinate_kind(row.subject);
  if (kind == nullptr || !kind->is_sum()) return std::nullopt;
  for (const ElementKind element : element_kinds)
    if (const Formula* formula = find_formula(element, kind->blocks.front().kernel))
      if (const auto evaluation = known.find(formula->name, row.evaluation)) return evaluation->role();
  return std::nullopt;
}

// Where the samples went.
std::string loss(const ResultRow& row) {
  std::vector<std::string> parts;
  if (row.unreached > 0) parts.push_back(fmt::format("{} had no truth or figure though a limit exists", row.unreached));
  if (row.declined > 0 && !may_decline(row)) parts.push_back(fmt::format("{} were declined", row.declined));
  const std::uint64_t known = row.samples + row.without_truth + row.unreached + row.declined;
  if (row.asked > known) parts.push_back(fmt::format("{} were not heard of", row.asked - known));
  return fmt::format("{} of {} samples are lost: {}", lost_samples(row), row.asked, fmt::join(parts, ", "));
}

// Where the closed form in multiprecision has not agreed with the integral, nothing that was measured against it
// counts: the gate's own row is broken for all of them. Where the integral was asked and could say nothing, the row is
// undecided, and broken where the run has all samples of its suite: these are chosen so that it can.
void withdraw_unproven(Judged& result, Samples samples) {
  const auto same_place = [](const RowKey& a, const RowKey& b) {
    return a.subject == b.subject && a.setting == b.setting && a.order == b.order;
  };
  for (ResultRow& gate : result.rows) {
    if (!has_use(gate, Check::Use::Gate) || gate.verdict == Verdict::Kept) continue;
    std::size_t promised = 0;
    const WorstCase* example = nullptr;
    const bool silent = gate.verdict == Verdict::NotPromised;
    for (ResultRow& row : result.rows) {
      if (has_use(row, Check::Use::Gate) || has_use(row, Check::Use::Proof) || !same_place(row, gate)) continue;
      promised += row.verdict != Verdict::NotPromised;
      if (example == nullptr && row.verdict != Verdict::NotPromised && !row.worst.empty()) example = &row.worst.front();
      // A broken row stays broken where the integral says nothing.
      if (silent && row.verdict == Verdict::Broken) continue;
      row.verdict = Verdict::NotPromised;
      row.reason = "the truth is not confirmed by the integral here";
    }
    if (gate.verdict == Verdict::Broken) {
      result.notes.push_back(
          fmt::format("{}, {}, order {}: the closed form in multiprecision is not the integral; nothing measured "
                      "against it counts",
                      gate.subject, gate.setting, gate.order));
    } else if (promised > 0) {
      gate.verdict = samples == Samples::All ? Verdict::Broken : Verdict::Undecided;
      gate.reason = fmt::format(
          "{}the integral confirmed the truth on none of {} samples ({} without a limit, {} declined), and {} promised "
          "rows rest on it{}",
          samples == Samples::All ? "" : "not enough samples: ", gate.asked, gate.without_truth, gate.declined,
          promised, example ? ", measured for instance at " + reports::input_line(*example) : "");
    }
  }
}

// Nothing where the row is none that curves are drawn of.
std::optional<ResultCurve> curve_of(const ResultRow& row, const Tally& tally) {
  const Regime* regime = find_regime(row.setting);
  if (tally.by_parameter.empty() || !regime || regime->parameters.size() < tally.by_parameter.size())
    return std::nullopt;
  ResultCurve curve{row, std::string(regime->parameter_name), {}, {}, row.role};
  for (std::size_t i = 0; i < tally.by_parameter.size(); ++i)
    if (tally.by_parameter[i] >= 0) {
      curve.parameters.push_back(regime->parameters[i]);
      curve.errors.push_back(tally.by_parameter[i]);
    }
  return curve;
}

}  // namespace

std::uint64_t lost_samples(const ResultRow& row) {
  const std::uint64_t excused = row.samples + row.without_truth + (may_decline(row) ? row.declined : 0);
  return row.asked > excused ? row.asked - excused : 0;
}

void judge(ResultRow& row) {
  const PromiseKey key{row.check, row.subject, row.evaluation, row.scalar, row.setting, row.order};
  // Rows that are read from a journal say what their evaluation is, which this program may not have.
  const auto stored = std::ranges::find_if(roles, [&](const Role role) { return name_of(role) == row.role; });
  require_row(key, stored != roles.end() ? std::optional(*stored) : registered_role(row));
  const Promise promise = promise_for(key);
  row.bound = promise.bound;
  row.reason = promise.reason;
  row.verdict = !row.bound || row.samples == 0 ? Verdict::NotPromised
                : row.max <= *row.bound        ? Verdict::Kept
                                               : Verdict::Broken;
  if (!row.bound) return;
  // A bound that any result would meet is no promise. Finite results for finite truths were checked all the same.
  if (row.verdict == Verdict::Kept && row.is_ill_posed()) {
    row.verdict = Verdict::NotPromised;
    row.reason = fmt::format(
        "ill-posed here: a result without one right digit would score {:.2g} at most, within the bound of {:.2g}",
        row.total_loss, *row.bound);
  }
  // A row that measured nothing keeps no promise, and breaks none where there was nothing to measure.
  if (row.samples == 0) row.reason = "no sample had a truth, or a statement, to be measured against";
  if (lost_samples(row) == 0) return;
  row.reason = row.verdict == Verdict::Broken ? fmt::format("{}; {}", row.reason, loss(row)) : loss(row);
  row.verdict = Verdict::Broken;
}

std::string role_of(const RowKey& key) {
  const auto role = registered_role(key);
  return role ? std::string(name_of(*role)) : std::string();
}

ResultRow row_of(const RowKey& key, const Tally& tally) {
  ResultRow row;
  static_cast<RowKey&>(row) = key;
  static_cast<RowFigures&>(row) = tally;
  // Journals of earlier programs hold no roles.
  if (row.role.empty()) row.role = role_of(key);
  row.samples = tally.errors.count();
  row.nonfinite = tally.errors.nonfinite();
  row.max = tally.errors.max();
  row.p999 = tally.errors.p999();
  row.median = tally.errors.median();
  row.worst = tally.worst.cases();
  const auto counts = tally.errors.counts();
  row.histogram.assign(counts.begin(), counts.end());
  row.is_foundation = has_use(row, Check::Use::Gate) || has_use(row, Check::Use::Proof);
  judge(row);
  return row;
}

Judged judged(std::map<RowKey, Tally>&& tallies, Samples samples) {
  Judged result;
  result.rows.reserve(tallies.size());
  for (auto& [key, tally] : tallies) {
    if (!tally.empty()) result.rows.push_back(row_of(key, tally));
    // Curves need the rest of the tally.
    tally.errors = ErrorHistogram();
    tally.worst = WorstCases();
  }
  sort_for_report(result.rows);
  withdraw_unproven(result, samples);
  for (const ResultRow& row : result.rows)
    if (auto curve = curve_of(row, tallies.at(row))) result.curves.push_back(std::move(*curve));
  tallies.clear();
  return result;
}

}  // namespace cageproof::validation
