// SPDX-License-Identifier: MIT
#include "commands.h"
#include "json_line.h"
#include "query_numbers.h"

#include "cageproof/core/catalogue/steps.h"
#include "cageproof/core/input_error.h"
#include "cageproof/core/numbers/scalar_text.h"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>
#include <iostream>
#include <map>
#include <tuple>

namespace cageproof::cli {
namespace {

struct EvalOptions {
  std::string formula, evaluation, scalar = "double";
  int order = 0;
  bool allow_invalid_quads = false, steps = false;
};

// float and double as JSON numbers in shortest form; multiprecision, NaN and infinity as strings.
template <Scalar R>
std::string array_text(const std::vector<R>& values) {
  std::string text = "[";
  for (const R& x : values) {
    using std::isfinite;
    if (text.size() > 1) text += ',';
    const std::string number = format_scalar(x);
    text += is_multiprecision<R> || !isfinite(x) ? '"' + number + '"' : number;
  }
  return text + ']';
}

// Radii about the numbers as they are printed, which are rounded to decimals once more.
template <Scalar R>
std::vector<R> radii_of_text(const std::vector<R>& values, std::vector<R> radii) {
  using std::abs, std::isfinite;
  R half_digit = unit_roundoff<R>(), least = 0;
  if constexpr (is_multiprecision<R>) half_digit = 5 * pow(R(10), -std::numeric_limits<R>::max_digits10);
  else least = std::numeric_limits<R>::denorm_min();
  for (std::size_t i = 0; i < radii.size(); ++i)
    if (isfinite(radii[i]) && isfinite(values[i]))
      radii[i] = (radii[i] + abs(values[i]) * half_digit + least) * (1 + 8 * half_digit);
  return radii;
}

template <Scalar R>
std::string steps_text(const std::vector<Step<R>>& steps) {
  std::string text;
  for (const Step<R>& step : steps)
    text += fmt::format("{}{{\"name\":\"{}\",\"source\":\"{}\",\"length\":{},\"values\":{}}}", text.empty() ? "" : ",",
                        step.name, step.source, step.length, array_text(step.values));
  return ",\"steps\":[" + text + ']';
}

template <Scalar R>
std::string evaluated(const QueryText& text, const Formula& formula, const Evaluation& evaluation, int order,
                      const StepFunctions* steps) {
  const QueryNumbers<R> numbers(text, formula);
  Result<R> result;
  evaluation(numbers.query(order), result);
  std::string line = "{\"value\":" + array_text(result.value);
  if (order >= 1) line += ",\"gradient\":" + array_text(result.gradient);
  if (order >= 2) line += ",\"hessian\":" + array_text(result.hessian);
  constexpr std::array<const char*, 3> radius_keys{"value_radius", "gradient_radius", "hessian_radius"};
  for (int o = 0; o <= order; ++o)
    if (!result.radius_of(o).empty())
      line += fmt::format(",\"{}\":{}", radius_keys[o], array_text(radii_of_text(result.of(o), result.radius_of(o))));
  // Rounded down: 15.95 digits are not 16.
  if (!std::isnan(result.stated_digits))
    line += fmt::format(",\"stated_digits\":{:.1f}", std::max(0., std::floor(10 * result.stated_digits) / 10));
  if (!result.converged) line += ",\"converged\":false";
  if (steps != nullptr) line += steps_text(steps->of<R>()(numbers.query(0)));
  return line + '}';
}

// The evaluation of the formulas that lines ask for, each found once.
class Evaluations {
 public:
  explicit Evaluations(const EvalOptions& options) : options_(options) {}

  // The evaluation, order and scalar of a line: its own members, or else the options. \throws InputError where there is
  // no such evaluation
  struct Asked {
    Evaluation evaluation;
    ScalarKind scalar = ScalarKind::Double;
    int order = 0;
    std::optional<StepFunctions> steps = {};  // of --steps
  };
  const Asked& of(const LineOptions& line) {
    const std::string& formula = line.formula.empty() ? options_.formula : line.formula;
    if (formula.empty()) throw InputError("which formula? Give --formula, or a member \"formula\" in each line");
    if (!options_.formula.empty() && formula != options_.formula)
      throw InputError(fmt::format("\"formula\" is {}, --formula {}", formula, options_.formula));
    const std::string scalar = line.scalar.empty() ? options_.scalar : line.scalar;
    const int order = line.order.value_or(options_.order);
    const std::tuple key(formula, scalar, order);
    if (const auto found = known_.find(key); found != known_.end()) return found->second;
    formula_named(formula);
    const auto kind = scalar_named(scalar);
    if (!kind) throw InputError(fmt::format("\"scalar\": '{}' is none of float, double, mp50, mp100, mp200", scalar));
    Asked asked{evaluation_named(formula, options_.evaluation), *kind, order};
    if (!asked.evaluation.supports(*kind) || order > asked.evaluation.max_order())
      throw InputError(
          fmt::format("{} of {} does not exist in {} at order {}", options_.evaluation, formula, scalar, order));
    if (options_.steps) asked.steps = steps_of(formula, options_.evaluation);
    return known_.emplace(key, std::move(asked)).first->second;
  }

 private:
  const EvalOptions& options_;
  std::map<std::tuple<std::string, std::string, int>, Asked> known_;
};

// What `judge` asks a program first: the formulas, each with its highest derivative in double.
std::string description(const EvalOptions& options) {
  nlohmann::ordered_json formulas = nlohmann::ordered_json::object();
  bool has_float = true;
  for (const Formula& formula : catalogue()) {
    if (!options.formula.empty() && formula.name != options.formula) continue;
    const auto evaluation = EvaluationRegister::instance().find(formula.name, options.evaluation);
    if (!evaluation || !evaluation->supports<double>()) continue;
    formulas[std::string(formula.name)] = evaluation->max_order();
    has_float = has_float && evaluation->supports<float>();
  }
  return nlohmann::ordered_json{{"formulas", formulas},
                                {"float", has_float},
                                {"about", fmt::format("cageproof {}, {}", CAGEPROOF_VERSION, options.evaluation)}}
      .dump();
}

int run(const EvalOptions& options) {
  Evaluations evaluations(options);
  // Errors in the options are found before any line is read.
  if (!options.formula.empty()) {
    check_allows_invalid_quads(options.allow_invalid_quads, formula_named(options.formula));
    evaluations.of({});
  }
  int code = success;
  std::size_t number = 0;
  for (std::string line; std::getline(std::cin, line);) {
    ++number;
    if (line.find_first_not_of(" \t\r") == std::string::npos) continue;
    if (asks_for_description(line)) {
      std::cout << description(options) << '\n';
      continue;
    }
    try {
      const Evaluations::Asked* asked = nullptr;
      const QueryText query = parse_query(line, [&](const LineOptions& own) -> const Formula& {
        asked = &evaluations.of(own);
        return asked->evaluation.formula();
      });
      const Formula& formula = asked->evaluation.formula();
      if (!options.allow_invalid_quads) require_valid_quad(query, formula);
      else if (const auto reason = invalid_quad(query, formula))
        fmt::print(stderr, "warning: line {}: {}\n", number, *reason);
      std::cout << with_scalar(asked->scalar, [&]<Scalar R>() {
        return evaluated<R>(query, formula, asked->evaluation, asked->order, asked->steps ? &*asked->steps : nullptr);
      }) << '\n';
    } catch (const InputError& e) {
      std::cout << error_line(e.what(), number) << '\n';
      code = bad_input;
    }
  }
  if (std::cin.bad() || std::ferror(stdin) != 0) throw InputError("cannot read standard input");
  return code;
}

}  // namespace

void add_eval(CommandLine& line) {
  Command command = line.command("eval", "evaluate JSON lines from standard input");
  auto options = std::make_shared<EvalOptions>();
  command.option("--formula", options->formula, "a formula of the catalogue; if not given, each line names its own")
      .taking("FORMULA");
  command.option("--evaluation", options->evaluation, "an evaluation of the formula").taking("EVALUATION").required();
  command.option("--order", options->order, "0: value; 1: also the gradient; 2: also the Hessian")
      .in_range(0, 2)
      .showing_default();
  command.option("--scalar", options->scalar, "number type of the computation; mp50 has 50 digits")
      .one_of({"float", "double", "mp50", "mp100", "mp200"})
      .showing_default();
  command.flag(
      "--steps", options->steps,
      "add intermediate results with their equations' numbers; for riemann-<n> of quad.mean_value and its variants");
  command.flag("--allow-invalid-quads", options->allow_invalid_quads, allow_invalid_quads_text);
  command.example(
      "echo '{\"element\":[[0,0,0],[1,0,0],[0,1,0]],\"point\":[0.25,0.25,\"0x1p-4\"]}' | "
      "cageproof eval --formula triangle.solid_angle --evaluation closed_form --order 1");
  command.runs([options] { return run(*options); });
}

}  // namespace cageproof::cli
