// SPDX-License-Identifier: MIT
// The journal of a run: what was found, as text, one JSON object a line. A header says which run it is; then a line is
// appended for each unit of work that ends. A process that dies leaves whole lines and at most one torn one, which is
// dropped on reading. A finished journal is packed (packed_file.h).
#pragma once

#include "cageproof/core/results/partial_result.h"

#include <algorithm>
#include <filesystem>
#include <functional>
#include <mutex>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace cageproof::reports {

/// A journal's name within its folder.
inline constexpr std::string_view journal_file = "journal";

/// Which run, and which part of it. Journals whose headers agree in all but `shard` and `shard_units` are of one run.
struct JournalHeader {
  std::string version;                          ///< of the program
  std::map<std::string, std::string> options;   ///< all that figures depend on
  std::map<std::string, std::string> settings;  ///< RunResult::settings
  std::vector<std::string> notes;               ///< of the report, known before anything is measured
  std::size_t units = 0;                        ///< units of work of the whole run; a unit is known by its number below
  int shard = 0, shards = 1;                    ///< this journal is for part `shard` of `shards`
  std::size_t shard_units = 0;                  ///< units of this part

  bool operator==(const JournalHeader&) const = default;
};

/// The whole contents of a journal.
struct Journal {
  JournalHeader header;
  std::vector<Session> sessions;
  std::vector<bool> done;  ///< by unit
  PartialResult gathered;  ///< of these units

  std::size_t units_done() const { return static_cast<std::size_t>(std::ranges::count(done, true)); }
};

/// Reads a journal. A last line that is torn counts as not there.
/// \throws InputError naming file and line: missing, no journal, another schema, a malformed line, a unit that is there
/// twice
Journal read_journal(const std::filesystem::path& path);

/// Only the header; nothing when there is no such file, or it does not begin with a whole header.
/// \throws InputError when it cannot be read
std::optional<JournalHeader> find_journal_header(const std::filesystem::path& path);

/// The first line of a fresh journal.
std::string journal_head(const JournalHeader& header, const Session& session);

/// Hands out the lines of a finished journal, one per row of results: a function of what was found, except for the
/// object "environment" in the first line. \pre all units are done
void put_journal(const Journal& journal, const std::function<void(std::string_view)>& put);
/// The same as one text. \pre all units are done
std::string journal_text(const Journal& journal);

/// Appends to a journal that exists. Safe from several threads.
class JournalWriter {
 public:
  /// Opens it, and cuts off a torn last line.
  /// \throws InputError when it cannot be written or locked, or another process writes to it
  explicit JournalWriter(const std::filesystem::path& path);
  ~JournalWriter();
  JournalWriter(const JournalWriter&) = delete;
  JournalWriter& operator=(const JournalWriter&) = delete;

  /// A new process goes on with the run.
  void add_session(const Session& session);
  /// A unit is done, whose results these are. \param seconds since the session started
  /// \throws InputError when the line cannot be written as a whole; nothing is written after that
  void add(std::size_t unit, const PartialResult& found, double seconds);

 private:
  void append(const std::string& line);
  std::filesystem::path path_;
  int file_ = -1;
  std::mutex mutex_;
  bool failed_ = false;
};

}  // namespace cageproof::reports
