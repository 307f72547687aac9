// SPDX-License-Identifier: MIT
#include "row_members.h"
#include "tables.h"

namespace cageproof::reports {

std::string results_csv(const RunResult& result) {
  std::vector<const RowMember*> columns;
  for (const RowMember& member : row_members())
    if (std::string_view(member.name) != "histogram") columns.push_back(&member);
  std::string csv;
  for (const RowMember* column : columns) csv.append(csv.empty() ? "" : ",").append(column->name);
  csv += '\n';
  for (const ResultRow& row : result.rows)
    for (const RowMember* column : columns)
      csv.append(member_field(row, *column)).append(column == columns.back() ? "\n" : ",");
  return csv;
}

}  // namespace cageproof::reports
