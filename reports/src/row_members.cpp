// SPDX-License-Identifier: MIT
#include "row_members.h"

#include "csv_field.h"

#include <fmt/format.h>

#include <algorithm>
#include <stdexcept>
#include <type_traits>

namespace cageproof::reports {
namespace {

using enum RowMember::Kind;

// Values as JSON; null for a total loss that is not known.
Json value_json(RowKey::Section section) { return name_of(section); }
Json value_json(Verdict verdict) { return name_of(verdict); }
Json value_json(const std::string& text) { return text; }
Json value_json(int number) { return number; }
Json value_json(std::uint64_t number) { return number; }
Json value_json(double number) { return number < 0 ? Json() : json_number(number); }
Json value_json(const std::optional<double>& number) { return number ? json_number(*number) : Json(); }
Json value_json(const std::vector<std::uint64_t>& counts) {
  const auto used = [](std::uint64_t count) { return count != 0; };
  const auto first = std::ranges::find_if(counts, used);
  const auto last = std::find_if(counts.rbegin(), counts.rend(), used).base();
  if (first == counts.end()) return {{"first", 0}, {"counts", Json::array()}};
  return {{"first", first - counts.begin()}, {"counts", std::vector<std::uint64_t>(first, last)}};
}

// The same members as text.
std::string value_text(RowKey::Section section) { return std::string(name_of(section)); }
std::string value_text(Verdict verdict) { return std::string(name_of(verdict)); }
std::string value_text(const std::string& text) { return csv_field(text); }
std::string value_text(int number) { return fmt::format("{}", number); }
std::string value_text(std::uint64_t number) { return fmt::format("{}", number); }
std::string value_text(double number) { return number < 0 ? "" : fmt::format("{}", number); }
std::string value_text(const std::optional<double>& number) { return number ? fmt::format("{}", *number) : ""; }
std::string value_text(const std::vector<std::uint64_t>&) { return ""; }

void read(const Json& json, RowKey::Section& section) {
  const auto name = json.get<std::string>();
  const auto found = std::ranges::find(sections, name, [](RowKey::Section s) { return name_of(s); });
  if (found == sections.end()) throw std::invalid_argument("no section: " + name);
  section = *found;
}
void read(const Json& json, std::string& text) { text = json.get<std::string>(); }
void read(const Json& json, std::uint64_t& count) {
  if (!json.is_number_unsigned()) throw std::invalid_argument("not a count: " + dump(json));
  count = json.get<std::uint64_t>();
}
void read(const Json& json, int& order) {
  std::uint64_t number = 0;
  read(json, number);
  if (number > 2) throw std::invalid_argument("not an order: " + dump(json));
  order = static_cast<int>(number);
}
void read(const Json& json, double& value) {
  const auto number = number_of(json);
  if (!number) throw std::invalid_argument("not a number: " + dump(json));
  value = *number;
}

// Calls what with each member's name and pointer that is one of `Owner`.
template <class Owner, class What>
void for_each_of(What what) {
  for (const RowMember& member : row_members())
    std::visit(
        [&]<class Value, class Class>(Value Class::*pointer) {
          if constexpr (std::is_same_v<Class, Owner>) what(member.name, pointer);
        },
        member.pointer);
}

}  // namespace

const std::vector<RowMember>& row_members() {
  static const std::vector<RowMember> members{{"section", Key, &RowKey::section},
                                              {"subject", Key, &RowKey::subject},
                                              {"evaluation", Key, &RowKey::evaluation},
                                              {"scalar", Key, &RowKey::scalar},
                                              {"regime", Key, &RowKey::setting},
                                              {"check", Key, &RowKey::check},
                                              {"place", Key, &RowKey::place},
                                              {"order", Key, &RowKey::order},
                                              {"role", Text, &RowFigures::role},
                                              {"unit", Figure, &RowFigures::unit},
                                              {"samples", Figure, &ResultRow::samples},
                                              {"nonfinite", Count, &ResultRow::nonfinite},
                                              {"asked", Count, &RowFigures::asked},
                                              {"without_truth", Count, &RowFigures::without_truth},
                                              {"unreached", Count, &RowFigures::unreached},
                                              {"declined", Count, &RowFigures::declined},
                                              {"max", Figure, &ResultRow::max},
                                              {"p999", Figure, &ResultRow::p999},
                                              {"median", Figure, &ResultRow::median},
                                              {"max_relative", Figure, &RowFigures::max_relative},
                                              {"total_loss", Figure, &RowFigures::total_loss},
                                              {"bound", Figure, &ResultRow::bound},
                                              {"verdict", Figure, &ResultRow::verdict},
                                              {"reason", Text, &ResultRow::reason},
                                              {"histogram", Figure, &ResultRow::histogram}};
  return members;
}

Json member_json(const ResultRow& row, const RowMember& member) {
  return std::visit([&](auto pointer) { return value_json(row.*pointer); }, member.pointer);
}

std::string member_field(const ResultRow& row, const RowMember& member) {
  return std::visit([&](auto pointer) { return value_text(row.*pointer); }, member.pointer);
}

Json key_json(const RowKey& key) {
  Json json = Json::array();
  for_each_of<RowKey>([&](const char*, auto pointer) { json.push_back(value_json(key.*pointer)); });
  return json;
}

RowKey key_of(const Json& json) {
  RowKey key;
  std::size_t place = 0;
  for_each_of<RowKey>([&](const char*, auto pointer) { read(json.at(place++), key.*pointer); });
  return key;
}

void add_figures(Json& json, const RowFigures& figures) {
  for_each_of<RowFigures>([&](const char* name, auto pointer) {
    if (figures.*pointer != RowFigures().*pointer) json[name] = value_json(figures.*pointer);
  });
}

RowFigures figures_of(const Json& json) {
  RowFigures figures;
  for_each_of<RowFigures>([&](const char* name, auto pointer) {
    if (json.contains(name)) read(json[name], figures.*pointer);
  });
  return figures;
}

}  // namespace cageproof::reports
