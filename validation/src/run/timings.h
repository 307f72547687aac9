// SPDX-License-Identifier: MIT
// The processor time of units of work.
#pragma once

#include <filesystem>
#include <fstream>
#include <mutex>
#include <string>
#include <vector>

namespace cageproof::validation {

/// The processor time of the calling thread, in seconds.
double thread_seconds();

/// Processor time of each unit of work, as a table. Safe from several threads.
class Timings {
 public:
  /// \param path of the table; empty: none is written
  /// \throws InputError when it cannot be written
  explicit Timings(std::filesystem::path path);
  void add(std::string measurement, int block, double seconds);
  /// One line per unit, the costliest first: seconds, measurement, block.
  /// \throws InputError when it cannot be written
  void write();

 private:
  struct UnitTime {
    std::string measurement;
    int block;
    double seconds;
  };
  void require(bool written) const;

  std::filesystem::path path_;
  std::ofstream file_;
  std::mutex mutex_;
  std::vector<UnitTime> units_;
};

}  // namespace cageproof::validation
