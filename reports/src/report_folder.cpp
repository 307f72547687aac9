// SPDX-License-Identifier: MIT
#include "report_folder.h"

#include "cageproof/reports/checked_file.h"
#include "cageproof/core/input_error.h"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <fcntl.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstdio>
#include <string_view>
#include <system_error>

namespace cageproof::reports {
namespace {

namespace fs = std::filesystem;

[[noreturn]] void fail(const fs::path& path, const std::string& reason) {
  throw InputError(fmt::format("cannot write {}: {}", path.string(), reason));
}

bool is_of_kind(const fs::path& summary, const FolderKind& kind) {
  const auto json = nlohmann::json::parse(read_file(summary), nullptr, false);
  return json.is_object() && json.contains("schema") && json["schema"] == kind.schema;
}

// What is replaced must be ours to replace: a mistyped --out must never cost someone a folder.
void require_replaceable(const fs::path& out, const FolderKind& kind) {
  std::error_code error;
  const fs::file_status status = fs::status(out, error);
  if (status.type() == fs::file_type::not_found) return;
  if (error) fail(out, error.message());
  if (!fs::is_directory(status)) fail(out, "exists and is no folder");
  bool any = false;
  for (const fs::directory_entry& entry : fs::directory_iterator(out, error)) {
    any = true;
    const std::string name = entry.path().filename().string();
    if (std::ranges::find(kind.parts, name) == kind.parts.end())
      fail(out, fmt::format("the folder holds '{}', which is no part of a {}", name, kind.what));
  }
  if (error) fail(out, error.message());
  if (any && !(fs::is_regular_file(out / kind.summary, error) && is_of_kind(out / kind.summary, kind)))
    fail(out, fmt::format("the folder is not empty and holds no {}", kind.what));
}

// The folder itself, so that a link stays a link to the new report and "report/" names what "report" does.
fs::path resolved(const fs::path& out) {
  if (out.empty()) throw InputError("cannot write the report: its folder has an empty name");
  std::error_code error;
  fs::path path = fs::weakly_canonical(fs::absolute(out), error);
  if (error) fail(out, error.message());
  if (!path.has_filename()) path = path.parent_path();
  if (!path.has_filename()) fail(out, "it is the root of the file system");
  if (!fs::is_directory(path.parent_path(), error))
    fail(out, fmt::format("the folder {} does not exist", path.parent_path().string()));
  return path;
}

void make_folder(const fs::path& path) {
  std::error_code error;
  fs::create_directory(path, error);
  if (error) fail(path, error.message());
}

}  // namespace

const FolderKind& report_kind() {
  static const FolderKind kind{"report",
                               {"summary.json", "summary.md", "results.csv", "worst.jsonl", "index.html", "fields", "pictures"},
                               {"fields", "pictures"},
                               "summary.json",
                               "cageproof-summary"};
  return kind;
}

ReportFolder::ReportFolder(const fs::path& out, const FolderKind& kind) : kind_(&kind), out_(resolved(out)) {
  require_replaceable(out_, kind);
  std::error_code error;
  for (int n = 0; staging_.empty(); ++n) {
    const fs::path candidate =
        out_.parent_path() / fmt::format(".{}.partial-{}-{}", out_.filename().string(), ::getpid(), n);
    if (fs::create_directory(candidate, error)) staging_ = candidate;
    else if (error) fail(out_, error.message());
  }
  try {
    for (const std::string_view folder : kind.folders) make_folder(staging_ / folder);
  } catch (...) {
    fs::remove_all(staging_, error);
    throw;
  }
}

ReportFolder::~ReportFolder() {
  std::error_code ignored;
  if (!committed_) fs::remove_all(staging_, ignored);
}

void ReportFolder::commit() {
  require_replaceable(out_, *kind_);
  // Onto nothing or an empty folder a rename is enough; an earlier report is exchanged in one step.
  if (std::rename(staging_.c_str(), out_.c_str()) == 0) {
    committed_ = true;
    return;
  }
  if (errno != ENOTEMPTY && errno != EEXIST) fail(out_, std::generic_category().message(errno));
  std::error_code ignored;
  if (::renameat2(AT_FDCWD, staging_.c_str(), AT_FDCWD, out_.c_str(), RENAME_EXCHANGE) == 0) {
    committed_ = true;
    fs::remove_all(staging_, ignored);
    return;
  }
  // Some network file systems cannot exchange: step aside, and back when the second step fails.
  const fs::path aside = staging_.string() + ".earlier";
  if (std::rename(out_.c_str(), aside.c_str()) != 0) fail(out_, std::generic_category().message(errno));
  if (std::rename(staging_.c_str(), out_.c_str()) != 0) {
    const int reason = errno;
    std::rename(aside.c_str(), out_.c_str());
    fail(out_, std::generic_category().message(reason));
  }
  committed_ = true;
  fs::remove_all(aside, ignored);
}

}  // namespace cageproof::reports
