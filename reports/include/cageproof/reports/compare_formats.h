// SPDX-License-Identifier: MIT
// A comparison, written for people and for the programs that watch figures over time.
#pragma once

#include "cageproof/reports/compare_changes.h"

#include <string>

namespace cageproof::reports {

/// A line per change, the worst first, then counts and the verdict.
std::string changes_text(const Changes& changes);
/// The same as tables for a pull request's comment: what fails is open, the rest folded. Long lists are cut at 50 rows,
/// and say so.
std::string changes_markdown(const Changes& changes);
/// The same as JSON.
std::string changes_json(const Changes& changes);
/// JUnit's XML: a test case per compared row or benchmark that changed, and one for all that did not.
std::string changes_junit(const Changes& changes);

/// Figures of the new run as github-action-benchmark reads them (tool customSmallerIsBetter).
std::string smaller_is_better_json(const Changes& changes);
/// Figures of the new run in Bencher's metric format (BMF): "latency" in ns, "conditioned-error", "promises-broken".
std::string bencher_json(const Changes& changes);
/// One line of JSON: date, commit and figures of the new run. \param commit goes before what the run says, if not empty
std::string history_line(const Changes& changes, const std::string& commit);

/// A badge's text about the new run, as shields.io's endpoint: promises kept or broken, or how many benchmarks got
/// slower. As the endpoint of shields.io reads it.
std::string badge_json(const Changes& changes);
/// The same badge as a picture (SVG).
std::string badge_svg(const Changes& changes);

}  // namespace cageproof::reports
