// SPDX-License-Identifier: MIT
#include "commands.h"

#include "cageproof/core/input_error.h"
#include "cageproof/validation/verify.h"

#include <fmt/format.h>

#include <unistd.h>

#include <algorithm>
#include <mutex>

namespace cageproof::cli {
namespace {

struct Arguments {
  CageArguments cage;
  std::string points, suite = "standard", out = "report";
  validation::VerifyOptions options;
  int samples = 0, enclosures = -1;
};

// One line on a terminal, rewritten; nothing elsewhere.
class Progress {
 public:
  void operator()(const std::string& stage, std::size_t done, std::size_t all) {
    if (!terminal_) return;
    const std::scoped_lock lock(mutex_);
    const std::size_t percent = all == 0 ? 100 : 100 * done / all;
    if (stage == stage_ && percent == percent_) return;
    stage_ = stage;
    percent_ = percent;
    fmt::print(stderr, "\r\033[K{} {} %", stage, percent);
  }
  void clear() const {
    if (terminal_) fmt::print(stderr, "\r\033[K");
  }

 private:
  bool terminal_ = isatty(STDERR_FILENO) != 0;
  std::mutex mutex_;
  std::string stage_;
  std::size_t percent_ = 0;
};

void print_summary(const RunResult& result, const std::string& out) {
  std::size_t kept = 0, broken = 0, unpromised = 0;
  for (const ResultRow& row : result.rows) {
    kept += row.verdict == Verdict::Kept;
    broken += row.verdict == Verdict::Broken;
    unpromised += row.verdict == Verdict::NotPromised;
  }
  for (const ResultRow& row : result.rows)
    if (row.verdict == Verdict::Broken)
      fmt::print("BROKEN {} {} {} {}{} {} order {}: {:.3g} {} > {:.3g}, {}\n", row.subject, row.evaluation, row.scalar,
                 row.regime, row.place.empty() ? "" : " " + row.place, row.check, row.order, row.max, row.unit, *row.bound,
                 row.reason);
  fmt::print("{}: {} promises kept, {} broken, {} rows not promised; {:.1f} s\n",
             broken == 0 ? "all promises kept" : "PROMISES BROKEN", kept, broken, unpromised, result.seconds);
  fmt::print("report: {}/index.html\n", out);
  if (broken != 0) fmt::print("worst inputs: cageproof replay {}/worst.jsonl\n", out);
}

int run(Arguments& arguments) {
  auto& options = arguments.options;
  options.suite = *std::ranges::find(validation::suites(), arguments.suite, &validation::Suite::name);
  if (arguments.samples > 0) options.suite.samples = arguments.samples;
  if (arguments.enclosures >= 0) options.suite.enclosures = arguments.enclosures;
  options.triangulation = arguments.cage.rule();
  options.out = arguments.out;
  if (!arguments.cage.file.empty()) options.cage = arguments.cage.load();
  if (!arguments.points.empty()) {
    if (!options.cage) throw InputError("--points needs --cage");
    options.mesh_name = arguments.points;
    options.mesh = load_points(arguments.points);
  }
  Progress progress;
  options.progress = [&](const std::string& stage, std::size_t done, std::size_t all) { progress(stage, done, all); };
  const RunResult result = validation::verify(options);
  progress.clear();
  print_summary(result, arguments.out);
  return result.all_kept() ? all_kept : promise_broken;
}

}  // namespace

void add_verify(CLI::App& app, Action& action, const std::string& command_line) {
  CLI::App* command = app.add_subcommand("verify", "the main job: every formula against its definition, and a report");
  auto a = std::make_shared<Arguments>();
  a->options.command_line = command_line;
  command->add_option("--formulas", a->options.formulas, "glob")->capture_default_str();
  command->add_option("--evaluations", a->options.evaluations, "glob")->capture_default_str();
  command->add_option("--regimes", a->options.regimes, "glob")->capture_default_str();
  a->cage.add_to(*command, false);
  command->add_option("--points", a->points, "points to try the cage at: a mesh, or text with three numbers a line");
  command->add_option("--samples", a->samples, "samples a formula and regime, instead of the suite's")
      ->check(CLI::Range(1, 100000000));
  command->add_option("--enclosures", a->enclosures,
                      "samples a formula and regime that are enclosed rigorously, instead of the suite's; 1000 is a proof run")
      ->check(CLI::Range(0, 1000000));
  std::vector<std::string> suites;
  for (const auto& suite : validation::suites()) suites.emplace_back(suite.name);
  command->add_option("--suite", a->suite, "how much")->check(CLI::IsMember(suites))->capture_default_str();
  command->add_option("--seed", a->options.seed, "64-bit seed of all samples")->capture_default_str();
  command->add_option("--jobs", a->options.jobs, "threads; 0: all cores")->check(CLI::Range(0, 1024))->capture_default_str();
  command->add_option("--out", a->out, "the report's folder")->capture_default_str();
  command->callback([&action, a] { action = [a] { return run(*a); }; });
}

}  // namespace cageproof::cli
