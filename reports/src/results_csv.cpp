// SPDX-License-Identifier: MIT
#include "csv_field.h"
#include "tables.h"

#include <fmt/format.h>

namespace cageproof::reports {
std::string results_csv(const RunResult& result) {
  std::string csv =
      "section,subject,evaluation,scalar,regime,check,place,order,unit,samples,nonfinite,without_truth,declined,"
      "max,p999,median,max_relative,bound,verdict,reason\n";
  for (const ResultRow& row : result.rows)
    csv += fmt::format("{},{},{},{},{},{},{},{},{},{},{},{},{},{},{},{},{},{},{},{}\n", cageproof::name_of(row.section),
                       csv_field(row.subject), csv_field(row.evaluation), csv_field(row.scalar), csv_field(row.regime),
                       csv_field(row.check), csv_field(row.place), row.order, csv_field(row.unit), row.samples,
                       row.nonfinite, row.without_truth, row.declined, row.max, row.p999, row.median, row.max_relative,
                       row.bound ? fmt::format("{}", *row.bound) : "", cageproof::name_of(row.verdict),
                       csv_field(row.reason));
  return csv;
}

}  // namespace cageproof::reports
