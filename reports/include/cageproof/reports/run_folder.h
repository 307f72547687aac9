// SPDX-License-Identifier: MIT
// The folder that a run measures into.
#pragma once

#include "cageproof/reports/journal.h"

namespace cageproof::reports {

/// Begins a run: makes the folder, unless it is there, with a journal that has its header and nothing else. An earlier
/// report there stays until a new one is put in its place; its journal is replaced at once, and its
/// summaries are renamed (`earlier.summary.json.gz` ...), so that no run that fails leaves an older verdict in their
/// place. Returns the journal's path.
/// \throws InputError when the folder cannot be made, holds anything but a run of that kind (whole, or the same shard),
/// or a process writes to its journal
std::filesystem::path begin_run(const std::filesystem::path& out, const JournalHeader& header, const Session& session);

/// The path of the journal in a run's folder.
/// \throws InputError when there is none
std::filesystem::path journal_in(const std::filesystem::path& folder);

}  // namespace cageproof::reports
