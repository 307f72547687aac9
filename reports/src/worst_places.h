// SPDX-License-Identifier: MIT
// Worst inputs of a run are stored in one file per formula, cage and deformed cage, with some lines for each row.
#pragma once

#include "cageproof/core/results/run_result.h"

#include <map>
#include <string>
#include <string_view>
#include <unordered_map>

namespace cageproof::reports {

/// The home of a row's cell and worst inputs: its formula, its cage, or the cage that is deformed.
struct RowHome {
  std::string_view folder;  ///< of the pages: "formulas", "cages", "deformers"
  std::string_view prefix;  ///< of files that all lie in one folder: "", "cage.", "deformer."
  std::string name;
};
RowHome home_of(const RowKey& row);

/// Lines of a file, from 1.
struct WorstPlace {
  std::string
      file;  ///< "worst/triangle.double_layer.jsonl.gz", "worst/cage.cube.jsonl.gz", "worst/deformer.cube.jsonl.gz"
  std::size_t first = 0;  ///< line
  std::size_t count = 0;  ///< one, the worst input, for a kept promise; all known inputs for a broken one
};

/// Places for the rows of a run, which must outlive this object.
class WorstPlaces {
 public:
  explicit WorstPlaces(const RunResult& result);
  /// The place of a row of the run.
  const WorstPlace& of(const ResultRow& row) const { return places_.at(&row); }

 private:
  std::unordered_map<const ResultRow*, WorstPlace> places_;
};

/// The files' texts by name, and worst.jsonl, which has only those of broken promises, and may be empty.
std::map<std::string, std::string> worst_files(const RunResult& result);

}  // namespace cageproof::reports
