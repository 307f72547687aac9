// SPDX-License-Identifier: MIT
#include "commands.h"
#include "inputs_outside.h"
#include "judge_option.h"
#include "progress.h"

#include "cageproof/benchmarks/evaluation_times.h"
#include "cageproof/benchmarks/kind_times.h"
#include "cageproof/core/input_error.h"
#include "cageproof/core/catalogue/unknown_name.h"
#include "cageproof/validation/verify.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstdio>
#include <optional>

namespace cageproof::cli {
namespace {

struct Arguments {
  CageArguments cage;
  std::string points, suite = "quick", out = "report", resume, shard = "0/1", timings, truth_cache;
  validation::VerifyOptions options;
  int samples = 0, enclosures = -1;
  bool strict = false;
  JudgeOption judge;
  std::optional<Command> command;  // knows which options are given
};

// "I/N".
void set_shard(const std::string& text, validation::VerifyOptions& options) {
  int read = 0;
  if (std::sscanf(text.c_str(), "%d/%d%n", &options.shard, &options.shards, &read) != 2 ||
      read != static_cast<int>(text.size()) || options.shard < 0 || options.shard >= options.shards ||
      options.shards > 1000000)
    throw InputError(fmt::format("--shard {}: not I/N with 0 <= I < N", text));
}

// Options that are not given are taken from the run that is resumed.
void take_from_run(Arguments& a) {
  const auto run = validation::options_of_run(a.out);
  const auto unless_given = [&](const char* name, auto& value) {
    const auto found = run.find(name);
    if (found == run.end() || a.command->given(fmt::format("--{}", name))) return;
    read_value(found->second, value);
  };
  unless_given("formulas", a.options.formulas);
  unless_given("evaluations", a.options.evaluations);
  unless_given("regimes", a.options.regimes);
  unless_given("suite", a.suite);
  unless_given("samples", a.samples);
  unless_given("enclosures", a.enclosures);
  unless_given("seed", a.options.seed);
  unless_given("triangulate", a.cage.triangulate);
  unless_given("points", a.points);
  unless_given("shard", a.shard);
  const std::string given = a.cage.file;
  unless_given("cage", a.cage.file);
  // The journal stores the cage as it was after any flip.
  a.cage.flip_inward = a.cage.flip_inward || a.cage.file != given;
}

std::vector<std::string_view> names_of_suites() {
  std::vector<std::string_view> names;
  for (const validation::Suite& suite : validation::suites()) names.push_back(suite.name);
  return names;
}

int print_shard(const validation::VerifyOptions& options, const validation::Verified& done) {
  fmt::print("shard {}/{}: all {} units of work are done, {} of them now\n", options.shard, options.shards, done.units,
             done.measured);
  fmt::print("journal: {}; `cageproof merge` makes one report of all {} shards\n", (options.out / "journal").string(),
             options.shards);
  return success;
}

// Where truths are kept when nobody names a folder: a run does not stop for want of it.
std::filesystem::path usual_truth_cache() {
  std::filesystem::path folder = validation::default_truth_cache();
  const auto reason = validation::why_no_truth_cache(folder);
  if (!reason) return folder;
  fmt::print(stderr, "warning: no truths are kept for other runs: {}\n", *reason);
  return {};
}

// A cage is verified by itself unless an option of single elements is given with it.
bool is_only_cage(const Arguments& a) {
  for (const char* const option : {"--formulas", "--regimes", "--samples", "--enclosures"})
    if (a.command->given(option)) return false;
  if (a.options.resume) return validation::options_of_run(a.out).contains("scope");
  return !a.cage.file.empty();
}

int run(Arguments& a) {
  auto& options = a.options;
  if (!a.resume.empty()) {
    options.resume = true;
    a.out = a.resume;
    take_from_run(a);
  }
  set_shard(a.shard, options);
  const auto suite = std::ranges::find(validation::suites(), a.suite, &validation::Suite::name);
  if (suite == validation::suites().end()) throw unknown_name("suite", a.suite, names_of_suites());
  options.suite = *suite;
  options.only_cage = is_only_cage(a);
  // A number that is asked for holds for sweeps, too.
  if (a.samples > 0 && a.samples != suite->samples) {
    options.suite.samples = a.samples;
    options.suite.swept_samples = 0;
  }
  if (a.enclosures >= 0) options.suite.enclosures = a.enclosures;
  options.triangulation = a.cage.rule();
  options.out = a.out;
  options.timings = a.timings;
  if (a.truth_cache.empty()) options.truth_cache = usual_truth_cache();
  else if (a.truth_cache != "off") options.truth_cache = a.truth_cache;
  require_outside(a.out, {{a.cage.file, "--cage"}, {a.points, "--points"}});
  if (!a.cage.file.empty()) options.cage = a.cage.load();
  a.judge.begin(options.formulas);
  if (!a.points.empty()) {
    if (!options.cage) throw InputError("--points needs --cage");
    options.mesh_name = a.points;
    options.mesh = load_points(a.points, options.cage->dimension());
  }
  // A report on a cage states the times of kinds of coordinates in it, other reports those of formulas on one element.
  options.take_times = [&](const std::string& formulas, const std::string& evaluations) {
    return options.only_cage ? benchmarks::times_of_kinds(*options.cage, options.triangulation)
                             : benchmarks::times_of_evaluations(formulas, evaluations);
  };
  options.warn = [](const std::string& text) { fmt::print(stderr, "warning: {}\n", text); };
  Progress progress;
  options.doing = [&](const std::string& what) { progress.doing(what); };
  options.progress = [&](std::size_t done, std::size_t all) { progress("measuring", done, all); };
  const validation::Verified done = validation::verify(options);
  progress.clear();
  progress.say(fmt::format("measured in {:.1f} s", done.seconds));
  if (done.truths_taken > 0)
    progress.say(fmt::format("{} of {} truths of elements were there from earlier runs, in {}", done.truths_taken,
                             done.truths_taken + done.truths_made, options.truth_cache.string()));
  const int code = done.report ? print_verdict(*done.report, a.out) : print_shard(options, done);
  return a.strict && done.points_outside > 0 ? promise_broken : code;
}

}  // namespace

void add_verify(CommandLine& line, const std::string& command_line) {
  Command command =
      line.command("verify", "the main job: compare every formula with its definition, and write a report");
  auto a = std::make_shared<Arguments>();
  a->options.command_line = command_line;
  a->command = command;
  command.heading("Questions");
  command.option("--formulas,--formula", a->options.formulas, "formulas: names and globs with commas between")
      .taking("FORMULAS")
      .showing_default();
  command.option("--evaluations,--evaluation", a->options.evaluations, "evaluations of these formulas")
      .taking("EVALUATIONS")
      .showing_default();
  command.option("--regimes,--regime", a->options.regimes, "regimes, which say where points lie relative to elements")
      .taking("REGIMES")
      .showing_default();
  a->judge.add_to(command);
  command.heading("A cage of your own");
  a->cage.add_to(command, false);
  command
      .option("--points", a->points,
              "points to try the cage at: a mesh, or text with three numbers per line (for polygons two)" +
                  std::string(y_of_points))
      .taking("FILE");
  command.heading("How much");
  command
      .option("--samples", a->samples,
              "samples of each formula in each regime, instead of the suite's; with --cage this asks for formulas on "
              "single elements as well, which takes minutes")
      .in_range(1, 100000000);
  command
      .option("--enclosures", a->enclosures,
              "samples of each formula in each regime that are enclosed rigorously, instead of the suite's; 1000 is a "
              "proof run")
      .in_range(0, 1000000);
  const auto suites = names_of_suites();
  command.option("--suite", a->suite, "how much: seconds, minutes or hours; `full` is for shards on many cores")
      .one_of({suites.begin(), suites.end()})
      .showing_default();
  command.option("--seed", a->options.seed, "64-bit seed of all samples").showing_default();
  command.heading("Output");
  const Option out = command.option("--out", a->out, "the report's folder").taking("FOLDER").showing_default();
  command.option("--timings", a->timings, "a CSV table of the processor time of each unit of work, the costliest first")
      .taking("FILE");
  command.heading("Running");
  command.option("--jobs", a->options.jobs, "threads; 0: one per core").in_range(0, 1024).showing_default();
  command.option("--shard", a->shard, "measure only part I of N, counted from 0; `merge` makes the report")
      .taking("I/N")
      .showing_default();
  command
      .option("--resume", a->resume,
              "go on with the run in this folder, with its options; options that are given must agree with them")
      .taking("FOLDER")
      .excludes(out);
  command
      .option("--truth-cache", a->truth_cache,
              "folder that keeps truths of elements between runs of the same program, at most 512 MB; one in a hundred "
              "is checked, and the report is the same without; `off`: none; default, where it can be written: "
              "$CAGEPROOF_TRUTH_CACHE, "
              "$XDG_CACHE_HOME/cageproof or ~/.cache/cageproof")
      .taking("FOLDER");
  command.flag("--strict", a->strict, "exit with 1 also where a point of --points lies outside the cage");
  add_quiet(command);
  command.example("cageproof verify --suite quick --out report");
  command.example("cageproof verify --formulas 'triangle.*' --regimes 'near-*,far' --evaluations closed_form,gauss-8");
  command.example("cageproof verify --cage my-cage.obj --points my-mesh.obj --out my-report");
  command.example("cageproof verify --formulas '*' --cage my-cage.obj --out cage-and-elements");
  command.example("cageproof verify --resume report");
  command.example("cageproof verify --judge mine=./libmine.so --formulas triangle.double_layer");
  command.runs([a] { return run(*a); });
}

}  // namespace cageproof::cli
