// SPDX-License-Identifier: MIT
#include "cageproof/judge/certificate.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace cageproof::judge {
namespace {

// Lengths whose powers leave the range of the scalar are there.
bool is_of_range(const CampaignRow& row) { return row.regime == "scaled" || row.regime == "tiny"; }

// The paragraphs of docs/defects.md that cure what is not finite there.
std::string_view cure_of(std::string_view regime) {
  if (regime.ends_with("-vertex")) return "; see docs/defects.md#nan_at_vertex";
  if (regime.ends_with("-edge")) return "; see docs/defects.md#nan_at_edge, and docs/defects.md#log_next_to_edge";
  return regime.ends_with("-face") ? "; see docs/defects.md#nan_at_face" : "";
}

void add_nonfinite(const SubjectCampaign& campaign, std::vector<CodeFinding>& found) {
  for (const CampaignRow& row : campaign.rows) {
    if (row.nonfinite == 0) continue;
    const bool range = is_of_range(row);
    found.push_back({range ? "range" : "not finite",
                     fmt::format("{}: NaN or infinite at {} of {} samples where the formula is finite{}", row.regime,
                                 row.nonfinite, row.samples,
                                 range ? " (the unit of length leaves the range of its intermediate results)"
                                       : cure_of(row.regime)),
                     campaign.subject, row.order, row.nonfinite_input, static_cast<std::uint64_t>(row.nonfinite),
                     !range});
  }
}

// Where half of all easy inputs have not three digits, it is another formula, or another convention.
void add_other_numbers(const SubjectCampaign& campaign, std::vector<CodeFinding>& found) {
  constexpr double three_digits = 1e-3;
  for (const CampaignRow& row : campaign.rows)
    if ((row.regime == "generic" || row.regime == "inside") && row.samples > 0 && row.relative.median > three_digits)
      found.push_back({"other numbers",
                       fmt::format("{}: half of the samples are off by {:.2g} or more: another convention, or "
                                   "another formula",
                                   row.regime, row.relative.median),
                       campaign.subject, row.order, row.relative.input, static_cast<std::uint64_t>(row.samples), true});
}

void add_wrong_sides(const SubjectCampaign& campaign, std::vector<CodeFinding>& found) {
  for (const CampaignRow& row : campaign.rows)
    if (row.wrong > 0)
      found.push_back(
          {"wrong side",
           fmt::format("{}: {} of {} points; the first is {}", row.regime, row.wrong, row.samples, row.first_wrong),
           campaign.subject, 0, row.absolute.input, static_cast<std::uint64_t>(row.wrong), true});
}

// Half of double's digits, beyond what rounding the input costs.
constexpr double half_the_digits = 0x1p26;

void add_inaccurate(const SubjectCampaign& campaign, std::vector<CodeFinding>& found) {
  const std::string formula(campaign.subject);
  for (const CampaignRow& row : campaign.rows) {
    // Points a rounding off an element round to either side of it.
    const bool is_on = row.regime.starts_with("on-");
    const bool range = is_of_range(row);
    if (!is_on && row.beside.error > half_the_digits && std::isfinite(row.beside.error))
      found.push_back({range ? "range" : "inaccurate",
                       fmt::format("{}: off by up to {:.2g} conditioned units: eight digits or more are lost beyond "
                                   "what rounding the input costs",
                                   row.regime, row.beside.error),
                       formula, row.order, row.beside.input, 1, !range});
    if (row.continuous.error > half_the_digits && std::isfinite(row.continuous.error))
      found.push_back({"on the element",
                       fmt::format("{}: coordinates that are continuous across the cage are off by up to {:.2g} "
                                   "conditioned units there: no limit from any side is so",
                                   row.regime, row.continuous.error),
                       formula, row.order, row.continuous.input, 1, true});
    const LargestError& on = is_on && row.beside.error > row.on.error ? row.beside : row.on;
    if (on.error > half_the_digits && std::isfinite(on.error))
      found.push_back({"on the element",
                       fmt::format("{}: another value where the point lies on the element, or a rounding off it; the "
                                   "truth is the limit from the inside",
                                   row.regime),
                       formula, row.order, on.input, 1, false});
  }
}

double error_of(const CampaignRow& row, OwnPromise::Measure measure, double unit, const LargestError*& largest) {
  largest = measure == OwnPromise::Measure::Relative   ? &row.relative
            : measure == OwnPromise::Measure::Absolute ? &row.absolute
                                                       : &row.conditioned;
  return measure == OwnPromise::Measure::Conditioned ? largest->error * unit : largest->error;
}

}  // namespace

std::string_view name_of(OwnPromise::Measure measure) {
  constexpr std::array<std::string_view, 3> names{"relative", "absolute", "conditioned"};
  return names[static_cast<std::size_t>(measure)];
}

bool Certificate::has_defects() const {
  return std::ranges::any_of(findings, &CodeFinding::is_defect) || (promise && !promise->is_kept);
}

bool Certificate::is_undecided() const {
  if (skipped > 0) return true;
  for (const SubjectCampaign& campaign : formulas)
    for (const CampaignRow& row : campaign.rows)
      if (row.samples == 0 || row.declined > 0) return true;
  return false;
}

std::vector<CodeFinding> findings_of(const std::vector<SubjectCampaign>& campaigns,
                                     const std::vector<Incident>& incidents) {
  std::vector<CodeFinding> found;
  found.reserve(incidents.size());
  for (const Incident& incident : incidents)
    found.push_back(
        {incident.kind, incident.text, incident.formula, incident.order, incident.input, incident.count, true});
  for (const SubjectCampaign& campaign : campaigns) {
    if (campaign.has_sides) {
      add_wrong_sides(campaign, found);
      continue;
    }
    const std::size_t before = found.size();
    add_other_numbers(campaign, found);
    // Another formula is wrong everywhere, so that no regime is named.
    if (found.size() == before) add_inaccurate(campaign, found);
    add_nonfinite(campaign, found);
  }
  return found;
}

OwnPromise judged_promise(OwnPromise promise, const std::vector<SubjectCampaign>& campaigns, bool single) {
  const double unit = single ? 0x1p-24 : 0x1p-53;
  for (const SubjectCampaign& campaign : campaigns)
    for (const CampaignRow& row : campaign.rows) {
      const LargestError* largest = nullptr;
      const double error = error_of(row, promise.measure, unit, largest);
      if (error <= promise.bound && row.failed == 0) continue;
      promise.is_kept = false;
      promise.broken.push_back(row.failed > 0 ? fmt::format("{}, {}, order {}: {} samples without an answer",
                                                            campaign.subject, row.regime, row.order, row.failed)
                                              : fmt::format("{}, {}, order {}: {:.3g} at {}", campaign.subject,
                                                            row.regime, row.order, error, largest->input));
    }
  return promise;
}

double digits_of(double relative_error) {
  constexpr double most = 17;
  if (!(relative_error < 1)) return 0;
  return relative_error <= 0 ? most : std::clamp(-std::log10(relative_error), 0., most);
}

}  // namespace cageproof::judge
