// SPDX-License-Identifier: MIT
#include "figure.h"
#include "page_data.h"

namespace cageproof::reports {

namespace {

// Cage by cage a table's lines, and below them all rows. \param list of cages in the page's data
void set_table(Data& page, const RunResult& result, const CageTable& table, ResultRow::Section section,
               const std::string& list) {
  Data heads{Data::type::list}, cages{Data::type::list};
  for (const std::string& column : table.columns) heads << Data(column);
  for (std::size_t i = 0; i < table.lines.size();) {
    const std::string& name = table.lines[i].cage;
    Data cage, lines{Data::type::list}, details{Data::type::list};
    cage.set("name", name);
    cage.set("anchor", anchor(name_of(section), name));
    std::size_t broken = 0;
    for (; i < table.lines.size() && table.lines[i].cage == name; ++i) {
      Data line, cells{Data::type::list};
      line.set("name", table.lines[i].name);
      line.set("unit", table.lines[i].unit);
      for (const ResultRow* row : table.lines[i].cells) cells << error_cell(row);
      line.set("cells", cells);
      lines << line;
    }
    for (const ResultRow& row : result.rows) {
      if (row.section != section || row.regime != name) continue;
      Data line;
      line.set("subject", row.subject);
      line.set("evaluation", row.evaluation.empty() ? row.scalar : row.evaluation + ", " + row.scalar);
      line.set("check", row.check);
      line.set("place", row.place);
      line.set("order", std::string(order_name(row.order)));
      line.set("unit", row.unit);
      line.set("samples", grouped(row.samples));
      line.set("cell", error_cell(&row));
      line.set("p999", short_error(row.p999));
      line.set("median", short_error(row.median));
      line.set("bound", row.bound ? short_number(*row.bound) : "");
      line.set("verdict", std::string(name_of(row.verdict)));
      line.set("reason", row.reason);
      details << line;
      broken += row.verdict == Verdict::Broken;
    }
    cage.set("lines", lines);
    cage.set("details", details);
    cage.set("any_broken", broken > 0);
    cage.set("broken_count", grouped(broken));
    cages << cage;
  }
  page.set(list + "_heads", heads);
  set_list(page, list, cages);
}

}  // namespace

void set_cages(Data& page, const RunResult& result) {
  set_table(page, result, cage_table(result), ResultRow::Section::Cage, "cages");
  set_table(page, result, deformer_table(result), ResultRow::Section::Deformer, "deformers");
}

}  // namespace cageproof::reports
