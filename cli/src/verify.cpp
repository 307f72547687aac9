// SPDX-License-Identifier: MIT
#include "commands.h"

#include "cageproof/core/input_error.h"
#include "cageproof/validation/verify.h"

#include <fmt/format.h>

#include <unistd.h>

#include <algorithm>
#include <cstdio>
#include <mutex>

namespace cageproof::cli {
namespace {

struct Arguments {
  CageArguments cage;
  std::string points, suite = "quick", out = "report", resume, shard = "0/1";
  validation::VerifyOptions options;
  int samples = 0, enclosures = -1;
  const CLI::App* command = nullptr;  // knows which options are given
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
  void say(const std::string& text) const {
    if (terminal_) fmt::print(stderr, "{}\n", text);
  }

 private:
  bool terminal_ = isatty(STDERR_FILENO) != 0;
  std::mutex mutex_;
  std::string stage_;
  std::size_t percent_ = 0;
};

// "I/N".
void set_shard(const std::string& text, validation::VerifyOptions& options) {
  int read = 0;
  if (std::sscanf(text.c_str(), "%d/%d%n", &options.shard, &options.shards, &read) != 2 ||
      read != static_cast<int>(text.size()) || options.shard < 0 || options.shard >= options.shards ||
      options.shards > 1000000)
    throw InputError(fmt::format("--shard {}: not I/N with 0 <= I < N", text));
}

// Options that are not given are those of the run that goes on.
void take_from_run(Arguments& a) {
  const auto run = validation::options_of_run(a.out);
  const auto unless_given = [&](const char* name, auto& value) {
    const auto found = run.find(name);
    if (found == run.end() || a.command->count(fmt::format("--{}", name)) > 0) return;
    CLI::detail::lexical_cast(found->second, value);
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
  // The journal knows what the cage was after any flip.
  a.cage.flip_inward = a.cage.flip_inward || a.cage.file != given;
}

int print_shard(const validation::VerifyOptions& options, const validation::Verified& done) {
  fmt::print("shard {}/{}: all {} units of work are done, {} of them now\n", options.shard, options.shards, done.units,
             done.measured);
  fmt::print("journal: {}/journal; `cageproof merge` makes one report of all {} shards\n", options.out.string(),
             options.shards);
  return success;
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
  if (suite == validation::suites().end()) throw InputError(fmt::format("there is no suite '{}'", a.suite));
  options.suite = *suite;
  if (a.samples > 0) options.suite.samples = a.samples;
  if (a.enclosures >= 0) options.suite.enclosures = a.enclosures;
  options.triangulation = a.cage.rule();
  options.out = a.out;
  if (!a.cage.file.empty()) options.cage = a.cage.load();
  if (!a.points.empty()) {
    if (!options.cage) throw InputError("--points needs --cage");
    options.mesh_name = a.points;
    options.mesh = load_points(a.points);
  }
  Progress progress;
  options.progress = [&](std::size_t done, std::size_t all) { progress("measuring", done, all); };
  const validation::Verified done = validation::verify(options);
  progress.clear();
  progress.say(fmt::format("measured in {:.1f} s", done.seconds));
  return done.report ? print_verdict(*done.report, a.out) : print_shard(options, done);
}

}  // namespace

void add_verify(CLI::App& app, Action& action, const std::string& command_line) {
  CLI::App* command = app.add_subcommand("verify", "the main job: every formula against its definition, and a report");
  auto a = std::make_shared<Arguments>();
  a->options.command_line = command_line;
  a->command = command;
  command->add_option("--formulas", a->options.formulas, "glob")->capture_default_str();
  command->add_option("--evaluations", a->options.evaluations, "glob")->capture_default_str();
  command->add_option("--regimes", a->options.regimes, "glob")->capture_default_str();
  a->cage.add_to(*command, false);
  command->add_option("--points", a->points, "points to try the cage at: a mesh, or text with three numbers a line");
  command->add_option("--samples", a->samples, "samples a formula and regime, instead of the suite's")
      ->check(CLI::Range(1, 100000000));
  command
      ->add_option(
          "--enclosures", a->enclosures,
          "samples a formula and regime that are enclosed rigorously, instead of the suite's; 1000 is a proof run")
      ->check(CLI::Range(0, 1000000));
  std::vector<std::string> suites;
  for (const auto& suite : validation::suites()) suites.emplace_back(suite.name);
  command->add_option("--suite", a->suite, "how much")->check(CLI::IsMember(suites))->capture_default_str();
  command->add_option("--seed", a->options.seed, "64-bit seed of all samples")->capture_default_str();
  command->add_option("--jobs", a->options.jobs, "threads; 0: all cores")
      ->check(CLI::Range(0, 1024))
      ->capture_default_str();
  CLI::Option* out = command->add_option("--out", a->out, "the report's folder")->capture_default_str();
  command->add_option("--shard", a->shard, "I/N: measure part I of N, from 0, alone; `merge` makes the report")
      ->capture_default_str();
  command
      ->add_option(
          "--resume", a->resume,
          "folder of a run to go on with; options that are not given are that run's, others must agree with it")
      ->excludes(out);
  command->callback([&action, a] { action = [a] { return run(*a); }; });
}

}  // namespace cageproof::cli
