// SPDX-License-Identifier: MIT
#include "cageproof/validation/verdicts.h"

#include "cageproof/validation/check.h"
#include "cageproof/validation/promise.h"
#include "cageproof/validation/regime.h"
#include "report_order.h"

#include <fmt/format.h>

namespace cageproof::validation {
namespace {

bool has_role(const RowKey& row, Check::Role role) {
  const Check* check = find_check(row.check);
  return check && check->role() == role;
}

// Where the closed form in multiprecision has not agreed with the integral, nothing that was measured against it
// counts.
void withdraw_unproven(Judged& result) {
  const auto same_place = [](const RowKey& a, const RowKey& b) {
    return a.subject == b.subject && a.regime == b.regime && a.order == b.order;
  };
  for (const ResultRow& gate : result.rows) {
    if (!has_role(gate, Check::Role::Gate) || gate.verdict == Verdict::Kept) continue;
    result.notes.push_back(
        gate.samples == 0
            ? fmt::format(
                  "{}, {}, order {}: the integral confirmed the truth on none of {} samples (no limit, or fewer than "
                  "30 digits)",
                  gate.subject, gate.regime, gate.order, gate.without_truth)
            : fmt::format(
                  "{}, {}, order {}: the closed form in multiprecision is not the integral; nothing measured against "
                  "it counts",
                  gate.subject, gate.regime, gate.order));
    for (ResultRow& row : result.rows)
      if (!has_role(row, Check::Role::Gate) && !has_role(row, Check::Role::Proof) && same_place(row, gate)) {
        row.verdict = Verdict::NotPromised;
        row.reason = "the truth is not confirmed by the integral here";
      }
  }
}

// Nothing where the row is none that curves are drawn of.
std::optional<ResultCurve> curve_of(const RowKey& key, const Tally& tally) {
  const Regime* regime = find_regime(key.regime);
  if (tally.by_parameter.empty() || !regime || regime->parameters.size() < tally.by_parameter.size())
    return std::nullopt;
  ResultCurve curve{key, std::string(regime->parameter_name), {}, {}};
  for (std::size_t i = 0; i < tally.by_parameter.size(); ++i)
    if (tally.by_parameter[i] >= 0) {
      curve.parameters.push_back(regime->parameters[i]);
      curve.errors.push_back(tally.by_parameter[i]);
    }
  return curve;
}

}  // namespace

bool truth_must_exist(const RowKey& key) {
  return key.section == RowKey::Section::Element && !key.regime.starts_with("on-") &&
         has_role(key, Check::Role::Truth) && key.scalar != "float";
}

void judge(ResultRow& row) {
  const Promise promise = promise_for({row.check, row.subject, row.evaluation, row.scalar, row.regime, row.order});
  row.bound = promise.bound;
  row.reason = promise.reason;
  if (row.bound && row.without_truth > 0 && truth_must_exist(row)) {
    row.verdict = Verdict::Broken;
    row.reason = "the closed form in multiprecision has no value on some samples";
    return;
  }
  // A row that measured nothing keeps no promise and breaks none.
  if (row.bound && row.samples == 0) row.reason = "no sample had a truth, or a statement, to be measured against";
  row.verdict = !row.bound || row.samples == 0 ? Verdict::NotPromised
                : row.max <= *row.bound        ? Verdict::Kept
                                               : Verdict::Broken;
}

ResultRow row_of(const RowKey& key, const Tally& tally) {
  ResultRow row;
  static_cast<RowKey&>(row) = key;
  row.unit = tally.unit;
  row.samples = tally.errors.count();
  row.nonfinite = tally.errors.nonfinite();
  row.without_truth = tally.without_truth;
  row.declined = tally.declined;
  row.max = tally.errors.max();
  row.p999 = tally.errors.p999();
  row.median = tally.errors.median();
  row.max_relative = tally.max_relative;
  row.worst = tally.worst.cases();
  row.histogram.assign(tally.errors.counts().begin(), tally.errors.counts().end());
  judge(row);
  return row;
}

Judged judged(const std::map<RowKey, Tally>& tallies) {
  Judged result;
  for (const auto& [key, tally] : tallies)
    if (!tally.empty()) result.rows.push_back(row_of(key, tally));
  sort_for_report(result.rows);
  withdraw_unproven(result);
  for (const ResultRow& row : result.rows)
    if (auto curve = curve_of(row, tallies.at(row))) result.curves.push_back(std::move(*curve));
  return result;
}

}  // namespace cageproof::validation
