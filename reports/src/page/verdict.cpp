// SPDX-License-Identifier: MIT
// The head of a page: the verdict, and figures of the rows below it; and on what the verdict rests.
#include "figure.h"
#include "given_cage.h"
#include "page_data.h"

#include <algorithm>
#include <map>

namespace cageproof::reports {
namespace {

Data tile(std::uint64_t count, const std::string& what, const std::string& kind) {
  Data data;
  data.set("figure", grouped(count));
  data.set("what", what);
  data.set("kind", kind);
  return data;
}

// Points of formulas and regimes that a check measured, whatever the evaluations and orders it did so for.
std::uint64_t points_of(const RunResult& result, std::string_view check) {
  std::map<std::pair<std::string, std::string>, std::uint64_t> most;
  for (const ResultRow& row : result.rows)
    if (row.section == RowKey::Section::Element && row.check == check) {
      std::uint64_t& points = most[{row.subject, row.setting}];
      points = std::max(points, row.samples);
    }
  std::uint64_t sum = 0;
  for (const auto& [where, points] : most) sum += points;
  return sum;
}

}  // namespace

void set_tiles(Data& page, const Rows& rows) {
  std::uint64_t kept = 0, broken = 0, ill = 0, open = 0, samples = 0;
  for (const ResultRow* row : rows) {
    samples += row->samples;
    if (row->verdict == Verdict::Kept) ++kept;
    else if (row->verdict == Verdict::Broken) ++broken;
    else if (row->is_ill_posed()) ++ill;
    else ++open;
  }
  Data tiles{Data::type::list};
  tiles << tile(kept, kept == 1 ? "promise kept" : "promises kept", "kept");
  tiles << tile(broken, broken == 1 ? "promise broken" : "promises broken", broken ? "broken" : "");
  tiles << tile(open, "results without a promise, shown for comparison", "");
  if (ill > 0)
    tiles << tile(ill, "results that cannot be judged: the input is ill-conditioned there, and no bound says anything",
                  "");
  tiles << tile(samples, "errors measured; a result is the largest of those of one check", "");
  page.set("tiles", tiles);
  page.set("verdict_class", broken ? "broken" : kept ? "kept" : "neutral");
  page.set("verdict_mark", broken ? "✗" : kept ? "✓" : "–");
}

void set_verdict(Data& page, const RunResult& result) {
  Rows rows;
  for (const ResultRow& row : result.rows) rows.push_back(&row);
  set_tiles(page, rows);
  page.set("verdict", is_of_given_cage(result) ? given_cage_verdict(result) : verdict_line(result));
}

void set_proof(Data& page, const RunResult& result) {
  const std::uint64_t integrated = points_of(result, "integral"), enclosed = points_of(result, "enclosure"),
                      compared = points_of(result, "truth");
  page.set("has_proof", compared > 0);
  page.set("integrated", grouped(integrated));
  page.set("enclosed", grouped(enclosed));
  page.set("any_enclosed", enclosed > 0);
  page.set("compared", grouped(compared));
}

}  // namespace cageproof::reports
