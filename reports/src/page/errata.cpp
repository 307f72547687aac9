// SPDX-License-Identifier: MIT
#include "errata_text.h"
#include "figure.h"
#include "page_data.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>

namespace cageproof::reports {
namespace {

struct Paper {
  const char *key, *title;
};

// As CITATION.cff has them.
constexpr std::array kPapers{
    Paper{"T24", "Thiery, Michel, Chen, Biharmonic Coordinates and their Derivatives for Triangular 3D Cages, 2024"},
    Paper{"W12", "Weber, Poranne, Gotsman, Biharmonic Coordinates, 2012"},
    Paper{"C23",
          "Chen, de Goes, Desbrun, Somigliana Coordinates: an elasticity-derived approach for cage deformation, "
          "2023"},
    Paper{"T18", "Thiery, Memari, Boubekeur, Mean Value Coordinates for Quad Cages in 3D, 2018"}};

// The papers whose errata are shown.
Data papers_of(const RunResult& result) {
  Data papers{Data::type::list};
  for (const Paper& paper : kPapers) {
    const std::string key = fmt::format("[{}]", paper.key);
    if (std::ranges::none_of(result.errata,
                             [&](const ErratumRow& row) { return row.source.find(key) != row.source.npos; }))
      continue;
    Data data;
    data.set("first", !papers.is_non_empty_list());
    data.set("key", paper.key);
    data.set("title", paper.title);
    papers << data;
  }
  return papers;
}

}  // namespace

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
  set_list(page, "papers", papers_of(result));
  page.set("has_any_errata", !result.errata.empty());
  set_list(page, "errata", measured);
  set_list(page, "text_errata", texts);
}

}  // namespace cageproof::reports
