// SPDX-License-Identifier: MIT
#include "commands.h"
#include "json_line.h"
#include "query_numbers.h"

#include "cageproof/core/input_error.h"
#include "cageproof/core/numbers/scalar_text.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iostream>

namespace cageproof::cli {
namespace {

struct EvalOptions {
  std::string formula, evaluation, scalar = "double";
  int order = 0;
  bool allow_invalid_quads = false;
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
std::string evaluated(const QueryText& text, const Formula& formula, const Evaluation& evaluation, int order) {
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
  return line + '}';
}

int run(const EvalOptions& options) {
  const Formula& formula = formula_named(options.formula);
  check_allows_invalid_quads(options.allow_invalid_quads, formula);
  const Evaluation evaluation = evaluation_named(options.formula, options.evaluation);
  const ScalarKind scalar = *scalar_named(options.scalar);
  if (!evaluation.supports(scalar) || options.order > evaluation.max_order())
    throw InputError(fmt::format("{} of {} does not exist in {} at order {}", options.evaluation, options.formula,
                                 options.scalar, options.order));
  int code = success;
  std::size_t number = 0;
  for (std::string line; std::getline(std::cin, line);) {
    ++number;
    if (line.find_first_not_of(" \t\r") == std::string::npos) continue;
    try {
      const QueryText query = parse_query(line, formula);
      if (!options.allow_invalid_quads) require_valid_quad(query, formula);
      else if (const auto reason = invalid_quad(query, formula))
        fmt::print(stderr, "warning: line {}: {}\n", number, *reason);
      std::cout << with_scalar(scalar, [&]<Scalar R>() {
        return evaluated<R>(query, formula, evaluation, options.order);
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
  command.option("--formula", options->formula, "a formula of the catalogue").taking("FORMULA").required();
  command.option("--evaluation", options->evaluation, "one of its evaluations").taking("EVALUATION").required();
  command.option("--order", options->order, "0 value, 1 and gradient, 2 and Hessian").in_range(0, 2).showing_default();
  command.option("--scalar", options->scalar, "what it computes in: mp50 is 50 digits")
      .one_of({"float", "double", "mp50", "mp100", "mp200"})
      .showing_default();
  command.flag("--allow-invalid-quads", options->allow_invalid_quads, allow_invalid_quads_text);
  command.example(
      "echo '{\"element\":[[0,0,0],[1,0,0],[0,1,0]],\"point\":[0.25,0.25,\"0x1p-4\"]}' | "
      "cageproof eval --formula triangle.solid_angle --evaluation closed_form --order 1");
  command.runs([options] { return run(*options); });
}

}  // namespace cageproof::cli
