// SPDX-License-Identifier: MIT
#include "commands.h"
#include "judge_option.h"
#include "progress.h"

#include "cageproof/core/catalogue/name_pattern.h"
#include "cageproof/core/coordinates/coordinates.h"
#include "cageproof/core/input_error.h"
#include "cageproof/core/results/build_facts.h"
#include "cageproof/judge/certificate.h"
#include "cageproof/judge/sides.h"
#include "cageproof/judge/templates.h"
#include "cageproof/reports/checked_file.h"
#include "cageproof/validation/machine_facts.h"
#include "cageproof/validation/regime.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <iostream>

namespace cageproof::cli {
namespace {

struct Arguments {
  std::string code, scalar = "double", measure = "relative", out, language, kind, command_line;
  std::vector<std::string> formulas;
  judge::ElementCampaignOptions options;
  judge::Limits limits;
  double promise = std::numeric_limits<double>::quiet_NaN(), memory = 4;
  int dimension = 3;
  bool strict = false, inputs = false;
};

// Files that are there stay as they are.
int write_template(const Arguments& a) {
  const std::filesystem::path folder = a.out.empty() ? "." : a.out;
  if (a.formulas.size() > 1) throw InputError("--template has one formula: name one with --formula");
  const auto files = judge::template_files(a.language, !a.formulas.empty() ? a.formulas.front() : a.kind);
  for (const auto& [name, text] : files)
    if (std::filesystem::exists(folder / name))
      throw InputError(fmt::format("{} is there already: name another folder with --out", (folder / name).string()));
  std::filesystem::create_directories(folder);
  for (const auto& [name, text] : files) {
    reports::write_file(folder / name, text);
    if (name.ends_with(".py"))
      std::filesystem::permissions(folder / name,
                                   std::filesystem::perms::owner_exec | std::filesystem::perms::group_exec,
                                   std::filesystem::perm_options::add);
    fmt::print("{}\n", (folder / name).string());
  }
  fmt::print("the commands to build and to judge it stand at the top of {}\n", (folder / files.back().first).string());
  return success;
}

// Adds one formula to the certificate: its convention, its defects by name, its errors in that convention.
void judge_formula(judge::Certificate& c, judge::ForeignCode& code, const Formula& formula, const std::string& name,
                   judge::ElementCampaignOptions options) {
  // Conventions and defects are told from results in double.
  std::optional<judge::Verdict> verdict;
  if (!options.single) {
    const Evaluation theirs = evaluation_named(formula.name, name);
    verdict = judge::judge(theirs, {.seed = options.seed, .max_order = theirs.max_order()});
    if (verdict->convention && !verdict->convention->is_ours(formula.name))
      options.ours = judge::in_our_convention(theirs, *verdict->convention);
  }
  c.formulas.push_back(judge::run_element_campaign(code, formula, name, options));
  std::vector<judge::CodeFinding> found = judge::findings_of({c.formulas.back()}, {});
  if (verdict) {
    found = judge::beside_named(std::move(found), !verdict->findings.empty());
    const auto named = judge::named_findings(*verdict, formula);
    found.insert(found.begin(), named.begin(), named.end());
  }
  c.findings.insert(c.findings.end(), found.begin(), found.end());
}

// Adds coordinates of whole cages to the certificate: their defects by name, their errors.
void judge_kind(judge::Certificate& c, judge::ForeignCode& code, std::string_view kind, const std::string& name,
                const judge::ElementCampaignOptions& options, int dimension) {
  if (kind == judge::kSides) {
    c.formulas.push_back(judge::run_side_campaign(code, options, dimension));
    c.findings = judge::findings_of({c.formulas.back()}, {});
    return;
  }
  if (code.is_library() && coordinate_kind_named(kind).keeps_quads)
    throw InputError(
        fmt::format("{} has faces of three and four corners, which cageproof_judge.h has no function for: judge a "
                    "program that answers lines",
                    kind));
  const judge::CageVerdict verdict = judge::judge_whole_cage(judge::whole_cage_function(code, kind), kind, dimension);
  c.formulas.push_back(judge::run_cage_campaign(code, kind, name, options, verdict.convention, dimension));
  c.findings = judge::named_findings(verdict, kind);
  const auto found = judge::beside_named(judge::findings_of({c.formulas.back()}, {}), !verdict.findings.empty());
  c.findings.insert(c.findings.end(), found.begin(), found.end());
}

void judge_formulas(judge::Certificate& c, const std::shared_ptr<judge::ForeignCode>& code, const Arguments& a,
                    const std::vector<std::string>& formulas) {
  Progress progress;
  for (const std::string& formula : formulas) {
    if (code->order_of(formula_named(formula), a.options.single) < 0) continue;
    judge::ElementCampaignOptions options = a.options;
    options.progress = [&](std::size_t done, std::size_t all) { progress(formula, done, all); };
    judge_formula(c, *code, formula_named(formula), c.name, options);
    progress.clear();
    std::cout << judge::table_of(c.formulas.back(), a.inputs);
  }
}

// A question that holds a whole cage has thousands of characters.
std::string shortened(const std::string& input) {
  constexpr std::size_t most = 400, shown = 160;
  if (input.size() <= most) return input;
  return fmt::format("{} ... {} ({} characters; --inputs prints all, and --out writes them)", input.substr(0, shown),
                     input.substr(input.size() - shown), input.size());
}

void print(const judge::Certificate& c, const Arguments& a) {
  for (const judge::CodeFinding& finding : c.findings) {
    std::string text = fmt::format("{}{}", finding.is_defect ? "DEFECT " : "remark ", finding.kind);
    if (!finding.formula.empty()) text += fmt::format(", {}, order {}", finding.formula, finding.order);
    fmt::print("{}: {}{}\n", text, finding.text, finding.count > 1 ? fmt::format(" ({} times)", finding.count) : "");
    if (!finding.input.empty()) fmt::print("  {}\n", a.inputs ? finding.input : shortened(finding.input));
  }
  if (c.skipped > 0) fmt::print("{} inputs were not asked, because it hung or died too often\n", c.skipped);
  if (c.promise)
    fmt::print("its own promise, {} error at most {:g}: {}\n", name_of(c.promise->measure), c.promise->bound,
               c.promise->is_kept
                   ? "kept"
                   : fmt::format("BROKEN in {} rows, as {}", c.promise->broken.size(), c.promise->broken.front()));
  const std::string judged = !a.kind.empty()
                                 ? a.kind + (a.dimension == 2 ? " in the plane" : "")
                                 : fmt::format("{} formula{}", c.formulas.size(), c.formulas.size() == 1 ? "" : "s");
  fmt::print("{}: {}; {} samples a regime, {}\n", c.name,
             c.has_defects()    ? "DEFECTS"
             : c.is_undecided() ? "undecided: rows without a sample, or inputs that it declined"
                                : "clean",
             c.samples, judged);
  if (!a.out.empty()) fmt::print("certificate: {0}/certificate.md, {0}/certificate.json\n", a.out);
}

std::optional<judge::OwnPromise> promise_of(const Arguments& a) {
  if (std::isnan(a.promise)) return std::nullopt;
  using Measure = judge::OwnPromise::Measure;
  judge::OwnPromise promise;
  promise.bound = a.promise;
  for (const Measure measure : {Measure::Relative, Measure::Absolute, Measure::Conditioned})
    if (judge::name_of(measure) == a.measure) promise.measure = measure;
  return promise;
}

int run(Arguments& a) {
  if (!a.language.empty()) return write_template(a);
  if (a.code.empty()) throw InputError("no code to judge: give NAME=WHAT, such as mine=./libmine.so, or --template");
  const auto [name, what] = judge::name_and_what(a.code);
  std::vector<std::string_view> regimes;
  for (const validation::Regime& regime : validation::regimes()) regimes.push_back(regime.name);
  if (a.kind == judge::kSides) {
    if (!std::isnan(a.promise))
      throw InputError("--promise bounds errors of numbers; sides are right or wrong, so leave it out");
    regimes = judge::side_regimes(a.dimension);
  } else if (!a.kind.empty()) {
    judge::require_judged_kind(a.kind, a.dimension);
    regimes = judge::cage_regimes(a.dimension);
  }
  require_known("regime", a.options.regimes, regimes);
  a.limits.memory = static_cast<std::uint64_t>(std::ldexp(a.memory, 30));
  a.options.single = a.scalar == "float";
  judge::Certificate c;
  c.started = validation::timestamp();
  const auto code = std::make_shared<judge::ForeignCode>(what, a.limits);
  c.name = name;
  c.what = what;
  c.about = code->about();
  c.files = code->files();
  c.version = CAGEPROOF_VERSION;
  c.commit = build_commit();
  c.command_line = a.command_line;
  c.scalar = a.scalar;
  c.samples = a.options.samples;
  c.seed = a.options.seed;
  std::vector<std::string> formulas;
  if (a.kind.empty()) {
    const std::string list = a.formulas.empty() ? "*" : fmt::format("{}", fmt::join(a.formulas, ","));
    formulas = judge::register_foreign_code(code, name, list);
  }
  // A folder that cannot be written is refused before the wait.
  if (!a.out.empty()) {
    std::filesystem::create_directories(a.out);
    reports::require_writable({a.out + "/certificate.json", a.out + "/certificate.md"});
  }
  if (a.kind.empty()) {
    judge_formulas(c, code, a, formulas);
  } else {
    judge_kind(c, *code, a.kind, name, a.options, a.dimension);
    std::cout << judge::table_of(c.formulas.back(), a.inputs);
  }
  const bool has_rows = std::ranges::any_of(c.formulas, [](const auto& one) { return !one.rows.empty(); });
  if (!c.formulas.empty() && !has_rows)
    throw InputError(fmt::format("no regime of '{}' exists for these formulas", a.options.regimes));
  if (c.formulas.empty()) throw InputError(fmt::format("{} gives none of the formulas in {}", name, a.scalar));
  const bool answers = std::ranges::any_of(c.formulas, [](const auto& one) {
    return std::ranges::any_of(one.rows, [](const auto& row) { return row.samples > 0 || row.failed > 0; });
  });
  if (!answers)
    throw InputError(fmt::format(
        "{} declined all inputs, so there is no verdict; ask it by hand with a line of eval, as in docs/judge.md",
        name));
  code->finish();
  const auto incidents = judge::findings_of({}, code->incidents());
  c.findings.insert(c.findings.begin(), incidents.begin(), incidents.end());
  c.skipped = code->skipped();
  if (auto promise = promise_of(a)) c.promise = judge::judged_promise(*promise, c.formulas, a.options.single);
  if (!a.out.empty())
    reports::replace_files(
        {{a.out + "/certificate.json", judge::json_of(c)}, {a.out + "/certificate.md", judge::markdown_of(c)}});
  print(c, a);
  return c.has_defects() || (a.strict && c.is_undecided()) ? promise_broken : success;
}

}  // namespace

void add_judge(CommandLine& line, const std::string& command_line) {
  Command command = line.command("judge", "compare your own code with the truth, and write a certificate");
  auto a = std::make_shared<Arguments>();
  a->command_line = command_line;
  command
      .option("code", a->code,
              "NAME=WHAT: a library (./libmine.so) that defines the functions of cageproof_judge.h, or a command "
              "('./my_program') that answers lines of eval")
      .taking("NAME=WHAT");
  Option formula =
      command
          .option("--formula,--formulas", a->formulas, "formulas to judge; if not given, all that the code says it has")
          .taking("FORMULAS");
  Option kind =
      command
          .option(
              "--kind", a->kind,
              "coordinates of whole cages instead: mean_value, green or another kind with numbers for coordinates; or "
              "inside, for sides: 1 inside, 0 on the cage, -1 outside")
          .taking("KIND")
          .excludes(formula);
  command
      .option("--dimension", a->dimension, "dimension of the cages: 3, triangles in space, or 2, polygons in the plane")
      .in_range(2, 3)
      .showing_default()
      .needs(kind);
  command.option("--regimes,--regime", a->options.regimes, "regimes, which say where points lie relative to elements")
      .taking("REGIMES")
      .showing_default();
  command.option("--scalar", a->scalar, "number type of the questions").one_of({"double", "float"}).showing_default();
  command.heading("How much");
  command
      .option("--samples", a->options.samples,
              "samples of each formula in each regime; an eighth of them where the truth is a costly integral")
      .in_range(1, 1000000)
      .showing_default();
  command.option("--seed", a->options.seed, "64-bit seed of all samples").showing_default();
  command.option("--jobs", a->options.jobs, "threads for the truths; 0: one per core")
      .in_range(0, 1024)
      .showing_default();
  command.heading("The code's own promise");
  Option promise = command.option("--promise", a->promise, "the largest error that the code promises, such as 1e-10")
                       .in_range(0.0, 1e300);
  command
      .option("--measure", a->measure,
              "kind of error that the promise bounds; conditioned errors are relative to the truth plus the cost of "
              "rounding the input")
      .one_of({"relative", "absolute", "conditioned"})
      .showing_default()
      .needs(promise);
  command.heading("Limits of its process");
  command.option("--seconds", a->limits.seconds, "seconds without an answer after which the code counts as hanging")
      .in_range(0.01, 3600.0)
      .showing_default();
  command.option("--memory", a->memory, "address space in GB").in_range(0.01, 1024.0).showing_default();
  command.heading("Output");
  command.option("--out", a->out, "a folder for certificate.json and certificate.md, or for --template")
      .taking("FOLDER");
  command.flag("--inputs", a->inputs, "show each row's worst input, as a line of eval");
  std::vector<std::string> languages;
  for (const std::string_view language : judge::template_languages()) languages.emplace_back(language);
  command
      .option("--template", a->language,
              "write an example in this language to begin with, of --formula or --kind if given")
      .one_of(languages);
  command.flag("--strict", a->strict, "exit with 1 also if a regime has no measured sample, or a declined one");
  add_quiet(command);
  command.example("cageproof judge mine=./libmine.so --out certificate");
  command.example("cageproof judge mine='python3 mine.py' --formula triangle.solid_angle --promise 1e-10");
  command.example("cageproof judge mine='python3 mine.py' --kind mean_value");
  command.example("cageproof judge mine='python3 mine.py' --kind mean_value --dimension 2");
  command.example("cageproof judge --template c --out example");
  command.runs([a] { return run(*a); });
}

}  // namespace cageproof::cli
