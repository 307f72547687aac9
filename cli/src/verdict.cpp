// SPDX-License-Identifier: MIT
#include "commands.h"

#include <fmt/format.h>

namespace cageproof::cli {

ExitCode print_verdict(const RunResult& result, const std::string& out) {
  std::size_t kept = 0, broken = 0, unpromised = 0;
  for (const ResultRow& row : result.rows) {
    kept += row.verdict == Verdict::Kept;
    broken += row.verdict == Verdict::Broken;
    unpromised += row.verdict == Verdict::NotPromised;
  }
  for (const ResultRow& row : result.rows)
    if (row.verdict == Verdict::Broken)
      fmt::print("BROKEN {} {} {} {}{} {} order {}: {:.3g} {} > {:.3g}, {}\n", row.subject, row.evaluation, row.scalar,
                 row.regime, row.place.empty() ? "" : " " + row.place, row.check, row.order, row.max, row.unit,
                 *row.bound, row.reason);
  fmt::print("{}: {} promises kept, {} broken, {} rows not promised\n",
             broken == 0 ? "all promises kept" : "PROMISES BROKEN", kept, broken, unpromised);
  fmt::print("report: {}/index.html\n", out);
  if (broken != 0) fmt::print("worst inputs: cageproof replay {}/worst.jsonl\n", out);
  for (const std::string& note : result.session_notes) fmt::print(stderr, "cageproof: {}\n", note);
  return broken == 0 ? success : promise_broken;
}

}  // namespace cageproof::cli
