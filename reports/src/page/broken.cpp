// SPDX-License-Identifier: MIT
#include "cageproof/reports/broken_groups.h"
#include "figure.h"
#include "page_data.h"
#include "run_names.h"

#include <algorithm>

namespace cageproof::reports {
namespace {

// More would be read by nobody, and results.csv.gz has them all.
constexpr std::size_t kMostRows = 60;
// Rows that are visible without unfolding anything.
constexpr std::size_t kFirstRows = 12;

Data line_of(const ResultRow& row, const ShownNames& names) {
  Data data;
  data.set("subject", row.subject);
  data.set("evaluation", row.evaluation);
  data.set("scalar", row.scalar);
  data.set("where", names.of(row.setting) + (row.place.empty() ? "" : ", " + row.place));
  data.set("check", row.check);
  data.set("order", std::string(order_name(row.order)));
  // A figure within its bound is not the reason why the row is broken.
  const bool above = row.bound && row.samples > 0 && !(row.max <= *row.bound);
  data.set("max", above ? short_error(row.max) : "samples lost");
  data.set("bound", row.bound ? short_number(*row.bound) : "");
  data.set("unit", unit_text(row.unit));
  data.set("reason", row.reason);
  data.set("href", page_of(row) + "#" + cell_id(row));
  data.set("input", row.worst.empty() ? "" : input_line(row.worst.front()));
  return data;
}

}  // namespace

void set_broken(Data& page, const RunResult& result) {
  const Rows rows = broken_rows(result);
  const ShownNames names = names_of_run(result);
  Data first{Data::type::list}, other{Data::type::list};
  for (std::size_t i = 0; i < std::min(rows.size(), kMostRows); ++i)
    (i < kFirstRows ? first : other) << line_of(*rows[i], names);
  page.set("has_broken", !rows.empty());
  set_list(page, "first_broken", first);
  set_list(page, "other_broken", other);
  page.set("other_broken_count", grouped(std::min(rows.size(), kMostRows) - std::min(rows.size(), kFirstRows)));
  page.set("has_more_broken", rows.size() > kMostRows);
  page.set("more_broken", grouped(rows.size() > kMostRows ? rows.size() - kMostRows : 0));
}

}  // namespace cageproof::reports
