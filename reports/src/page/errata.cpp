// SPDX-License-Identifier: MIT
#include "errata_text.h"
#include "figure.h"
#include "page_data.h"

namespace cageproof::reports {

void set_errata(Data& page, const RunResult& result) {
  Data measured{Data::type::list}, texts{Data::type::list};
  for (const ErratumRow& row : result.errata) {
    Data line;
    line.set("source", row.source);
    line.set("printed", row.printed);
    line.set("correct", row.correct);
    line.set("formula", row.formula);
    line.set("evaluation", row.evaluation);
    line.set("regime", row.regime);
    line.set("order", std::string(order_name(row.order)));
    line.set("samples", grouped(row.samples));
    line.set("printed_error", printed_error_text(row));
    line.set("corrected_error", short_error(row.corrected_error));
    (row.formula.empty() ? texts : measured) << line;
  }
  page.set("has_any_errata", !result.errata.empty());
  set_list(page, "errata", measured);
  set_list(page, "text_errata", texts);
}

}  // namespace cageproof::reports
