// SPDX-License-Identifier: MIT
// Two reports, or two outputs of Google Benchmark, judged with a tolerance: what got worse, better, or went missing.
#pragma once

#include "cageproof/reports/compare.h"

#include <string>
#include <string_view>
#include <vector>

namespace cageproof::reports {

/// One figure, verdict or time that differs.
struct Change {
  enum class Kind {
    Worse,      ///< by more than the tolerance: fails
    Gone,       ///< a promise or benchmark that only the old run has: fails, because nothing shows that it still holds
    Slight,     ///< worse within the tolerance, or a time whose difference is not significant
    Better,     ///< smaller, or a better verdict
    Added,      ///< only the new run has it
    Undecided,  ///< a time with too few repetitions for a test
  };
  Kind kind;
  std::string what;           ///< the row or benchmark
  std::string figure;         ///< "max", "verdict", "time in ns"; empty where the whole row is meant
  std::string before, after;  ///< as text
  double ratio = 0;           ///< new by old, after both are raised to the figure's floor; 0 where there is none
  double p = -1;              ///< of times: the probability of such ranks by chance; negative where there is none
};

std::string_view name_of(Change::Kind kind);

/// A figure of the new run that is kept over time: smaller is better.
struct TrackedFigure {
  std::string name, unit;
  double value = 0;
  double spread = 0;  ///< half the range of repetitions; 0 where there are none
};

/// The changes that a comparison found, and facts of the new run.
struct Changes {
  std::string old_name, new_name;
  double tolerance = 1;
  std::size_t compared = 0;  ///< rows or benchmarks that both runs have
  std::vector<Change> changes;
  std::vector<std::string> settings;     ///< as Differences has them; none of benchmarks
  std::vector<TrackedFigure> figures;    ///< of the new run
  std::string date, commit;              ///< of the new run; empty where it does not say
  std::size_t promises = 0, broken = 0;  ///< of the new run; none in benchmarks
  bool benchmarks = false;
  std::size_t count(Change::Kind kind) const;
  bool fails() const { return count(Change::Kind::Worse) + count(Change::Kind::Gone) > 0; }
};

/// Rows of two texts of summary.json, matched as compare_summaries does. Worse are a verdict nearer to BROKEN; max,
/// p999, median, max_relative, bound, and the shares of samples that are nonfinite, without truth, unreached or
/// declined, when they grew by more than `tolerance`. An error below one rounding counts as one rounding.
/// \param tolerance at least 1 \throws InputError as compare_summaries
Changes changes_of_summaries(std::string_view old_text, std::string_view new_text, const Renamed& renamed,
                             double tolerance, std::string_view old_name, std::string_view new_name);

/// Whether a text is output of Google Benchmark with --benchmark_format=json.
bool is_benchmark_output(std::string_view text);

/// Medians of repetitions of two outputs of Google Benchmark. Worse is a median that grew by more than `tolerance`
/// where ranks differ significantly: two-sided Mann-Whitney U, p below 0.01, which takes five repetitions of each.
/// \throws InputError for text that is no such output
Changes changes_of_benchmarks(std::string_view old_text, std::string_view new_text, double tolerance,
                              std::string_view old_name, std::string_view new_name);

}  // namespace cageproof::reports
