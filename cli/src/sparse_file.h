// SPDX-License-Identifier: MIT
// Writes compressed sparse rows of weights as an .npz that SciPy's load_npz reads.
#pragma once

#include "cageproof/deformation/sparse_weights.h"
#include "cageproof/reports/piecewise_file.h"

#include <nlohmann/json.hpp>

#include <filesystem>
#include <string>
#include <utility>
#include <vector>

namespace cageproof::cli {

/// Sums over rows: how many weights were kept, and how far a point is moved.
struct SparseTotals {
  std::size_t rows = 0, missing = 0;  ///< missing: rows that are not finite, whose one weight is NaN
  std::size_t kept = 0;               ///< weights
  double bound = 0, sum_change = 0;   ///< the largest (deformation::SparseRow)
  std::size_t worst = 0;              ///< the row of the largest bound
  std::size_t over = 0;               ///< rows whose bound is above the tolerance
  std::size_t bytes = 0;              ///< of the rows in the file, without its data of the cage
};

/// Rows as they come, and the file of them. What is kept of rows is held in memory until all are there, because a ZIP
/// file has one array after the other; no row is held whole.
class SparseFile {
 public:
  /// \throws InputError for a file that cannot be written
  SparseFile(const std::filesystem::path& file, deformation::SparseWeights weights);

  /// Rows of consecutive points, from any thread. \param part a number of the block, rising from 0 after each flush
  void put(std::size_t part, std::size_t first, std::span<const double> rows);
  /// Takes the rows that put() has left, in the order of parts. \throws InputError where memory does not hold them
  void flush();
  /// Makes room for so many parts between two flushes.
  void expect(std::size_t parts) { parts_.resize(parts); }

  const SparseTotals& totals() const { return totals_; }
  /// Writes `format`, `shape`, `data`, `indices` and `indptr`, then the others, and puts the file in its place.
  /// \param others by name and bytes \return the file's bytes \throws InputError where that cannot be done
  std::size_t finish(const std::vector<std::pair<std::string, std::string>>& others);

 private:
  // Arrays' bytes of a part, and how many weights its rows have.
  struct Part {
    std::string data, indices;
    std::vector<std::size_t> counts;
    SparseTotals totals;
  };
  void add(const deformation::SparseRow& row, std::size_t number, Part& part) const;

  std::string name_;
  deformation::SparseWeights weights_;
  reports::PiecewiseFile file_;
  std::vector<Part> parts_, done_;
  SparseTotals totals_;
};

}  // namespace cageproof::cli
