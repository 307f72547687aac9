// SPDX-License-Identifier: MIT
#include "report_folder.h"

#include "aside.h"
#include "aside_notes.h"
#include "written_files.h"

#include "cageproof/core/input_error.h"
#include "cageproof/reports/checked_file.h"

#include <fmt/format.h>

#include <fcntl.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstdio>
#include <system_error>

namespace cageproof::reports {
namespace {

namespace fs = std::filesystem;

[[noreturn]] void fail_folder(const fs::path& path, const std::string& reason) {
  throw InputError(fmt::format("cannot write {}: {}", path.string(), reason));
}

[[noreturn]] void fail_by_errno(const fs::path& path) { fail_folder(path, std::generic_category().message(errno)); }

// Only our own folders are replaced: a mistyped --out must never cost someone a folder.
void require_replaceable(const fs::path& out, const FolderKind& kind) {
  std::error_code error;
  const fs::file_status status = fs::status(out, error);
  if (status.type() == fs::file_type::not_found && fs::is_symlink(out, error))
    fail_folder(out, fmt::format("is a link to {}, which does not exist", fs::read_symlink(out, error).string()));
  if (status.type() == fs::file_type::not_found) return;
  if (error) fail_folder(out, error.message());
  if (!fs::is_directory(status)) fail_folder(out, "exists and is no folder");
  const bool empty = fs::is_empty(out, error);
  if (error) fail_folder(out, error.message());
  if (empty) return;
  const bool ours = kind.holds(out);
  for (const FolderKind* other :
       {&report_kind(), &shard_kind(), &field_kind(), &work_precision_kind(), &figures_kind()})
    if (!ours && other->holds(out))
      fail_folder(out, fmt::format("the folder holds {}, which {} does not replace", other->what, kind.what));
  for (const fs::directory_entry& entry : fs::directory_iterator(out, error)) {
    const std::string name = entry.path().filename().string();
    if (name != written_files_name && std::ranges::find(kind.parts, name) == kind.parts.end())
      fail_folder(out, fmt::format("the folder holds '{}', which is no part of {}", name, kind.what));
  }
  if (error) fail_folder(out, error.message());
  if (!ours) fail_folder(out, fmt::format("the folder is not empty and does not hold {}", kind.what));
  if (const std::string foreign = foreign_entry(out); !foreign.empty())
    fail_folder(out, fmt::format("the folder holds '{}', which cageproof did not write; move it away", foreign));
}

fs::path resolved(const fs::path& out) {
  if (out.empty()) throw InputError("cannot write the report: its folder has an empty name");
  std::error_code error;
  fs::path path = fs::weakly_canonical(fs::absolute(out), error);
  if (error) fail_folder(out, error.message());
  if (!path.has_filename()) path = path.parent_path();
  if (!path.has_filename()) fail_folder(out, "it is the root of the file system");
  if (!fs::is_directory(path.parent_path(), error))
    fail_folder(out, fmt::format("the folder {} does not exist", path.parent_path().string()));
  return path;
}

void make_folder(const fs::path& path) {
  std::error_code error;
  fs::create_directory(path, error);
  if (error) fail_folder(path, error.message());
}

// A fresh folder next to `out`.
fs::path staging_for(const fs::path& out) {
  std::error_code error;
  for (int n = 0;; ++n) {
    fs::path candidate = aside(out, n);
    if (fs::create_directory(candidate, error)) return candidate;
    if (error) fail_folder(out, error.message());
  }
}

}  // namespace

fs::path replaceable_folder(const fs::path& out, const FolderKind& kind) {
  fs::path path = resolved(out);
  remove_leftovers(path);
  require_replaceable(path, kind);
  return path;
}

void begin_folder(const fs::path& out, std::string_view file, std::string_view bytes) {
  const auto lock = undisturbed();
  const fs::path staging = staging_for(out);
  std::error_code ignored;
  try {
    write_file(staging / file, bytes);
    // Onto nothing, or an empty folder, the folder itself; into an earlier one, the file.
    if (std::rename(staging.c_str(), out.c_str()) == 0) return;
    if (errno != ENOTEMPTY && errno != EEXIST) fail_by_errno(out);
    if (std::rename((staging / file).c_str(), (out / file).c_str()) != 0) fail_by_errno(out / file);
  } catch (...) {
    fs::remove_all(staging, ignored);
    throw;
  }
  fs::remove_all(staging, ignored);
}

ReportFolder::ReportFolder(const fs::path& out, const FolderKind& kind)
    : kind_(&kind), out_(replaceable_folder(out, kind)) {
  {
    // A signal that comes between the folder and its note would leave it.
    const auto lock = undisturbed();
    staging_ = staging_for(out_);
    note_ = std::make_unique<AsideNote>(staging_);
  }
  try {
    for (const std::string_view folder : kind.folders) make_folder(staging_ / folder);
  } catch (...) {
    std::error_code ignored;
    fs::remove_all(staging_, ignored);
    throw;
  }
}

ReportFolder::~ReportFolder() {
  const auto lock = undisturbed();
  std::error_code ignored;
  if (!committed_) fs::remove_all(staging_, ignored);
}

void ReportFolder::commit() {
  write_file(staging_ / written_files_name, list_of_files(staging_));
  require_replaceable(out_, *kind_);
  const auto lock = undisturbed();
  // Onto nothing or an empty folder a rename is enough; an earlier report is exchanged in one step.
  if (std::rename(staging_.c_str(), out_.c_str()) == 0) {
    committed_ = true;
    return;
  }
  if (errno != ENOTEMPTY && errno != EEXIST) fail_by_errno(out_);
  std::error_code ignored;
  if (::renameat2(AT_FDCWD, staging_.c_str(), AT_FDCWD, out_.c_str(), RENAME_EXCHANGE) == 0) {
    committed_ = true;
    fs::remove_all(staging_, ignored);
    return;
  }
  // Some network file systems cannot exchange: step aside, and back when the second step fails.
  const fs::path old = earlier(staging_);
  if (std::rename(out_.c_str(), old.c_str()) != 0) fail_by_errno(out_);
  if (std::rename(staging_.c_str(), out_.c_str()) != 0) {
    const int reason = errno;
    std::rename(old.c_str(), out_.c_str());
    fail_folder(out_, std::generic_category().message(reason));
  }
  committed_ = true;
  fs::remove_all(old, ignored);
}

}  // namespace cageproof::reports
