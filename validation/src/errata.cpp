// SPDX-License-Identifier: MIT
#include "cageproof/validation/errata.h"

#include "cageproof/closed_form/published/errata.h"
#include "cageproof/validation/promise.h"
#include "cageproof/validation/regime.h"
#include "cageproof/validation/truth.h"

#include <algorithm>
#include <cmath>

namespace cageproof::validation {
namespace {

namespace published = closed_form::published;

void measure(const ErrataOptions& options, ErratumRow& row) {
  const Formula& formula = *find_formula(row.formula);
  const Regime& regime = *find_regime(row.regime);
  const auto found = [&](std::string_view name) { return *EvaluationRegister::instance().find(row.formula, name); };
  const Evaluation printed = found(row.evaluation), corrected = found("published"), reference = found("closed_form");
  const bool on_element = row.regime.starts_with("on-");
  for (std::uint64_t i = 0; row.samples < static_cast<std::uint64_t>(options.samples); ++i) {
    const Sample sample = make_sample(formula, regime, options.seed, i);
    // Special cases are those that are met exactly, not one ulp off.
    if (on_element && contact_of(sample) == Contact::None) continue;
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

}  // namespace

std::vector<ErratumRow> measure_errata(const ErrataOptions& options) {
  std::vector<ErratumRow> rows;
  for (const published::Erratum& erratum : published::errata()) {
    ErratumRow row;
    row.source = erratum.source;
    row.printed = erratum.printed;
    row.correct = erratum.correct;
    if (erratum.affected.empty()) rows.push_back(row);
    for (const published::Affected& affected : erratum.affected) {
      if (!matches(options.formulas, affected.formula)) continue;
      ErratumRow measured = row;
      measured.formula = affected.formula;
      measured.order = affected.order;
      measured.evaluation = evaluation_name(erratum.as_printed);
      measured.regime = erratum.regime;
      measure(options, measured);
      rows.push_back(measured);
    }
  }
  return rows;
}

}  // namespace cageproof::validation
