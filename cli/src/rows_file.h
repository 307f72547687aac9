// SPDX-License-Identifier: MIT
// Tables that are written by blocks of rows, and never held as a whole.
#pragma once

#include "coordinate_table.h"

#include "cageproof/reports/piecewise_file.h"

#include <filesystem>
#include <optional>

namespace cageproof::cli {

/// Whether a file of that name can be written by blocks of rows: .npy, .csv, or standard output, which has no name.
bool is_written_by_rows(const std::filesystem::path& file);

/// A table that is being written: numbers of .npy where they belong, lines of CSV in their order.
class RowsFile {
 public:
  /// Writes the header. \param file .npy, .csv, or empty for CSV on standard output \param table its columns
  /// \throws InputError for a file that cannot be written, or whose disk has less room than .npy takes
  RowsFile(const std::filesystem::path& file, const CoordinateColumns& table, std::size_t points);

  /// Rows of consecutive points, from any thread. \param part a number of the block, rising from 0 after each flush
  void put(std::size_t part, std::size_t first, std::span<const double> rows);
  /// Writes the rows that put() has left, in the order of parts. \throws InputError where it cannot be written
  void flush();
  /// Puts the file in its place, with others. \throws InputError where that cannot be done: then no file is replaced
  void finish(const std::vector<std::pair<std::filesystem::path, std::string>>& others);

  /// Makes room for so many parts between two flushes.
  void expect(std::size_t parts) { texts_.resize(parts); }

 private:
  void write(std::string_view bytes);

  std::filesystem::path name_;
  bool is_npy_;
  std::size_t columns_, begin_ = 0;  // begin_: of numbers
  std::optional<reports::PiecewiseFile> file_;
  std::vector<std::string> texts_;  // a part each, of what is written in order
};

}  // namespace cageproof::cli
