// SPDX-License-Identifier: MIT
// The main job: campaigns on elements, properties on cages and fields are measured into a journal; a report is made of
// a journal.
#pragma once

#include "cageproof/core/cage/cage.h"
#include "cageproof/core/cage/mesh_io.h"
#include "cageproof/core/results/run_result.h"

#include <filesystem>
#include <functional>
#include <optional>

namespace cageproof::reports {
struct Journal;
}

namespace cageproof::validation {

/// How much a suite does.
struct Suite {
  std::string_view name;
  int samples;             ///< of each formula in each regime
  int swept_samples;       ///< CampaignOptions::swept_samples
  int integral_samples;    ///< CampaignOptions::integral_samples
  int integral_entries;    ///< CampaignOptions::integral_entries
  int enclosures;          ///< of each formula in each regime, enclosed rigorously
  int cage_points;         ///< a cage, off it
  int truth_points;        ///< of these, against multiprecision
  int on_points;           ///< an embedded cage, on it, at most; 0: all vertices, and points of all edges and faces
  int block_points;        ///< a cage and kind, for block errors of evaluations of whole coordinates, at most
  int block_milliseconds;  ///< that their truths may cost (BlockCampaignOptions)
  int mesh_points;         ///< of a mesh, at most, for each kind of coordinates; 0: all
  int slice;               ///< samples per side of the fields of linear reproduction
  int pairs;               ///< multiprecision evaluations a field of errors may cost
  int scene_pairs;         ///< and a scene of errors side by side
  int scene_side;          ///< at most this many samples per side of these
  std::string_view scene_cage;  ///< the one embedded cage that gets a scene of errors; empty: every cage gets one
  int shown_elements;           ///< embedded cages with more elements get no fields; 0: all get them
  bool has_time_limit;          ///< a verdict in minutes: what takes its time and is not judged there is left out
};

/// quick is the default, for a verdict in minutes; standard takes some twenty on two cores, full as long as asked.
const std::vector<Suite>& suites();

struct VerifyOptions {
  std::string formulas = "*", evaluations = "*", regimes = "*";
  Suite suite;
  std::uint64_t seed = 1;
  int jobs = 0;
  std::optional<Cage> cage;  ///< nothing: the embedded cages
  std::optional<Mesh> mesh;  ///< points to try the cage at
  std::string mesh_name;
  bool only_cage = false;  ///< of `cage` and `mesh`, without formulas on elements of the catalogue's own
  Triangulation triangulation = Triangulation::Shortest;
  int shard = 0, shards = 1;  ///< measure only part `shard` of `shards`, and make no report
  bool resume = false;        ///< `out` holds the journal of this run, to go on with
  std::filesystem::path out;
  /// Where the processor time of each unit of work goes, the costliest first (timings.h); empty: nowhere.
  std::filesystem::path timings;
  /// The folder of truths that are kept between runs (truth_cache.h); empty: none. The report is the same without.
  std::filesystem::path truth_cache;
  std::string command_line;
  /// Takes the times of evaluations whose formulas and names match these globs, before anything is measured. Null:
  /// the report has none.
  std::function<std::vector<EvaluationTime>(const std::string& formulas, const std::string& evaluations)> take_times;
  /// Called before anything is measured, with the parts that the run leaves out of the user's cage, and why.
  std::function<void(const std::string&)> warn;
  /// Told what a thread begins, by name, and, with an empty one, that it has ended that: in planning, in measuring and
  /// in drawing the report. From any thread. Null: nobody.
  std::function<void(const std::string& what)> doing = nullptr;
  /// Called as units of work end.
  std::function<void(std::size_t done, std::size_t all)> progress;
};

/// Result and work of one process for a run.
struct Verified {
  std::optional<RunResult> report;         ///< nothing for a shard
  std::size_t units = 0;                   ///< of the run or shard
  std::size_t measured = 0;                ///< of these, by this process
  std::size_t points_outside = 0;          ///< the cage, of VerifyOptions::mesh
  double seconds = 0;                      ///< of this process, without drawing
  std::size_t truths_taken = 0;            ///< of elements, from the folder that keeps them
  std::size_t truths_made = 0;             ///< that the folder did not have, or that were made again to check it
  std::vector<std::string> session_notes;  ///< RunResult::session_notes
};

/// Where truths are kept unless a user says otherwise: $CAGEPROOF_TRUTH_CACHE, $XDG_CACHE_HOME/cageproof or
/// ~/.cache/cageproof. Empty where the first is `off`, or none is set.
std::filesystem::path default_truth_cache();

/// Why truths cannot be kept in a folder; nothing where they can, or the program keeps none.
std::optional<std::string> why_no_truth_cache(const std::filesystem::path& folder);

/// Measures into `out`/journal; of a whole run, makes the report.
/// \throws InputError for patterns that match nothing, reports that cannot be written, and runs that cannot be resumed:
/// there is no journal, or it is of
///   another version, of other options (each named with both values) or of another shard
Verified verify(const VerifyOptions& options);

/// The options of the run in a folder, by the names they have on the command line, and "shard" as "I/N".
/// \throws InputError when there is no journal
std::map<std::string, std::string> options_of_run(const std::filesystem::path& folder);

/// Makes the report of a finished run again, only from its journal.
/// \throws InputError when there is none, or it is unfinished or of a shard
RunResult report_again(const std::filesystem::path& folder);

/// Makes one run of its shards, and its report.
/// \throws InputError when parts are of different runs, overlap, are missing or unfinished, each named, or `out` cannot
/// be written
RunResult merge_shards(const std::vector<std::filesystem::path>& parts, const std::filesystem::path& out);

/// Why a journal's run is not finished, and how it goes on; nothing where all its units are done. \param folder of the
/// run
std::optional<std::string> unfinished(const reports::Journal& journal, const std::filesystem::path& folder);

/// The text of summary.json.gz for a journal, finished or not.
/// \throws InputError when it cannot be read
std::string summary_of_journal(const std::filesystem::path& journal);

}  // namespace cageproof::validation
