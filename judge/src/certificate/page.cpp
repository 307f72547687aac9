// SPDX-License-Identifier: MIT
#include "cageproof/judge/certificate.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace cageproof::judge {
namespace {

constexpr std::array<const char*, 3> order_names{"value", "gradient", "Hessian"};

std::string times_text(const SubjectCampaign& campaign) {
  std::string text;
  for (const PairTime& time : campaign.times)
    text += fmt::format("{}{} {} {:.0f} ns", text.empty() ? "" : ", ", time.evaluation, order_names[time.order],
                        time.nanoseconds);
  return text.empty() ? "not measured, because an answer failed" : text;
}

// "1.2e-15", and "0" for none.
std::string short_number(double x) { return x == 0 ? "0" : std::isinf(x) ? "inf" : fmt::format("{:.1e}", x); }

std::string finding_line(const CodeFinding& finding) {
  std::string text = fmt::format("{} ({})", finding.kind, finding.is_defect ? "defect" : "remark");
  if (!finding.formula.empty()) text += fmt::format(", {}, {}", finding.formula, order_names[finding.order]);
  text += fmt::format(": {}", finding.text);
  if (finding.count > 1) text += fmt::format("; {} times", finding.count);
  return text;
}

// A row's members, as both tables show them.
std::vector<std::string> cells(const CampaignRow& row) {
  if (row.samples == 0) return {row.regime, order_names[row.order], "0", "-", "-", "-", "-", "-"};
  return {row.regime,
          order_names[row.order],
          fmt::format("{}", row.samples),
          short_number(row.relative.median),
          short_number(row.relative.error),
          fmt::format("{:.1f}", std::floor(10 * digits_of(row.relative.error)) / 10),
          row.conditioned.median < 0.01 ? "0" : fmt::format("{:.2g}", row.conditioned.median),
          std::isinf(row.conditioned.error) ? "inf" : fmt::format("{:.2g}", row.conditioned.error)};
}

const std::vector<std::string>& headings() {
  static const std::vector<std::string> all{
      "regime", "order", "samples", "relative: median", "worst", "digits", "conditioned: median", "worst"};
  return all;
}

// "1 declined" and the like.
std::string rest_of(const CampaignRow& row) {
  std::string rest;
  if (row.without_truth > 0) rest += fmt::format(" {} without a limit", row.without_truth);
  if (row.declined > 0) rest += fmt::format(" {} declined", row.declined);
  if (row.failed > 0) rest += fmt::format(" {} FAILED", row.failed);
  if (row.nonfinite > 0) rest += fmt::format(" {} not finite", row.nonfinite);
  return rest;
}

std::string side_table(const SubjectCampaign& campaign, bool with_inputs) {
  std::string text = fmt::format("sides of cages\n  {:<12}{:>7}{:>7}  {}\n", "regime", "samples", "wrong",
                                 with_inputs ? "first wrong input" : "");
  for (const CampaignRow& row : campaign.rows)
    text += fmt::format("  {:<12}{:>7}{:>7} {}{}\n", row.regime, row.samples, row.wrong, rest_of(row),
                        with_inputs && row.wrong > 0 ? " " + row.absolute.input : "");
  return text;
}

std::string side_page(const SubjectCampaign& campaign) {
  std::string text = "\n## sides of cages\n\n| regime | samples | wrong | first wrong input |\n|---|---|---|---|\n";
  for (const CampaignRow& row : campaign.rows)
    text += fmt::format("| {} | {} | {} | {} |\n", row.regime, row.samples, row.wrong,
                        row.wrong > 0 ? "`" + row.absolute.input + "`" : "");
  return text;
}

}  // namespace

std::string table_of(const SubjectCampaign& campaign, bool with_inputs) {
  if (campaign.has_sides) return side_table(campaign, with_inputs);
  std::string text = fmt::format("{}, up to the {}; time a pair: {}\n", campaign.subject, order_names[campaign.order],
                                 times_text(campaign));
  text += fmt::format("  {:<12}{:<9}{:>7}  {:>8}{:>9}{:>7}  {:>8}{:>9}  {}\n", "regime", "order", "samples", "relative",
                      "worst", "digits", "units", "worst", with_inputs ? "worst input (conditioned)" : "");
  for (const CampaignRow& row : campaign.rows) {
    const auto c = cells(row);
    std::string rest = rest_of(row);
    if (with_inputs && !row.conditioned.input.empty()) rest += " " + row.conditioned.input;
    text += fmt::format("  {:<12}{:<9}{:>7}  {:>8}{:>9}{:>7}  {:>8}{:>9} {}\n", c[0], c[1], c[2], c[3], c[4], c[5],
                        c[6], c[7], rest);
  }
  return text;
}

std::string markdown_of(const Certificate& c) {
  std::string text = fmt::format("# {}: {}\n\n", c.name,
                                 c.has_defects()    ? "defects"
                                 : c.is_undecided() ? "undecided"
                                                    : "clean");
  text += fmt::format("Judged: `{}`{}\n\n", c.what, c.about.empty() ? "" : fmt::format(", which says: {}", c.about));
  for (const JudgedFile& file : c.files) text += fmt::format("* `{}`, SHA-256 `{}`\n", file.path, file.sha256);
  text += fmt::format(
      "\n{} samples for each formula and regime, seed {}, in {}. Figures are sampled. cageproof {} ({}), {}.\n",
      c.samples, c.seed, c.scalar, c.version, c.commit, c.started);
  text += "\n## Findings\n\n";
  if (c.findings.empty()) text += "None.\n";
  for (const CodeFinding& finding : c.findings) {
    text += fmt::format("* {}\n", finding_line(finding));
    if (!finding.input.empty()) text += fmt::format("  `{}`\n", finding.input);
  }
  if (c.skipped > 0) text += fmt::format("\n{} inputs were not asked, because it hung or died too often.\n", c.skipped);
  if (c.promise) {
    text += fmt::format("\n## Its own promise\n\n{} error at most {:g}: {}.\n", name_of(c.promise->measure),
                        c.promise->bound, c.promise->is_kept ? "kept" : "BROKEN");
    for (const std::string& broken : c.promise->broken) text += fmt::format("* {}\n", broken);
  }
  for (const SubjectCampaign& campaign : c.formulas) {
    if (campaign.has_sides) {
      text += side_page(campaign);
      continue;
    }
    text += fmt::format("\n## {}\n\nTime for a pair of an element and a point: {}.\n\n", campaign.subject,
                        times_text(campaign));
    std::string rule;
    for (const std::string& heading : headings()) {
      text += "| " + heading + " ";
      rule += "|---";
    }
    text += "| worst input |\n" + rule + "|---|\n";
    for (const CampaignRow& row : campaign.rows) {
      for (const std::string& cell : cells(row)) text += "| " + cell + " ";
      text += fmt::format("| `{}` |\n", row.conditioned.input);
    }
  }
  text +=
      "\nRelative: the difference from the truth over the truth, norm-wise. Conditioned: in units of what rounding the "
      "input "
      "costs; a stable implementation has a few.\n";
  return text;
}

}  // namespace cageproof::judge
