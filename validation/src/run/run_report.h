// SPDX-License-Identifier: MIT
#pragma once

#include "cageproof/reports/journal.h"

namespace cageproof::validation {

/// The option that stands for the list of units of work.
inline constexpr const char* work_option = "work";

/// The result of a journal's findings, without the fields. Moves the journal's rows, because they are large.
RunResult result_of(reports::Journal& journal);

/// Writes the whole report of a run whose units are all done.
/// \throws InputError when it cannot be written
RunResult write_report(const std::filesystem::path& out, reports::Journal journal);

/// In what two journals show that they are of different runs: version, options with both values, number of shards.
/// Empty: they are of one run.
std::string difference_of_runs(const reports::JournalHeader& before, const reports::JournalHeader& now);

/// Notes on differences between sessions that may change figures: the program's build, the elementary functions of
/// their processors, and the instruction set.
std::vector<std::string> session_notes(const std::vector<Session>& sessions);

/// PartialResult::refused in words, one for each reason.
std::vector<std::string> notes_on_refusals(const PartialResult& gathered);

}  // namespace cageproof::validation
