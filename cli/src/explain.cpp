// SPDX-License-Identifier: MIT
#include "commands.h"
#include "query_numbers.h"

#include "cageproof/closed_form/explain.h"
#include "cageproof/core/catalogue/named_parameters.h"
#include "cageproof/validation/truth.h"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>
#include <iostream>

namespace cageproof::cli {
namespace {

using Json = nlohmann::ordered_json;
using closed_form::CountedLine;
using closed_form::Explanation;

constexpr double kUnit = 0x1p-53;

struct ExplainOptions {
  std::string formula, evaluation, element, point;
  std::vector<std::string> parameters;
  int order = 0, entry = -1, limit = 15;
  bool json = false, allow_invalid_quads = false;
};

// Figures that explain the error of the entry and of its tensor.
struct Account {
  Explanation explanation;
  std::string entry_name;
  bool has_truth = false;
  Mp100 truth;                            // of the entry
  double relative = 0;                    // error of the entry
  double conditioned = 0, plain = 0;      // of the tensor: conditioned units; digits lost of double's sixteen
  double form = 0, roundings = 0;         // in units: what the form is wrong by without roundings; sum of the roundings
  double unit = 1;                        // lines are scaled by it
  std::string unit_name = "conditioned";  // or "relative", of the tensor, where there is no truth
};

// "corner 1, row 0, column 2, d/dx d/dy".
std::string name_of_entry(const Formula& formula, int order, std::size_t entry) {
  const std::size_t derivatives = derivative_count(formula.dim(), order), component = entry / derivatives;
  const std::size_t entries = formula.shape.entries();
  std::string name;
  const auto add = [&name](const std::string& part) { name += (name.empty() ? "" : ", ") + part; };
  if (formula.shape.per_corner) add(fmt::format("corner {}", component / entries));
  if (entries > 1)
    add(fmt::format("row {}, column {}", component % entries / formula.shape.columns,
                    component % formula.shape.columns));
  std::string axes;
  for (std::size_t rest = entry % derivatives, o = 0; o < static_cast<std::size_t>(order); ++o) {
    axes = fmt::format("d/d{}{}{}", "xyz"[rest % formula.dim()], axes.empty() ? "" : " ", axes);
    rest /= formula.dim();
  }
  if (!axes.empty()) add(axes);
  return name.empty() ? "the value" : name;
}

double norm_of(const std::vector<double>& tensor) {
  double sum = 0;
  for (const double x : tensor) sum = std::hypot(sum, x);
  return sum;
}

Account account_of(const Formula& formula, std::string_view evaluation, const Query<double>& query,
                   std::optional<std::size_t> entry) {
  Account a;
  Result<double> result;
  a.explanation = closed_form::explain(formula, evaluation, query, entry, result);
  const Explanation& e = a.explanation;
  a.entry_name = name_of_entry(formula, query.order, e.entry);
  const validation::Sample sample{
      {query.corners.begin(), query.corners.end()}, query.point, {query.parameters.begin(), query.parameters.end()}};
  const validation::Truth truth = validation::truth_from(validation::truth_source(formula), sample, query.order);
  double unit = kUnit * norm_of(result.of(query.order));
  a.unit_name = "relative";
  if (truth.exists[query.order]) {
    a.has_truth = true;
    a.truth = truth.tensors.of(query.order)[e.entry];
    a.relative = static_cast<double>(Mp100(abs(Mp100(e.value) - a.truth) / abs(a.truth)));
    a.conditioned = validation::conditioned_error(result, truth, query.order, Mp100(kUnit));
    a.plain = std::log10(std::max(1., validation::relative_error(result, truth, query.order) / kUnit));
    const double size = static_cast<double>(truth.conditioned[query.order]) * kUnit;
    if (size > 0) {
      unit = size;
      a.unit_name = "conditioned";
    }
    if (e.is_the_value) a.form = static_cast<double>(Mp100(abs(Mp100(e.exact) - a.truth))) / unit;
  }
  if (unit > 0) a.unit = 1 / unit;
  for (const CountedLine& line : e.lines) a.roundings += a.unit * line.net;
  return a;
}

std::string place_of(const CountedLine& line) {
  return line.line > 0 ? fmt::format("{}:{}", line.file, line.line) : line.file;
}

// The first 25 digits.
std::string shortened(const Mp100& x) {
  const std::string text = format_scalar(x);
  const auto exponent = std::min(text.find('e'), text.size());
  return text.substr(0, std::min<std::size_t>(exponent, 25)) + text.substr(exponent);
}

// JSON has no infinities.
Json number(double x) { return std::isfinite(x) ? Json(x) : Json(format_scalar(x)); }

Json json_of(const Account& a, const ExplainOptions& options) {
  const Explanation& e = a.explanation;
  Json json = {
      {"formula", options.formula}, {"evaluation", options.evaluation}, {"order", options.order},
      {"entry", e.entry},           {"entry_name", a.entry_name},       {"form", e.route},
      {"value", number(e.value)},   {"counted", number(e.counted)},     {"counted_is_the_value", e.is_the_value}};
  if (a.has_truth) {
    json["truth"] = format_scalar(a.truth);
    json["relative_error"] = number(a.relative);
    json["conditioned_units"] = number(a.conditioned);
    json["digits_lost"] = number(a.plain);
  }
  json["operations"] = e.operations;
  json["unit"] = a.unit_name;
  json["roundings"] = number(a.roundings);
  if (a.has_truth && e.is_the_value) json["form_itself"] = number(a.form);
  json["lines"] = Json::array();
  for (const CountedLine& line : e.lines) {
    if (static_cast<int>(json["lines"].size()) == options.limit) break;
    json["lines"].push_back({{"lost", number(a.unit * line.lost)},
                             {"rounded", number(a.unit * line.rounded)},
                             {"net", number(a.unit * line.net)},
                             {"bits", line.bits},
                             {"before", number(line.before)},
                             {"after", number(line.after)},
                             {"count", line.count},
                             {"operation", line.operation},
                             {"file", line.file},
                             {"line", line.line}});
  }
  return json;
}

void print_text(const Account& a, const ExplainOptions& options) {
  constexpr std::array orders{"value", "gradient", "Hessian"};
  const Explanation& e = a.explanation;
  fmt::print("{} {}, {}, entry {}: {}\n", options.formula, options.evaluation, orders[options.order], e.entry,
             a.entry_name);
  fmt::print("  form    {}\n  value   {}\n", e.route, format_scalar(e.value));
  if (a.has_truth) {
    fmt::print("  truth   {}   relative error {:.2g}\n", shortened(a.truth), a.relative);
    fmt::print("  tensor  {:.3g} conditioned units, {:.1f} digits lost\n", a.conditioned, a.plain);
  } else {
    fmt::print("  truth   none: no limit exists here, or two precisions do not agree\n");
  }
  if (!e.is_the_value && !e.lines.empty())
    fmt::print("  what follows is of the form in double, which gave {} and was not taken\n", format_scalar(e.counted));
  if (e.lines.empty()) {
    fmt::print("no operation in double loses anything\n");
    return;
  }
  fmt::print("{} operations; their roundings sum up to {:.3g} {} units", e.operations, a.roundings, a.unit_name);
  if (a.has_truth && e.is_the_value) fmt::print(", the form without them is {:.3g} off", a.form);
  fmt::print("\n\n{:>9} {:>9} {:>9} {:>4} {:>9} {:>9} {:>7}  {:24} {}\n", "lost", "rounded", "net", "bits", "before",
             "after", "count", "operation", "where");
  int rows = 0;
  for (const CountedLine& line : e.lines) {
    if (rows++ == options.limit) break;
    fmt::print("{:9.3g} {:9.3g} {:9.3g} {:4} {:9.3g} {:9.3g} {:7}  {:24} {}\n", a.unit * line.lost,
               a.unit * line.rounded, a.unit * line.net, line.bits, line.before, line.after, line.count, line.operation,
               place_of(line));
  }
  if (e.lines.size() > static_cast<std::size_t>(options.limit))
    fmt::print("and {} lines more\n", e.lines.size() - options.limit);
}

// The first line of standard input that says something.
std::string next_line() {
  std::string line;
  while (line.find_first_not_of(" \t\r") == std::string::npos)
    if (!std::getline(std::cin, line))
      throw InputError("no input: give --element and --point, or a JSON line on standard input, as to eval");
  return line;
}

QueryText query_of(const ExplainOptions& options, const Formula& formula) {
  QueryText query = options.element.empty() ? parse_query(next_line(), formula)
                                            : parse_members(options.element, options.point, formula);
  if (!options.parameters.empty()) {
    query.parameters.clear();
    for (const double p : parameters_from(options.parameters, parameters_of(formula), formula.name))
      query.parameters.push_back(format_scalar(p));
  }
  return query;
}

int run(const ExplainOptions& options) {
  const Formula& formula = formula_named(options.formula);
  const auto recommended = EvaluationRegister::instance().with_role(formula.name, Role::Recommended);
  if (!recommended && options.evaluation.empty())
    throw InputError(fmt::format("{} has no recommended evaluation, which explain runs", formula.name));
  const std::string evaluation(options.evaluation.empty() ? recommended->name()
                                                          : evaluation_named(formula.name, options.evaluation).name());
  const auto explained = closed_form::explained_evaluations(formula.name);
  if (std::ranges::find(explained, evaluation) == explained.end())
    throw InputError(fmt::format(
        "{} of {} is not run in counted numbers: {}", evaluation, formula.name,
        explained.empty() ? "none of its evaluations is" : fmt::format("give {}", fmt::join(explained, " or "))));
  const QueryText query = query_of(options, formula);
  check_allows_invalid_quads(options.allow_invalid_quads, formula);
  if (!options.allow_invalid_quads) require_valid_quad(query, formula);
  const QueryNumbers<double> numbers(query, formula);
  const auto entry = options.entry < 0 ? std::nullopt : std::optional<std::size_t>(options.entry);
  const Account account = account_of(formula, evaluation, numbers.query(options.order), entry);
  ExplainOptions named = options;
  named.evaluation = evaluation;
  if (options.json) std::cout << json_of(account, named).dump(2) << '\n';
  else print_text(account, named);
  return success;
}

}  // namespace

void add_explain(CommandLine& line) {
  Command command = line.command("explain", "print which operations of a closed form lose how much, for one input");
  auto options = std::make_shared<ExplainOptions>();
  command.option("--formula", options->formula, "a formula of the catalogue").taking("FORMULA").required();
  command
      .option("--evaluation", options->evaluation,
              "closed_form or hybrid, for quads line_form; if not given, the recommended one")
      .taking("EVALUATION");
  Option element =
      command
          .option("--element", options->element,
                  "corners of the element, [[x,y,z],...]; if not given, a JSON line from standard input, as for eval")
          .taking("JSON");
  Option point = command.option("--point", options->point, "the point, [x,y,z]").taking("JSON");
  element.needs(point);
  point.needs(element);
  command.option("--parameter", options->parameters, "a parameter of the formula, mu=... or nu=...")
      .taking("NAME=VALUE");
  command.option("--order", options->order, "0 value, 1 gradient, 2 Hessian").in_range(0, 2).showing_default();
  command
      .option(
          "--entry", options->entry,
          "number of the tensor's entry, from 0, in the order of eval; if not given, the entry with the largest errors")
      .in_range(0, 1 << 20);
  command.option("--limit", options->limit, "number of lines of the table").in_range(1, 1 << 20).showing_default();
  command.flag("--allow-invalid-quads", options->allow_invalid_quads, allow_invalid_quads_text);
  command.flag("--json", options->json, "as JSON");
  command.example(
      "cageproof explain --formula triangle.solid_angle --element '[[0,0,0],[1,0,0],[0,1,0]]' --point "
      "'[0.25,0.25,1e-9]'");
  command.runs([options] { return run(*options); });
}

}  // namespace cageproof::cli
