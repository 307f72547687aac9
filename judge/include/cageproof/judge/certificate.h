// SPDX-License-Identifier: MIT
// The certificate of foreign code: all findings, as one page and as one JSON file.
#pragma once

#include "cageproof/judge/element_campaign.h"
#include "cageproof/judge/verdict.h"
#include "cageproof/judge/whole_cage.h"

#include <optional>
#include <string>
#include <vector>

namespace cageproof::judge {

/// Something to know of the code: a defect, or a remark.
struct CodeFinding {
  std::string kind;     ///< "crash", "not finite", "other numbers", "range" ...
  std::string text;     ///< one sentence
  std::string formula;  ///< empty where it is of all
  int order = 0;
  std::string input;        ///< a line of `eval` that shows it; empty where none does
  std::uint64_t count = 1;  ///< how often it was seen
  bool is_defect = true;
};

/// A promise of the code's own, and what became of it.
struct OwnPromise {
  enum class Measure { Relative, Absolute, Conditioned } measure = Measure::Relative;
  double bound = 0;  ///< of the error; of a conditioned one relative to its denominator, not in units of u
  bool is_kept = true;
  std::vector<std::string> broken;  ///< "FORMULA, REGIME, order N: ERROR at INPUT"
};

/// "relative", "absolute", "conditioned".
std::string_view name_of(OwnPromise::Measure measure);

struct Certificate {
  std::string name, what, about;
  std::vector<JudgedFile> files;
  std::string version, commit, started, command_line, scalar;  ///< of this program and its run
  int samples = 0;
  std::uint64_t seed = 0;
  std::vector<SubjectCampaign> formulas;
  std::vector<CodeFinding> findings;
  std::uint64_t skipped = 0;  ///< inputs that were not asked
  std::optional<OwnPromise> promise;

  bool has_defects() const;
  /// Whether some row measured nothing, or inputs were skipped or declined, so that nothing can be said of them.
  bool is_undecided() const;
};

/// The findings that follow from errors and incidents, without the search for named defects.
std::vector<CodeFinding> findings_of(const std::vector<SubjectCampaign>& campaigns,
                                     const std::vector<Incident>& incidents);
/// A formula's convention and defects by name, with advice and the page of docs/ that derives the right form.
/// \param formula what the code was asked for
std::vector<CodeFinding> named_findings(const Verdict& verdict, const Formula& formula);
/// Defects of coordinates of whole cages by name, with advice. \param kind that the code was asked for
std::vector<CodeFinding> named_findings(const CageVerdict& verdict, std::string_view kind);
/// Findings from errors, reduced by those that named defects explain. Where a defect has a name, errors are what it
/// does; where none has, lost digits are a remark, because sound forms lose them, too. \param has_named whether a
/// defect was named
std::vector<CodeFinding> beside_named(std::vector<CodeFinding> found, bool has_named);
/// Whether the campaigns keep a promise. \param single whether they were in float
OwnPromise judged_promise(OwnPromise promise, const std::vector<SubjectCampaign>& campaigns, bool single);

/// The certificate as JSON, "schema": "cageproof-certificate", version 1. Infinite numbers are the string "inf".
std::string json_of(const Certificate& certificate);
/// The same as a page of Markdown.
std::string markdown_of(const Certificate& certificate);
/// The table of a formula, as it is printed. \param width of the longest line of input, 0: inputs are left out
std::string table_of(const SubjectCampaign& campaign, bool with_inputs);
/// Correct decimal digits of a relative error: 0 to 17.
double digits_of(double relative_error);

}  // namespace cageproof::judge
