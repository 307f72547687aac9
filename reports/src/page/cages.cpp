// SPDX-License-Identifier: MIT
#include "figure.h"
#include "page_data.h"
#include "run_names.h"

namespace cageproof::reports {
namespace {

// One line per cage: how many promises, and which row comes nearest to its bound.
Data lines_of(const RunResult& result, RowKey::Section section) {
  Data list{Data::type::list};
  const ShownNames names = names_of_run(result);
  Rows of_section;
  for (const ResultRow& row : result.rows)
    if (row.section == section) of_section.push_back(&row);
  for (const std::string& cage :
       distinct(of_section, [](const ResultRow* row) -> const std::string& { return row->setting; })) {
    std::uint64_t kept = 0, broken = 0, open = 0;
    const ResultRow* tightest = nullptr;
    for (const ResultRow* row : of_section) {
      if (row->setting != cage) continue;
      ++(row->verdict == Verdict::Kept ? kept : row->verdict == Verdict::Broken ? broken : open);
      if (row->bound && (!tightest || more_telling(*row, *tightest))) tightest = row;
    }
    Data data;
    data.set("cage", names.of(cage));
    data.set("page", page_of({section, "", "", "", cage, "", "", 0}));
    data.set("kept", grouped(kept));
    data.set("broken", grouped(broken));
    data.set("any_broken", broken > 0);
    data.set("open", grouped(open));
    data.set("cell", error_cell(tightest, "index.html"));
    data.set("bound", tightest ? short_number(*tightest->bound) : "");
    data.set("unit", tightest ? unit_text(tightest->unit) : "");
    data.set("check", tightest ? tightest->check : "");
    data.set("subject", tightest ? tightest->subject : "");
    data.set("evaluation", tightest ? tightest->evaluation : "");
    list << data;
  }
  return list;
}

}  // namespace

void set_cages(Data& page, const RunResult& result) {
  set_list(page, "cages", lines_of(result, RowKey::Section::Cage));
  set_list(page, "deformers", lines_of(result, RowKey::Section::Deformer));
}

}  // namespace cageproof::reports
