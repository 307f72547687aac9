// SPDX-License-Identifier: MIT
#include "cageproof/validation/verify.h"

#include "run/build_id.h"
#include "run/run_plan.h"
#include "promises/verdicts.h"
#include "run/run_report.h"
#include "run/timings.h"
#include "truth/truth_cache.h"

#include "cageproof/core/input_error.h"
#include "cageproof/reports/run_folder.h"
#include "cageproof/validation/machine_facts.h"
#include "cageproof/core/parallel.h"

#include <fmt/format.h>

#include <atomic>
#include <chrono>
#include <cstdlib>
#include <mutex>
#include <optional>

namespace cageproof::validation {
namespace {

using reports::Journal;
using reports::JournalHeader;

// Records each measurement in the journal's file and in the journal held in memory.
class Recorder {
 public:
  Recorder(const std::filesystem::path& path, Journal& journal) : writer_(path), journal_(journal) {}

  void add_session(const Session& session) {
    writer_.add_session(session);
    journal_.sessions.push_back(session);
  }
  void add(std::size_t unit, PartialResult found) {
    for (auto& [key, tally] : found.rows) tally.role = role_of(key);
    {
      const std::scoped_lock lock(mutex_);
      found.drop_unwanted(journal_.gathered);
      journal_.gathered.merge(found);
      journal_.done[unit] = true;
      journal_.sessions.back().seconds = seconds();
    }
    writer_.add(unit, found, seconds());
  }
  double seconds() const { return std::chrono::duration<double>(std::chrono::steady_clock::now() - start_).count(); }

 private:
  std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
  std::mutex mutex_;
  reports::JournalWriter writer_;
  Journal& journal_;
};

std::string shard_text(const JournalHeader& header) { return fmt::format("{}/{}", header.shard, header.shards); }

// The journal of this run, as far as it got.
Journal earlier_journal(const std::filesystem::path& path, const JournalHeader& now,
                        const std::filesystem::path& folder) {
  Journal journal = reports::read_journal(path);
  std::string difference = difference_of_runs(journal.header, now);
  if (difference.empty() && journal.header.shard != now.shard)
    difference = fmt::format("shard {}, now {}", shard_text(journal.header), shard_text(now));
  if (difference.empty() && journal.header != now) difference = "another program made it";
  if (!difference.empty()) throw InputError(fmt::format("cannot resume {}: {}", folder.string(), difference));
  return journal;
}

Session session_of(const VerifyOptions& options) {
  Session session{timestamp(), 0, options.command_line, machine_facts(options.jobs)};
  if (options.take_times) session.times = options.take_times(options.formulas, options.evaluations);
  return session;
}

}  // namespace

const std::vector<Suite>& suites() {
  static const std::vector<Suite> all{
      {.name = "quick",
       .samples = 15,
       .swept_samples = 17,
       .integral_samples = 2,
       .integral_entries = 4,
       .enclosures = 1,
       .cage_points = 16,
       .truth_points = 2,
       .on_points = 48,
       .block_points = 12,
       .block_milliseconds = 1200,
       .mesh_points = 1000,
       .slice = 20,
       .pairs = 300,
       .scene_pairs = 12'000,
       .scene_side = 24,
       .scene_cage = "l-block",
       .shown_elements = 50,
       .has_time_limit = true},
      {.name = "standard",
       .samples = 400,
       .swept_samples = 0,
       .integral_samples = 4,
       .integral_entries = 0,
       .enclosures = 3,
       .cage_points = 240,
       .truth_points = 8,
       .on_points = 0,
       .block_points = 600,
       .block_milliseconds = 20000,
       .mesh_points = 20000,
       .slice = 120,
       .pairs = 40000,
       .scene_pairs = 400'000,
       .scene_side = 32,
       .scene_cage = "",
       .shown_elements = 0,
       .has_time_limit = false},
      {.name = "full",
       .samples = 100000,
       .swept_samples = 0,
       .integral_samples = 32,
       .integral_entries = 0,
       .enclosures = 1000,
       .cage_points = 4000,
       .truth_points = 64,
       .on_points = 0,
       .block_points = 24000,
       .block_milliseconds = 2000000,
       .mesh_points = 0,
       .slice = 240,
       .pairs = 400000,
       .scene_pairs = 4'000'000,
       .scene_side = 64,
       .scene_cage = "",
       .shown_elements = 0,
       .has_time_limit = false},
  };
  return all;
}

std::filesystem::path default_truth_cache() {
  const auto set = [](const char* name) {
    const char* const value = std::getenv(name);
    return std::string(value == nullptr ? "" : value);
  };
  if (const std::string given = set("CAGEPROOF_TRUTH_CACHE"); !given.empty()) return given == "off" ? "" : given;
  if (const std::string caches = set("XDG_CACHE_HOME"); !caches.empty())
    return std::filesystem::path(caches) / "cageproof";
  if (const std::string home = set("HOME"); !home.empty()) return std::filesystem::path(home) / ".cache" / "cageproof";
  return {};
}

std::optional<std::string> why_no_truth_cache(const std::filesystem::path& folder) {
  return folder.empty() || build_id() == "unknown" ? std::nullopt : TruthCache::why_not(folder, build_id());
}

Verified verify(const VerifyOptions& options) {
  const auto doing = [&](const std::string& what) {
    if (options.doing) options.doing(what);
  };
  RunPlan plan = plan_run(options);
  if (options.warn)
    for (const std::string& warning : plan.warnings) options.warn(warning);
  const std::vector<std::size_t> own = units_of_shard(plan.units, options.shard, options.shards);
  plan.header.shard_units = own.size();
  Timings timings(options.timings);
  std::optional<TruthCache> truths;
  if (!options.truth_cache.empty() && build_id() != "unknown") truths.emplace(options.truth_cache, build_id());
  const CachedTruths cached(truths ? &*truths : nullptr);
  doing("taking times");
  const Session session = session_of(options);
  doing("");
  Journal journal{plan.header, {}, std::vector<bool>(plan.units.size()), {}};
  std::filesystem::path path;
  if (options.resume) {
    path = reports::journal_in(options.out);
    journal = earlier_journal(path, plan.header, options.out);
  } else {
    path = reports::begin_run(options.out, plan.header, session);
    journal.sessions.push_back(session);
  }
  std::vector<std::size_t> open;
  for (const std::size_t unit : own)
    if (!journal.done[unit]) open.push_back(unit);
  Verified result;
  result.units = own.size();
  result.points_outside = plan.points_outside;
  result.measured = open.size();
  {
    Recorder recorder(path, journal);
    if (options.resume) recorder.add_session(session);
    {
      UnitsOfWork work(std::move(plan.measurements), std::move(plan.units), open);
      std::atomic<std::size_t> done{own.size() - open.size()};
      for_each_parallel(open.size(), options.jobs, [&](std::size_t i) {
        const std::string name = work.name(open[i]);
        const double start = thread_seconds();
        doing(name);
        recorder.add(open[i], work.measure(open[i]));
        doing("");
        timings.add(name, work.block(open[i]), thread_seconds() - start);
        if (options.progress) options.progress(++done, own.size());
      });
    }
    timings.write();
    if (truths) {
      result.truths_taken = truths->taken();
      result.truths_made = truths->made();
    }
    result.seconds = recorder.seconds();
    result.session_notes = session_notes(journal.sessions);
    if (options.warn)
      for (const std::string& note : notes_on_refusals(journal.gathered)) options.warn(note);
    doing("writing the report");
    if (options.shards == 1) result.report = write_report(options.out, std::move(journal));
    doing("");
  }
  return result;
}

std::map<std::string, std::string> options_of_run(const std::filesystem::path& folder) {
  const std::filesystem::path path = reports::journal_in(folder);
  const auto header = reports::find_journal_header(path);
  if (!header) throw InputError(fmt::format("{}: not the journal of a verification", path.string()));
  auto options = header->options;
  options["shard"] = shard_text(*header);
  return options;
}

}  // namespace cageproof::validation
