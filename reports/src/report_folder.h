// SPDX-License-Identifier: MIT
// The folder a report is written in, and its move into place.
#pragma once

#include <filesystem>

namespace cageproof::reports {

/// A folder beside the final one; renamed onto it by commit(), removed by the destructor otherwise.
class ReportFolder {
 public:
  /// \throws InputError as ReportWriter
  explicit ReportFolder(const std::filesystem::path& out);
  ~ReportFolder();
  ReportFolder(const ReportFolder&) = delete;
  ReportFolder& operator=(const ReportFolder&) = delete;

  /// Where to write: has the folders fields/ and pictures/.
  const std::filesystem::path& path() const { return staging_; }
  /// \throws InputError when `out` has become something else than a report meanwhile, or cannot be replaced
  void commit();

 private:
  std::filesystem::path out_, staging_;
  bool committed_ = false;
};

}  // namespace cageproof::reports
