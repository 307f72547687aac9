// SPDX-License-Identifier: MIT
#include "cageproof/core/catalogue/named_parameters.h"

#include "cageproof/core/input_error.h"
#include "cageproof/core/catalogue/unknown_name.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace cageproof {
namespace {

InputError wrong_parameter(const ParameterOwner& owner, std::string_view text, std::string_view why) {
  return InputError(fmt::format("{} {}: {}", owner.word, text, why));
}

std::string meant(std::string_view name, const std::vector<std::string_view>& known) {
  const std::string_view nearest = nearest_name(name, known);
  return nearest.empty() ? "" : fmt::format("; did you mean '{}'?", nearest);
}

// Open bounds below zero by the least double there is allow zero.
std::string lowest_text(double lowest) {
  return lowest == -std::numeric_limits<double>::denorm_min() ? "0 <=" : fmt::format("{} <", lowest);
}

// One value, of a parameter that `text` names.
double value_in(std::string_view text, std::string_view after, const KindParameter& parameter,
                const ParameterOwner& owner) {
  const std::optional<double> value = parameter.value_of(after);
  if (!value && !parameter.names.empty())
    throw wrong_parameter(
        owner, text,
        fmt::format("'{}' is none of {}{}", after, fmt::join(parameter.names, ", "), meant(after, parameter.names)));
  if (!value) throw wrong_parameter(owner, text, fmt::format("'{}' is not a number", after));
  // Infinity is written "inf".
  if (std::isinf(*value) && !after.ends_with("inf"))
    throw wrong_parameter(owner, text, fmt::format("{} is beyond the range of a double", after));
  if (!parameter.allows(*value))
    throw wrong_parameter(
        owner, text,
        fmt::format("{} is out of range for {}, {} {} {} {}{}{}", after, owner.name, lowest_text(parameter.lowest),
                    parameter.name, parameter.includes_highest ? "<=" : "<", parameter.highest,
                    parameter.includes_infinity ? ", or infinite" : "", parameter.whole ? ", a whole number" : ""));
  return *value;
}

// The parameter that a text "name=value" names, and the value's text.
std::pair<std::size_t, std::string_view> named_in(const std::string& text, const std::vector<KindParameter>& known,
                                                  const ParameterOwner& owner) {
  const auto equals = text.find('=');
  const std::string_view name = std::string_view(text).substr(0, equals);
  const auto found = std::ranges::find(known, name, &KindParameter::name);
  if (known.empty()) throw wrong_parameter(owner, text, fmt::format("{} has no parameters", owner.name));
  if (found == known.end()) {
    std::vector<std::string_view> names;
    names.reserve(known.size());
    for (const KindParameter& p : known) names.push_back(p.name);
    throw wrong_parameter(owner, text,
                          fmt::format("{} has only {}{}", owner.name, fmt::join(names, ", "), meant(name, names)));
  }
  if (equals == std::string::npos) throw wrong_parameter(owner, text, fmt::format("write {}=value", text));
  return {found - known.begin(), std::string_view(text).substr(equals + 1)};
}

// The values of each parameter, one or, where lists are taken, several between commas.
std::vector<std::vector<double>> lists_of(const std::vector<std::string>& given,
                                          const std::vector<KindParameter>& known, const ParameterOwner& owner,
                                          bool takes_lists) {
  std::vector<std::vector<double>> lists(known.size());
  for (const std::string& text : given) {
    auto [which, values] = named_in(text, known, owner);
    if (!lists[which].empty()) throw wrong_parameter(owner, text, fmt::format("{} is given twice", known[which].name));
    for (auto comma = values.find(','); takes_lists && comma != std::string_view::npos; comma = values.find(',')) {
      lists[which].push_back(value_in(text, values.substr(0, comma), known[which], owner));
      values.remove_prefix(comma + 1);
    }
    lists[which].push_back(value_in(text, values, known[which], owner));
  }
  for (std::size_t i = 0; i < known.size(); ++i)
    if (lists[i].empty()) lists[i] = {known[i].preset};
  return lists;
}

}  // namespace

std::vector<KindParameter> parameters_of(const Formula& formula) {
  std::vector<KindParameter> found;
  found.reserve(formula.parameters.size());
  for (const Parameter& p : formula.parameters) found.push_back({p});
  return found;
}

std::vector<std::string> parameter_texts(const std::vector<std::pair<std::string, std::string>>& given) {
  std::vector<std::string> texts;
  texts.reserve(given.size());
  for (const auto& [name, value] : given) texts.push_back(fmt::format("{}={}", name, value));
  return texts;
}

std::vector<double> parameter_values(const std::vector<std::string>& given, const std::vector<KindParameter>& known,
                                     const ParameterOwner& owner) {
  std::vector<double> values;
  values.reserve(known.size());
  for (const auto& list : lists_of(given, known, owner, false)) values.push_back(list.front());
  return values;
}

std::vector<std::vector<double>> parameter_sets(const std::vector<std::string>& given,
                                                const std::vector<KindParameter>& known, const ParameterOwner& owner) {
  const std::vector<std::vector<double>> lists = lists_of(given, known, owner, true);
  constexpr double most_sets = 10'000;
  double wanted = 1;
  for (const std::vector<double>& list : lists) wanted *= static_cast<double>(list.size());
  if (wanted > most_sets)
    throw InputError(
        fmt::format("{}: {:.0f} combinations of values, {:.0f} are the most", owner.word, wanted, most_sets));
  std::vector<std::vector<double>> sets{{}};
  for (const std::vector<double>& list : lists) {
    std::vector<std::vector<double>> longer;
    longer.reserve(sets.size() * list.size());
    for (const std::vector<double>& set : sets)
      for (const double value : list) {
        longer.push_back(set);
        longer.back().push_back(value);
      }
    sets = std::move(longer);
  }
  return sets;
}

}  // namespace cageproof
