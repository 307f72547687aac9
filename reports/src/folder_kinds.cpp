// SPDX-License-Identifier: MIT
#include "cageproof/reports/journal.h"
#include "cageproof/reports/packed_file.h"
#include "cageproof/reports/summary.h"
#include "report_folder.h"

#include <nlohmann/json.hpp>

namespace cageproof::reports {
namespace {

namespace fs = std::filesystem;

bool states_schema(const fs::path& file, std::string_view schema) {
  std::error_code ignored;
  if (!fs::is_regular_file(file, ignored)) return false;
  const auto json = nlohmann::json::parse(read_packed(file), nullptr, false);
  return json.is_object() && json.contains("schema") && json["schema"] == schema;
}

// Or one of an earlier program, whose files were plain.
bool has_summary(const fs::path& folder, std::string_view schema) {
  return states_schema(folder / summary_file, schema) || states_schema(folder / "summary.json", schema);
}

// Whether it has a journal, of a shard or of a whole run.
bool has_journal(const fs::path& folder, bool shard) {
  const auto header = find_journal_header(folder / journal_file);
  return header && (header->shards > 1) == shard;
}

}  // namespace

const FolderKind& report_kind() {
  static const FolderKind kind{
      "a verification report",
      {journal_file,
       summary_file,
       "summary.md",
       "results.csv.gz",
       "summary.json",
       "results.csv",
       "worst.jsonl",
       "worst",
       "index.html",
       "pictures.html",
       "field.html",
       "formulas",
       "cages",
       "deformers",
       "fields",
       "pictures",
       "figures",
       "earlier.summary.json.gz",
       "earlier.summary.md",
       "earlier.summary.json"},
      {"fields", "pictures"},
      [](const fs::path& folder) { return has_journal(folder, false) || has_summary(folder, "cageproof-summary"); }};
  return kind;
}

const FolderKind& shard_kind() {
  static const FolderKind kind{
      "a shard of a run", {journal_file}, {}, [](const fs::path& folder) { return has_journal(folder, true); }};
  return kind;
}

const FolderKind& field_kind() {
  static const FolderKind kind{"an error field",
                               {summary_file, "summary.md", "results.csv.gz", "summary.json", "results.csv",
                                "worst.jsonl", "index.html", "pictures.html", "field.html", "fields", "pictures"},
                               {"fields", "pictures"},
                               [](const fs::path& folder) { return has_summary(folder, "cageproof-field"); }};
  return kind;
}

const FolderKind& work_precision_kind() {
  static const FolderKind kind{
      "a work-precision measurement",
      {"work_precision.csv", "work_precision.json", "pictures"},
      {"pictures"},
      [](const fs::path& folder) { return states_schema(folder / "work_precision.json", "cageproof-work-precision"); }};
  return kind;
}

const FolderKind& figures_kind() {
  static const FolderKind kind{"figures of the papers", {"figures"}, {"figures"}, [](const fs::path& folder) {
                                 return states_schema(folder / "figures/figures.json", "cageproof-figures");
                               }};
  return kind;
}

}  // namespace cageproof::reports
