// SPDX-License-Identifier: MIT
#include "commands.h"

#include "cageproof/core/embedded_cages.h"
#include "cageproof/core/input_error.h"
#include "cageproof/core/scalar_text.h"
#include "cageproof/core/unknown_name.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace cageproof::cli {

Option CageArguments::add_to(Command command, bool required) {
  Option cage =
      command
          .option(
              "--cage", file,
              "cage: a file (OBJ, PLY, STL, VTP; polygons: SVG, GeoJSON, OBJ, VTP), or the name of an embedded cage")
          .required(required)
          .taking("CAGE");
  command.flag("--flip-inward", flip_inward, "turn a cage whose normals point inward, a polygon that runs clockwise");
  command
      .option("--triangulate", triangulate,
              "how quads become triangles: shortest diagonal, or fan from the first corner")
      .one_of({"shortest", "fan"})
      .showing_default();
  return cage;
}

namespace {

std::string meant(std::string_view name, const std::vector<std::string_view>& known) {
  const std::string_view nearest = nearest_name(name, known);
  return nearest.empty() ? "" : fmt::format("; did you mean '{}'?", nearest);
}

}  // namespace

Cage CageArguments::load() const {
  const auto names = embedded_cage_names();
  if (is_embedded_cage(file)) return embedded_cage(file);
  if (std::filesystem::path(file).extension().empty() && !std::filesystem::exists(file))
    throw InputError(
        fmt::format("--cage {}: no such file, and no embedded cage of that name{} ({}, and extreme ones, "
                    "see `cageproof list`)",
                    file, meant(file, names), fmt::join(names, ", ")));
  Cage cage = read_cage(file, {.flip_inward = flip_inward, .allow_invalid_quads = allow_invalid_quads});
  if (const auto warning = crossing_warning(cage)) fmt::print(stderr, "warning: {}\n", *warning);
  return cage;
}

namespace {

// Open bounds below zero by the least double there is allow zero.
std::string lowest_text(double lowest) {
  return lowest == -std::numeric_limits<double>::denorm_min() ? "0 <=" : fmt::format("{} <", lowest);
}

// One value, of a parameter that `text` names.
double value_in(std::string_view text, std::string_view after, const KindParameter& parameter, std::string_view owner) {
  const std::optional<double> value = parameter.value_of(after);
  if (!value && !parameter.names.empty())
    throw InputError(fmt::format("--parameter {}: '{}' is none of {}{}", text, after, fmt::join(parameter.names, ", "),
                                 meant(after, parameter.names)));
  if (!value) throw InputError(fmt::format("--parameter {}: '{}' is not a number", text, after));
  if (!parameter.allows(*value))
    throw InputError(fmt::format("--parameter {}: {} is out of range for {}, {} {} {} {}{}{}", text, after, owner,
                                 lowest_text(parameter.lowest), parameter.name, parameter.includes_highest ? "<=" : "<",
                                 parameter.highest, parameter.includes_infinity ? ", or infinite" : "",
                                 parameter.whole ? ", a whole number" : ""));
  return *value;
}

// The parameter that a text "name=value" names, and the value's text.
std::pair<std::size_t, std::string_view> named_in(const std::string& text, const std::vector<KindParameter>& known,
                                                  std::string_view owner) {
  const auto equals = text.find('=');
  const auto found = std::ranges::find(known, std::string_view(text).substr(0, equals), &KindParameter::name);
  if (known.empty()) throw InputError(fmt::format("--parameter {}: {} has no parameters", text, owner));
  if (found == known.end()) {
    std::vector<std::string_view> names;
    names.reserve(known.size());
    for (const KindParameter& p : known) names.push_back(p.name);
    throw InputError(fmt::format("--parameter {}: {} has {} alone{}", text, owner, fmt::join(names, ", "),
                                 meant(std::string_view(text).substr(0, equals), names)));
  }
  if (equals == std::string::npos) throw InputError(fmt::format("--parameter {}: write {}=value", text, text));
  return {found - known.begin(), std::string_view(text).substr(equals + 1)};
}

// The values of each parameter, one or, where lists are taken, several between commas.
std::vector<std::vector<double>> lists_of(const std::vector<std::string>& given,
                                          const std::vector<KindParameter>& known, std::string_view owner,
                                          bool takes_lists) {
  std::vector<std::vector<double>> lists(known.size());
  for (const std::string& text : given) {
    auto [which, values] = named_in(text, known, owner);
    if (!lists[which].empty())
      throw InputError(fmt::format("--parameter {}: {} is given twice", text, known[which].name));
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

std::vector<double> values_of(const std::vector<std::string>& given, const std::vector<KindParameter>& known,
                              std::string_view owner) {
  std::vector<double> values;
  values.reserve(known.size());
  for (const auto& list : lists_of(given, known, owner, false)) values.push_back(list.front());
  return values;
}

}  // namespace

std::vector<double> parameters_from(const std::vector<std::string>& given, const std::vector<Parameter>& known,
                                    std::string_view owner) {
  std::vector<KindParameter> numbers;
  numbers.reserve(known.size());
  for (const Parameter& p : known) numbers.push_back({p});
  return values_of(given, numbers, owner);
}

std::vector<double> parameters_from(const std::vector<std::string>& given, const std::vector<KindParameter>& known,
                                    std::string_view owner) {
  return values_of(given, known, owner);
}

std::vector<std::vector<double>> parameter_sets_from(const std::vector<std::string>& given,
                                                     const std::vector<KindParameter>& known, std::string_view owner) {
  const std::vector<std::vector<double>> lists = lists_of(given, known, owner, true);
  constexpr double most_sets = 10'000;
  double wanted = 1;
  for (const std::vector<double>& list : lists) wanted *= static_cast<double>(list.size());
  if (wanted > most_sets)
    throw InputError(fmt::format("--parameter: {:.0f} combinations of values, {:.0f} are the most", wanted, most_sets));
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

std::vector<double> parameters_from(const std::vector<std::string>& given, const CoordinateKind& kind) {
  return values_of(given, parameters_of(kind), kind.name);
}

Mesh load_points(const std::string& file, int dimension) {
  if (is_text_of_points(file)) return {read_points(file, dimension), {}};
  Mesh mesh = read_mesh(file);
  if (dimension == 2) check_plane(mesh, file);
  return mesh;
}

}  // namespace cageproof::cli
