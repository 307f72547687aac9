// SPDX-License-Identifier: MIT
#include "commands.h"
#include "judge_option.h"
#include "progress.h"

#include "cageproof/core/input_error.h"
#include "cageproof/core/catalogue/name_pattern.h"
#include "cageproof/core/numbers/scalar_text.h"
#include "cageproof/reports/checked_file.h"
#include "cageproof/reports/worst_file.h"
#include "cageproof/validation/hunt.h"
#include "cageproof/validation/promise.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <filesystem>

namespace cageproof::cli {
namespace {

using validation::HuntedCase;
using validation::HuntObjective;
using validation::HuntResult;

struct Arguments {
  std::string formula, scalar = "double", out;
  std::vector<std::string> evaluations, checks;
  validation::HuntOptions options;
  JudgeOption judge;
};

std::optional<double> bound_of(const Arguments& a, const HuntObjective& objective) {
  return validation::promise_for({objective.check->name(), a.formula, objective.evaluation.name(), a.scalar,
                                  validation::hunted_regime, a.options.order})
      .bound;
}

// Whether a list of names and globs has the check. by_glob: only by globs, which leave out checks that are not asked.
bool names_check(const Arguments& a, std::string_view check, bool& by_glob) {
  bool named = false;
  by_glob = true;
  for (const std::string& list : a.checks)
    for (const std::string& name : names_in(list)) {
      if (!matches(name, check)) continue;
      named = true;
      by_glob = by_glob && is_glob(name);
    }
  return named;
}

// The checks of an evaluation that are named. Without names they are the promised error, and, for evaluations that
// promise digits, the digits left.
std::vector<const validation::Check*> checks_of(const Arguments& a, const Evaluation& evaluation) {
  std::vector<const validation::Check*> chosen;
  for (const auto& check : validation::checks()) {
    bool by_glob = false;
    if (!names_check(a, check->name(), by_glob)) continue;
    if (!by_glob || check->applies(*a.options.formula, evaluation, a.options.scalar, validation::hunted_regime))
      chosen.push_back(check.get());
  }
  if (!chosen.empty()) return chosen;
  chosen.push_back(validation::find_check("truth"));
  for (const std::string_view name : {"relative", "digits"}) {
    const validation::Check* check = validation::find_check(name);
    if (check->applies(*a.options.formula, evaluation, a.options.scalar, validation::hunted_regime))
      chosen.push_back(check);
  }
  return chosen;
}

// Everything that is promised of the formula in this scalar and order: checks against the truth, and of what
// evaluations state about themselves.
std::vector<HuntObjective> promised_objectives(const Arguments& a) {
  std::vector<HuntObjective> found;
  for (const std::string& name : EvaluationRegister::instance().standard(a.formula)) {
    const Evaluation evaluation = evaluation_named(a.formula, name);
    if (!evaluation.supports(a.options.scalar) || a.options.order > evaluation.max_order()) continue;
    for (const std::string_view check_name : {"truth", "relative", "digits", "stated_error"}) {
      const HuntObjective objective{evaluation, validation::find_check(check_name)};
      bool by_glob = false;
      const bool asked = a.checks.empty() || names_check(a, check_name, by_glob);
      if (asked && bound_of(a, objective) &&
          objective.check->applies(*a.options.formula, evaluation, a.options.scalar, validation::hunted_regime))
        found.push_back(objective);
    }
  }
  if (found.empty())
    throw InputError(fmt::format("nothing of {} is promised in {} at order {}; name an evaluation with --evaluation",
                                 a.formula, a.scalar, a.options.order));
  return found;
}

std::vector<HuntObjective> objectives_of(const Arguments& a) {
  for (const std::string& list : a.checks) require_known("check", list, validation::check_names());
  if (a.evaluations.empty()) return promised_objectives(a);
  const std::vector<std::string> known = EvaluationRegister::instance().standard(a.formula);
  std::vector<std::string> names;
  const auto add = [&](const std::string& name) {
    if (std::ranges::find(names, name) == names.end()) names.push_back(name);
  };
  for (const std::string& list : a.evaluations)
    for (const std::string& name : names_in(list)) {
      if (!is_glob(name)) add(name);
      else require_known(fmt::format("evaluation of {}", a.formula), name, {known.begin(), known.end()});
      for (const std::string& one : known) {
        const Evaluation evaluation = evaluation_named(a.formula, one);
        if (is_glob(name) && matches(name, one) && evaluation.supports(a.options.scalar) &&
            a.options.order <= evaluation.max_order())
          add(one);
      }
    }
  std::vector<HuntObjective> chosen;
  for (const std::string& name : names) {
    const Evaluation evaluation = evaluation_named(a.formula, name);
    for (const validation::Check* check : checks_of(a, evaluation)) chosen.push_back({evaluation, check});
  }
  return chosen;
}

std::string input_text(const Formula& formula, const WorstCase& worst) {
  const auto hex = [&](const Vec3<double>& p) {
    std::vector<std::string> coordinates;
    coordinates.reserve(3);
    for (int c = 0; c < formula.dim(); ++c) coordinates.push_back(fmt::format("\"{}\"", format_hex(p[c])));
    return fmt::format("[{}]", fmt::join(coordinates, ","));
  };
  std::vector<std::string> corners, parameters;
  corners.reserve(worst.corners.size());
  parameters.reserve(worst.parameters.size());
  for (const auto& corner : worst.corners) corners.push_back(hex(corner));
  for (std::size_t k = 0; k < worst.parameters.size(); ++k)
    parameters.push_back(fmt::format("\"{}\":\"{}\"", formula.parameters[k].name, format_hex(worst.parameters[k])));
  return fmt::format("{{\"element\":[{}],\"point\":{},\"parameters\":{{{}}}}}", fmt::join(corners, ","),
                     hex(worst.point), fmt::join(parameters, ","));
}

std::string confirmation(const HuntedCase& found) {
  if (!found.against_integral) return "the integral has no 30 digits here";
  return *found.against_integral <= 1e-30
             ? "truth confirmed by the integral"
             : fmt::format("TRUTH {} FROM THE INTEGRAL", format_scalar(*found.against_integral));
}

reports::WorstLine line_of(const Arguments& a, const HuntObjective& objective, const HuntedCase& found) {
  reports::WorstLine line;
  line.subject = a.formula;
  line.evaluation = objective.evaluation.name();
  line.scalar = a.scalar;
  line.setting = validation::hunted_regime;
  line.check = objective.check->name();
  line.order = a.options.order;
  line.unit = objective.check->unit();
  line.bound = bound_of(a, objective);
  line.flags = {line.setting, std::string(found.regime)};
  line.provenance = fmt::format("hunt from {}, seed {}, budget {}", found.regime, a.options.seed, a.options.budget);
  line.worst = found.worst;
  return line;
}

// Prints the findings for one objective; returns whether it breaks a promise.
bool print(const Arguments& a, const HuntObjective& objective, const HuntResult& result) {
  const auto head = fmt::format("{} {} {} {} order {}", a.formula, objective.evaluation.name(), a.scalar,
                                objective.check->name(), a.options.order);
  const auto tail = fmt::format("{} evaluations, {} without truth, {} declined", result.evaluations,
                                result.without_truth, result.declined);
  if (result.worst.empty()) {
    fmt::print("{}: nothing measured; {}\n", head, tail);
    return false;
  }
  const std::optional<double> bound = bound_of(a, objective);
  const HuntedCase& worst = result.worst.front();
  const bool broken = bound && worst.worst.error > *bound;
  const std::string verdict =
      !bound ? "not promised" : fmt::format("promised {}: {}", *bound, broken ? "BROKEN" : "kept");
  fmt::print("{}: largest found {} {}, {}; {}; from {}; {}; {}\n", head, format_scalar(worst.worst.error),
             objective.check->unit(), verdict, input_text(*a.options.formula, worst.worst), worst.regime,
             confirmation(worst), tail);
  return broken;
}

int run(Arguments& a) {
  auto& options = a.options;
  options.formula = &formula_named(a.formula);
  a.judge.begin(a.formula);
  options.scalar = *scalar_named(a.scalar);
  options.objectives = objectives_of(a);
  Progress progress;
  options.improved = [&](const HuntObjective& objective, const WorstCase& worst, std::string_view regime) {
    progress(fmt::format("{} {} order {} from {}: {:.4g} at {}", objective.evaluation.name(), objective.check->name(),
                         options.order, regime, worst.error, input_text(*options.formula, worst)));
  };
  // A file that cannot be added to is known before the search, not after.
  if (!a.out.empty()) {
    reports::require_writable({a.out});
    if (std::filesystem::exists(a.out) && !std::filesystem::is_regular_file(a.out))
      throw InputError(fmt::format("--out {}: not a file of worst cases, to which others can be added", a.out));
    reports::merge_worst(a.out, {}, options.keep);
  }
  const std::vector<HuntResult> results = validation::hunt(options);
  bool broken = false;
  std::vector<reports::WorstLine> lines;
  for (std::size_t k = 0; k < results.size(); ++k) {
    broken = print(a, options.objectives[k], results[k]) || broken;
    for (const HuntedCase& found : results[k].worst) lines.push_back(line_of(a, options.objectives[k], found));
  }
  if (!a.out.empty()) reports::merge_worst(a.out, lines, options.keep);
  return broken ? promise_broken : success;
}

}  // namespace

void add_hunt(CommandLine& line) {
  Command command = line.command("hunt", "search for the worst inputs of evaluations");
  auto a = std::make_shared<Arguments>();
  command.option("--formula", a->formula, "a formula of the catalogue").taking("FORMULA").required();
  command
      .option("--evaluation,--evaluations", a->evaluations,
              "evaluations whose errors are searched; if not given, all with a promise")
      .taking("EVALUATIONS");
  command.option("--budget", a->options.budget, "number of inputs to measure, each by all evaluations and checks")
      .required()
      .in_range(1, 1000000000);
  command.option("--order", a->options.order, "0: value; 1: gradient; 2: Hessian").in_range(0, 2).showing_default();
  command.option("--scalar", a->scalar, "scalar").one_of({"double", "float"}).showing_default();
  command.option("--check,--checks", a->checks, "checks whose errors are searched; if not given, those with a promise")
      .taking("CHECKS");
  command.option("--regime,--regimes", a->options.regimes, "regimes where the search starts")
      .taking("REGIMES")
      .showing_default();
  command.option("--seed", a->options.seed, "64-bit seed").showing_default();
  command.option("--jobs", a->options.jobs, "threads; 0: one per core").in_range(0, 1024).showing_default();
  command.option("--out", a->out, "file of worst cases to which the worst are added").taking("FILE");
  a->judge.add_to(command);
  add_quiet(command);
  command.example(
      "cageproof hunt --formula triangle.solid_angle --evaluation closed_form --budget 1000 --out worst.jsonl");
  command.runs([a] { return run(*a); });
}

}  // namespace cageproof::cli
