// SPDX-License-Identifier: MIT
#include "errata.h"

#include "cageproof/adaptive_qmvc/quad/mean_value/scheme_errata.h"
#include "cageproof/closed_form/published/errata.h"
#include "cageproof/validation/promise.h"
#include "cageproof/validation/regime.h"
#include "cageproof/validation/truth.h"
#include "deformers/deformer_claims.h"

#include <algorithm>
#include <cmath>
#include <functional>

namespace cageproof::validation {
namespace {

namespace published = closed_form::published;

void fill_in(const ErrataOptions& options, ErratumRow& row) {
  const Formula& formula = *find_formula(row.formula);
  const Regime& regime = *find_regime(row.regime);
  const Evaluation printed = evaluation_named(row.formula, row.evaluation);
  const Evaluation corrected = *EvaluationRegister::instance().with_role(row.formula, Role::Printed);
  const Evaluation reference = truth_source(formula).evaluation;
  const bool on_element = row.regime.starts_with("on-");
  for (std::uint64_t i = 0; row.samples < static_cast<std::uint64_t>(options.samples); ++i) {
    const Sample sample = make_sample(formula, regime, options.seed, i);
    // Special cases must be met exactly, not one ulp off.
    if (on_element && contact_of(formula.element, sample) == Contact::Off) continue;
    ++row.samples;
    Truth truth;
    truth.tensors = evaluate<Mp100>(reference, sample, row.order);  // campaigns prove it against the integral
    truth.norm[row.order] = norm(truth.tensors.of(row.order));
    truth.exists[row.order] = true;
    const auto error = [&](const Evaluation& evaluation) {
      return relative_error(evaluate<Mp50>(evaluation, sample, row.order), truth, row.order);
    };
    const double as_printed = error(printed);
    if (std::isfinite(as_printed)) row.printed_error = std::max(row.printed_error, as_printed);
    else ++row.nonfinite;
    row.corrected_error = std::max(row.corrected_error, error(corrected));
  }
}

// A row without its figures, and what fills them in; nothing where nothing is measured.
struct Unmeasured {
  ErratumRow row;
  std::function<void(ErratumRow&)> measure;
};

std::vector<Unmeasured> unmeasured(const ErrataOptions& options) {
  std::vector<Unmeasured> rows;
  for (const published::Erratum& erratum : published::errata()) {
    ErratumRow row;
    row.source = erratum.source;
    row.printed = erratum.printed;
    row.correct = erratum.correct;
    if (erratum.affected.empty()) rows.push_back({row, {}});
    for (const published::Affected& affected : erratum.affected) {
      if (!matches(options.formulas, affected.formula)) continue;
      ErratumRow& found = rows.emplace_back(row, [options](ErratumRow& r) { fill_in(options, r); }).row;
      found.formula = affected.formula;
      found.order = affected.order;
      found.evaluation = evaluation_name(erratum.as_printed);
      found.regime = erratum.regime;
    }
  }
  for (const adaptive_qmvc::SchemeErratum& erratum : adaptive_qmvc::scheme_errata())
    if (erratum.row.formula.empty() || matches(options.formulas, erratum.row.formula))
      rows.push_back({erratum.row, erratum.measure});
  // Deformers use whole kinds of coordinates, so they are asked only when all formulas are.
  if (options.formulas == "*")
    for (const DeformerClaim& claim : deformer_claims()) rows.push_back({claim.row, claim.measure});
  return rows;
}

// One row per block.
class ErrataMeasurement final : public Measurement {
 public:
  explicit ErrataMeasurement(const ErrataOptions& options) : rows_(unmeasured(options)) {}

  std::string name() const override { return "errata"; }
  int blocks() const override { return static_cast<int>(rows_.size()); }

  PartialResult measure(int block) const override {
    ErratumRow row = rows_[block].row;
    if (rows_[block].measure) rows_[block].measure(row);
    PartialResult gathered;
    gathered.errata.emplace(block, std::move(row));
    return gathered;
  }

 private:
  std::vector<Unmeasured> rows_;
};

}  // namespace

std::unique_ptr<const Measurement> errata_measurement(const ErrataOptions& options) {
  return std::make_unique<ErrataMeasurement>(options);
}

std::vector<ErratumRow> measure_errata(const ErrataOptions& options) {
  Measurements measurements;
  measurements.push_back(errata_measurement(options));
  std::vector<ErratumRow> rows;
  for (auto& [place, row] : measure_all(measurements, options.jobs).errata) rows.push_back(std::move(row));
  return rows;
}

}  // namespace cageproof::validation
