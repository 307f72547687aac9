// SPDX-License-Identifier: MIT
#include "commands.h"

#include "cageproof/core/unknown_name.h"
#include "cageproof/core/scalar_text.h"
#include "cageproof/reports/worst_file.h"
#include "cageproof/validation/hunt.h"
#include "cageproof/validation/promise.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <unistd.h>

namespace cageproof::cli {
namespace {

using validation::HuntedCase;
using validation::HuntResult;

struct Arguments {
  std::string formula, evaluation, scalar = "double", out;
  std::vector<std::string> checks;
  validation::HuntOptions options;
};

// Without --check: the promised error, and the plain relative one of evaluations that are asked for it.
std::vector<const validation::Check*> chosen_checks(const Arguments& a) {
  std::vector<const validation::Check*> chosen;
  for (const std::string& name : a.checks) {
    chosen.push_back(validation::find_check(name));
    if (!chosen.back()) throw unknown_name("check", name);
  }
  if (!chosen.empty()) return chosen;
  chosen.push_back(validation::find_check("truth"));
  const validation::Check* relative = validation::find_check("relative");
  if (relative &&
      relative->applies(*a.options.formula, a.options.evaluation, a.options.scalar, validation::hunted_regime))
    chosen.push_back(relative);
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

reports::WorstLine line_of(const Arguments& a, const HuntedCase& found, const std::optional<double>& bound) {
  reports::WorstLine line;
  line.subject = a.formula;
  line.evaluation = a.evaluation;
  line.scalar = a.scalar;
  line.regime = validation::hunted_regime;
  line.check = a.options.check->name();
  line.order = a.options.order;
  line.unit = a.options.check->unit();
  line.bound = bound;
  line.flags = {line.regime, std::string(found.regime)};
  line.provenance = fmt::format("hunt from {}, seed {}, budget {}", found.regime, a.options.seed, a.options.budget);
  line.worst = found.worst;
  return line;
}

// Hunts one check; returns whether what was found breaks a promise.
bool hunt_one(const Arguments& a, std::vector<reports::WorstLine>& lines) {
  const auto& options = a.options;
  const auto promise = validation::promise_for(
      {options.check->name(), a.formula, a.evaluation, a.scalar, validation::hunted_regime, options.order});
  const HuntResult result = validation::hunt(options);
  const auto head =
      fmt::format("{} {} {} {} order {}", a.formula, a.evaluation, a.scalar, options.check->name(), options.order);
  const auto tail = fmt::format("{} evaluations, {} without truth, {} declined", result.evaluations,
                                result.without_truth, result.declined);
  const HuntedCase& worst = result.worst.front();
  const bool broken = promise.bound && worst.worst.error > *promise.bound;
  const std::string verdict =
      !promise.bound ? "not promised" : fmt::format("promised {}: {}", *promise.bound, broken ? "BROKEN" : "kept");
  fmt::print("{}: largest found {} {}, {}; {}; from {}; {}; {}\n", head, format_scalar(worst.worst.error),
             options.check->unit(), verdict, input_text(*options.formula, worst.worst), worst.regime,
             confirmation(worst), tail);
  for (const HuntedCase& found : result.worst) lines.push_back(line_of(a, found, promise.bound));
  return broken;
}

int run(Arguments& a) {
  auto& options = a.options;
  options.formula = &formula_named(a.formula);
  options.evaluation = evaluation_named(a.formula, a.evaluation);
  options.scalar = *scalar_named(a.scalar);
  if (isatty(STDERR_FILENO) != 0)
    options.improved = [&](const WorstCase& worst, std::string_view regime) {
      fmt::print(stderr, "{} order {} from {}: {:.4g} at {}\n", options.check->name(), options.order, regime,
                 worst.error, input_text(*options.formula, worst));
    };
  // A file that cannot be added to is known before the search, not after.
  if (!a.out.empty()) reports::merge_worst(a.out, {}, options.keep);
  bool broken = false;
  std::vector<reports::WorstLine> lines;
  for (const validation::Check* check : chosen_checks(a)) {
    options.check = check;
    broken = hunt_one(a, lines) || broken;
  }
  if (!a.out.empty()) reports::merge_worst(a.out, lines, options.keep);
  return broken ? promise_broken : success;
}

}  // namespace

void add_hunt(CommandLine& line) {
  Command command = line.command("hunt", "search for the worst input of one evaluation");
  auto a = std::make_shared<Arguments>();
  command.option("--formula", a->formula, "name of a formula").required();
  command.option("--evaluation", a->evaluation, "name of an evaluation").required();
  command.option("--budget", a->options.budget, "inputs to measure, a check").required().in_range(1, 1000000000);
  command.option("--order", a->options.order, "derivative order asked and looked at").in_range(0, 2).showing_default();
  command.option("--scalar", a->scalar, "scalar").one_of({"double", "float"}).showing_default();
  command.option("--check", a->checks, "whose error; default: truth, and relative where it is asked");
  command.option("--regime", a->options.regimes, "glob: where climbs start").showing_default();
  command.option("--seed", a->options.seed, "64-bit seed").showing_default();
  command.option("--jobs", a->options.jobs, "threads; 0: all cores").in_range(0, 1024).showing_default();
  command.option("--out", a->out, "worst-case file to add the worst cases to");
  command.runs([a] { return run(*a); });
}

}  // namespace cageproof::cli
