// SPDX-License-Identifier: MIT
// A made-up run that looks like a real one, for the tests of what people see.
#pragma once

#include "cageproof/core/results/run_result.h"
#include "cageproof/reports/report_writer.h"

namespace cageproof::reports {

/// Rows and curves of `formulas` formulas in `regimes` regimes (at most 12), with broken promises, infinite errors,
/// notes and cages.
RunResult sample_run(int formulas, int regimes);

/// A slice of 2 x 1 x 1 cells of `n` x `n` points with a masked disc and an infinite sample.
ImageField sample_slice(const std::string& name, int n);

/// A sphere's vertices and quads, with a masked and an infinite vertex.
MeshField sample_mesh(const std::string& name, int n);

/// Bytes of every file below a folder, by relative path.
std::map<std::string, std::string> files_below(const std::filesystem::path& folder);

/// A fresh, empty folder, removed with its contents.
class ScratchFolder {
 public:
  ScratchFolder();
  ~ScratchFolder();
  const std::filesystem::path& path() const { return path_; }
  bool is_empty() const { return std::filesystem::is_empty(path_); }

 private:
  std::filesystem::path path_;
};

}  // namespace cageproof::reports
