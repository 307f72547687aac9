// SPDX-License-Identifier: MIT
// Where the worst inputs of a run lie: a file a formula, cage and deformed cage, of which each row has some lines.
#pragma once

#include "cageproof/core/results/run_result.h"

#include <map>
#include <string>
#include <string_view>
#include <unordered_map>

namespace cageproof::reports {

/// What a row's cell and worst inputs are filed under: its formula, its cage, or the cage that is deformed.
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
  std::size_t count = 0;  ///< of a kept promise the worst input alone, of a broken one all that are known
};

/// Of a run, which must outlive it.
class WorstPlaces {
 public:
  explicit WorstPlaces(const RunResult& result);
  /// Of a row of the run.
  const WorstPlace& of(const ResultRow& row) const { return places_.at(&row); }

 private:
  std::unordered_map<const ResultRow*, WorstPlace> places_;
};

/// The files' texts by name; and worst.jsonl, which has those of broken promises alone, and may be empty.
std::map<std::string, std::string> worst_files(const RunResult& result);

}  // namespace cageproof::reports
