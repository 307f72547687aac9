// SPDX-License-Identifier: MIT
// The one table of a row's members. Whatever writes or reads rows walks it: summary.json, results.csv, the pages, the
// comparison of reports, and the journal, whose tallies have some of them.
#pragma once

#include "cageproof/core/results/run_result.h"
#include "json_value.h"

#include <variant>
#include <vector>

namespace cageproof::reports {

/// One member of a row.
struct RowMember {
  enum class Kind {
    Key,     ///< tells rows apart
    Figure,  ///< a finding or a promise: two reports are compared by it
    Count,   ///< of samples; a figure that is mostly zero
    Text,    ///< explains figures, and is not compared
  };
  const char* name;
  Kind kind;
  /// Members of RowFigures are those of a tally, too.
  std::variant<RowKey::Section RowKey::*, std::string RowKey::*, int RowKey::*, std::string RowFigures::*,
               std::uint64_t RowFigures::*, double RowFigures::*, std::uint64_t ResultRow::*, double ResultRow::*,
               std::optional<double> ResultRow::*, std::string ResultRow::*, Verdict ResultRow::*,
               std::vector<std::uint64_t> ResultRow::*>
      pointer;
};

/// In the order in which files have them.
const std::vector<RowMember>& row_members();

/// A member as summary.json has it; null where it is not known. A histogram is an object of the number of its first bin
/// that is not empty and the counts from there to the last.
Json member_json(const ResultRow& row, const RowMember& member);

/// A member as a field of results.csv: text quoted where it must be; empty where it is not known, and for histograms.
std::string member_field(const ResultRow& row, const RowMember& member);

/// A key as the journal has it: a list of its members.
Json key_json(const RowKey& key);
/// \throws std::invalid_argument, or nlohmann's exceptions, for anything else
RowKey key_of(const Json& json);

/// Adds to `json` what a tally shares with its row and is not as in an empty one.
void add_figures(Json& json, const RowFigures& figures);
/// The inverse. \throws as key_of
RowFigures figures_of(const Json& json);

}  // namespace cageproof::reports
