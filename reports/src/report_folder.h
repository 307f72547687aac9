// SPDX-License-Identifier: MIT
// The folder a report is written in, and its move into place.
#pragma once

#include <filesystem>
#include <string_view>
#include <vector>

namespace cageproof::reports {

/// What a folder holds, by which one of ours is known again: only such a one, or an empty one, is replaced.
struct FolderKind {
  std::string_view what;                  ///< "report": for messages
  std::vector<std::string_view> parts;    ///< every entry it may hold
  std::vector<std::string_view> folders;  ///< of these, the folders
  std::string_view summary;               ///< the JSON file that says what it is ...
  std::string_view schema;                ///< ... in its member "schema"
};

/// summary.json, summary.md, results.csv, worst.jsonl, index.html, fields/, pictures/.
const FolderKind& report_kind();

/// A folder beside the final one; renamed onto it by commit(), removed by the destructor otherwise.
class ReportFolder {
 public:
  /// \throws InputError as ReportWriter
  explicit ReportFolder(const std::filesystem::path& out, const FolderKind& kind = report_kind());
  ~ReportFolder();
  ReportFolder(const ReportFolder&) = delete;
  ReportFolder& operator=(const ReportFolder&) = delete;

  /// Where to write: has the kind's folders.
  const std::filesystem::path& path() const { return staging_; }
  /// \throws InputError when `out` has become something else than such a folder meanwhile, or cannot be replaced
  void commit();

 private:
  const FolderKind* kind_;
  std::filesystem::path out_, staging_;
  bool committed_ = false;
};

}  // namespace cageproof::reports
