// SPDX-License-Identifier: MIT
#include "cageproof/reports/run_folder.h"

#include "cageproof/core/input_error.h"
#include "aside.h"
#include "aside_notes.h"
#include "report_folder.h"
#include "written_files.h"

#include <fmt/format.h>

namespace cageproof::reports {

namespace fs = std::filesystem;

namespace {

// Who reads a verdict by its usual name must not take an earlier run's for that of the run that begins.
void set_summaries_aside(const fs::path& folder) {
  const auto lock = undisturbed();
  for (const std::string_view name : verdict_files) {
    std::error_code error;
    if (!fs::exists(folder / name, error)) continue;
    fs::rename(folder / name, folder / earlier_file(name), error);
    if (error) throw InputError(fmt::format("cannot write {}: {}", (folder / name).string(), error.message()));
  }
}

}  // namespace

fs::path begin_run(const fs::path& out, const JournalHeader& header, const Session& session) {
  const fs::path folder = replaceable_folder(out, header.shards > 1 ? shard_kind() : report_kind());
  fs::path journal = folder / journal_file;
  if (const auto earlier = find_journal_header(journal)) {
    // Shards differ by a digit in their names.
    if (header.shards > 1 && (earlier->shard != header.shard || earlier->shards != header.shards))
      throw InputError(fmt::format("cannot write {}: the folder holds shard {}/{}, which shard {}/{} does not replace",
                                   out.string(), earlier->shard, earlier->shards, header.shard, header.shards));
    const JournalWriter nobody_writes(journal);
  }
  set_summaries_aside(folder);
  begin_folder(folder, journal_file, journal_head(header, session));
  return journal;
}

fs::path journal_in(const fs::path& folder) {
  std::error_code ignored;
  const fs::path path = fs::weakly_canonical(fs::absolute(folder), ignored);
  remove_leftovers(path.has_filename() ? path : path.parent_path());
  fs::path journal = folder / journal_file;
  if (!fs::is_regular_file(journal, ignored))
    throw InputError(fmt::format("{}: there is no journal of a run in it", folder.string()));
  return journal;
}

}  // namespace cageproof::reports
