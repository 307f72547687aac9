// SPDX-License-Identifier: MIT
#include "cageproof/reports/run_folder.h"

#include "cageproof/core/input_error.h"
#include "aside.h"
#include "report_folder.h"

#include <fmt/format.h>

namespace cageproof::reports {

namespace fs = std::filesystem;

fs::path begin_run(const fs::path& out, const JournalHeader& header, const Session& session) {
  const fs::path folder = replaceable_folder(out, header.shards > 1 ? shard_kind() : report_kind());
  const fs::path journal = folder / journal_file;
  if (const auto earlier = find_journal_header(journal)) {
    // Shards differ by a digit in their names.
    if (header.shards > 1 && (earlier->shard != header.shard || earlier->shards != header.shards))
      throw InputError(fmt::format("cannot write {}: the folder holds shard {}/{}, which shard {}/{} does not replace",
                                   out.string(), earlier->shard, earlier->shards, header.shard, header.shards));
    const JournalWriter nobody_writes(journal);
  }
  begin_folder(folder, journal_file, journal_head(header, session));
  return journal;
}

fs::path journal_in(const fs::path& folder) {
  std::error_code ignored;
  const fs::path path = fs::weakly_canonical(fs::absolute(folder), ignored);
  remove_leftovers(path.has_filename() ? path : path.parent_path());
  const fs::path journal = folder / journal_file;
  if (!fs::is_regular_file(journal, ignored))
    throw InputError(fmt::format("{}: there is no journal of a run in it", folder.string()));
  return journal;
}

}  // namespace cageproof::reports
