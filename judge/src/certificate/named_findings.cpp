// SPDX-License-Identifier: MIT
// A verdict as findings of a certificate.
#include "cageproof/judge/certificate.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

namespace cageproof::judge {
namespace {

// A sample as a line of `eval`; empty where the defect has no single input.
std::string line_of(const validation::Sample& sample, const Formula& formula) {
  if (sample.corners.empty()) return "";
  Asked asked{.parameters = sample.parameters};
  for (const Vec3<double>& corner : sample.corners)
    asked.corners.insert(asked.corners.end(), corner.data(), corner.data() + formula.dim());
  asked.points.assign(sample.point.data(), sample.point.data() + formula.dim());
  return exact_line(formula, asked, 0);
}

// Long tensors say no more than their first entries.
std::string text_of(const std::vector<double>& tensor) {
  constexpr std::size_t most = 9;
  const auto shown = std::span(tensor).first(std::min(most, tensor.size()));
  return fmt::format("{:.12g}{}", fmt::join(shown, " "), tensor.size() > most ? " ..." : "");
}

std::string sentence(const Defect& defect, const std::string& evidence, const std::vector<double>& ours,
                     const std::vector<double>& theirs) {
  std::string text = fmt::format("{} Seen: {}", defect.sentence, evidence);
  if (!ours.empty()) text += fmt::format("; right is {}, yours {}", text_of(ours), text_of(theirs));
  const std::string own_page = fmt::format("defects.md#{}", defect.key);
  return text + fmt::format(". To do: {} (docs/{}{})", defect.advice, own_page,
                            defect.page == own_page ? "" : fmt::format(", docs/{}", defect.page));
}

}  // namespace

std::vector<CodeFinding> named_findings(const CageVerdict& verdict, std::string_view kind) {
  std::vector<CodeFinding> found;
  if (verdict.convention && !verdict.convention->is_ours())
    found.push_back({"convention", verdict.convention->sentence, std::string(kind), 0, "", 1, false});
  for (const CageFinding& finding : verdict.findings)
    found.push_back({std::string(finding.defect->key),
                     sentence(*finding.defect, finding.evidence, finding.ours, finding.theirs), std::string(kind), 0,
                     exact_line(Request{.kind = kind}, asked_of(finding.question), 0),
                     std::max<std::uint64_t>(1, finding.cases), true});
  return found;
}

std::vector<CodeFinding> named_findings(const Verdict& verdict, const Formula& formula) {
  std::vector<CodeFinding> found;
  const std::string name(formula.name);
  const bool has_other = verdict.convention && !verdict.convention->is_ours(formula.name);
  if (has_other || !verdict.convention)
    found.push_back({"convention", verdict.convention_sentence, name, 0, "", 1, false});
  const Formula& computed = verdict.convention ? formula_named(verdict.convention->formula) : formula;
  for (const FoundDefect& finding : verdict.findings) {
    const Defect& defect = *finding.defect;
    found.push_back({std::string(defect.key), sentence(defect, finding.evidence, finding.ours, finding.theirs), name,
                     finding.order, line_of(finding.input, computed), std::max<std::uint64_t>(1, finding.cases), true});
  }
  return found;
}

std::vector<CodeFinding> beside_named(std::vector<CodeFinding> found, bool has_named) {
  const auto is_of_errors = [](const CodeFinding& f) {
    return f.kind == "inaccurate" || f.kind == "other numbers" || f.kind == "not finite" || f.kind == "on the element";
  };
  if (has_named) std::erase_if(found, is_of_errors);
  else
    for (CodeFinding& finding : found)
      if (finding.kind == "inaccurate") finding.is_defect = false;
  return found;
}

}  // namespace cageproof::judge
