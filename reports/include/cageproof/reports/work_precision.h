// SPDX-License-Identifier: MIT
// Time and error side by side, as a person sees them.
#pragma once

#include "cageproof/core/results/work_precision.h"

#include <filesystem>
#include <memory>
#include <string>
#include <vector>

namespace cageproof::reports {

/// A header, then one line per row, in full precision; RFC 4180 quoting, lines end in a line feed.
std::string work_precision_csv(const WorkPrecision& result);

/// Schema "cageproof-work-precision", "schema_version" 1; infinite numbers are the string "inf".
std::string work_precision_json(const WorkPrecision& result);

/// Aligned columns, errors rounded up to two digits. Of a formula the worst result's correct digits come first, and
/// beside them conditioned units.
std::string work_precision_text(const WorkPrecision& result);

/// A folder with work_precision.csv, work_precision.json, pictures/error_nodes.png, pictures/error_time.png and for
/// each sweep pictures/error_<sweep>.png, written aside and renamed into place like a report.
class WorkPrecisionWriter {
 public:
  /// \throws InputError as ReportWriter, so that a long measurement does not end at a folder that cannot be written
  explicit WorkPrecisionWriter(const std::filesystem::path& out);
  /// Removes the unfinished folder unless write() came to its end.
  ~WorkPrecisionWriter();
  WorkPrecisionWriter(const WorkPrecisionWriter&) = delete;
  WorkPrecisionWriter& operator=(const WorkPrecisionWriter&) = delete;

  /// Writes all files and puts the folder in its place. \return them, by name from the folder on
  /// \throws InputError when a file cannot be written, or gnuplot is missing or fails
  std::vector<std::string> write(const WorkPrecision& result);

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace cageproof::reports
