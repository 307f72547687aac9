// SPDX-License-Identifier: MIT
// The folders that the program writes: what each kind may hold, how one is begun, and how it is replaced as a whole.
#pragma once

#include "aside_notes.h"

#include <filesystem>
#include <memory>
#include <string_view>
#include <vector>

namespace cageproof::reports {

/// Contents of a kind of folder, by which one of ours is known again. Only an empty folder is replaced, or one of the
/// same kind that holds only files that were written into it (written_files.h).
struct FolderKind {
  std::string_view what;                        ///< "a verification report": for messages
  std::vector<std::string_view> parts;          ///< every entry it may hold
  std::vector<std::string_view> folders;        ///< of these, the folders
  bool (*holds)(const std::filesystem::path&);  ///< whether the folder says that it is of this kind
};

/// journal, summary.json.gz, summary.md, results.csv.gz, worst.jsonl, index.html, fields/, pictures/, figures/; or only
/// the journal.
const FolderKind& report_kind();

/// The journal of one shard.
const FolderKind& shard_kind();

/// What `field` writes: as a report, without a journal.
const FolderKind& field_kind();

/// work_precision.csv, work_precision.json, pictures/.
const FolderKind& work_precision_kind();

/// The folder that `figures` writes holds only figures/.
const FolderKind& figures_kind();

/// The folder itself: a link stays a link to what it will hold, and "report/" names what "report" does. Removes what
/// killed processes left next to it. \throws InputError when it is the root, its parent does not exist or cannot be
/// written, or it holds anything but one of that kind
std::filesystem::path replaceable_folder(const std::filesystem::path& out, const FolderKind& kind);

/// Puts a first file into the folder, which is made unless it is there, in one step: nobody ever sees the folder
/// without the whole file. Other files of an earlier one stay. \param out of replaceable_folder \throws InputError when
/// it cannot be written
void begin_folder(const std::filesystem::path& out, std::string_view file, std::string_view bytes);

/// A folder next to the final one; renamed onto it by commit(), removed by the destructor otherwise.
class ReportFolder {
 public:
  /// \throws InputError as replaceable_folder
  explicit ReportFolder(const std::filesystem::path& out, const FolderKind& kind);
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
  std::unique_ptr<AsideNote> note_;
  bool committed_ = false;
};

}  // namespace cageproof::reports
