// SPDX-License-Identifier: MIT
#include "constraints.h"

#include "cageproof/core/input_error.h"
#include "cageproof/core/whole_file.h"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <set>

namespace cageproof::cli {
namespace {

using Json = nlohmann::json;
using deformation::Constraints;

constexpr std::string_view kSchema = "cageproof-constraints";
constexpr int kVersion = 1;

// nlohmann-json keeps the last of keys that occur twice, and a constraint would be lost.
Json parsed(const std::string& text) {
  std::vector<std::set<std::string>> keys;
  const auto watch = [&keys](int, Json::parse_event_t event, Json& value) {
    if (event == Json::parse_event_t::object_start) keys.emplace_back();
    if (event == Json::parse_event_t::object_end) keys.pop_back();
    if (event == Json::parse_event_t::key && !keys.back().insert(value.get<std::string>()).second)
      throw InputError(fmt::format("the key \"{}\" occurs twice", value.get<std::string>()));
    return true;
  };
  try {
    return Json::parse(text, watch);
  } catch (const Json::parse_error& e) {
    throw InputError(fmt::format("malformed JSON at byte {}", e.byte));
  } catch (const Json::out_of_range&) {
    throw InputError("a number is beyond the range of double");
  }
}

// An object with these keys, and no others.
void require_keys(const Json& json, const std::string& where, const std::vector<std::string>& needed,
                  const std::vector<std::string>& allowed) {
  if (!json.is_object()) throw InputError(fmt::format("{} is not an object", where));
  for (const std::string& key : needed)
    if (!json.contains(key)) throw InputError(fmt::format("{} has no \"{}\"", where, key));
  for (const auto& [key, value] : json.items())
    if (std::ranges::find(needed, key) == needed.end() && std::ranges::find(allowed, key) == allowed.end())
      throw InputError(fmt::format("{} has the unknown key \"{}\"", where, key));
}

// As many numbers as the space has dimensions; the others are zero.
Vec3<double> numbers(const Json& json, const std::string& where, int dimension) {
  if (!json.is_array() || static_cast<int>(json.size()) != dimension)
    throw InputError(fmt::format("{} must be {} numbers", where, dimension));
  Vec3<double> found = Vec3<double>::Zero();
  for (int c = 0; c < dimension; ++c) {
    if (!json[c].is_number()) throw InputError(fmt::format("{}[{}] is not a number", where, c));
    found[c] = json[c].get<double>();
  }
  return found;
}

Mat3<double> matrix(const Json& json, const std::string& where, int dimension) {
  if (!json.is_array() || static_cast<int>(json.size()) != dimension)
    throw InputError(fmt::format("{} must be {} rows", where, dimension));
  Mat3<double> found = Mat3<double>::Zero();
  for (int c = 0; c < dimension; ++c)
    found.row(c) = numbers(json[c], fmt::format("{}[{}]", where, c), dimension).transpose();
  return found;
}

// Calls use(item, "key[index]") for each item of a list, which may be missing.
void for_each_of(const Json& json, const std::string& key, const auto& use) {
  if (!json.contains(key)) return;
  if (!json[key].is_array()) throw InputError(fmt::format("{} is not a list", key));
  for (std::size_t i = 0; i < json[key].size(); ++i) use(json[key][i], fmt::format("{}[{}]", key, i));
}

Constraints constraints_of(const Json& json, int dimension) {
  require_keys(json, "the document", {"schema", "schema_version"},
               {"positions", "orientations", "rotations", "hessians"});
  if (json["schema"] != kSchema) throw InputError(fmt::format("\"schema\" is not \"{}\"", kSchema));
  if (json["schema_version"] != kVersion)
    throw InputError(fmt::format("\"schema_version\" is not {}, the one that is read", kVersion));
  Constraints found;
  for_each_of(json, "positions", [&](const Json& item, const std::string& where) {
    require_keys(item, where, {"at", "to"}, {});
    found.positions.push_back(
        {numbers(item["at"], where + ".at", dimension), numbers(item["to"], where + ".to", dimension)});
  });
  for_each_of(json, "orientations", [&](const Json& item, const std::string& where) {
    require_keys(item, where, {"at", "jacobian"}, {});
    found.orientations.push_back(
        {numbers(item["at"], where + ".at", dimension), matrix(item["jacobian"], where + ".jacobian", dimension)});
  });
  for_each_of(json, "rotations", [&](const Json& item, const std::string& where) {
    found.rotations.push_back(numbers(item, where, dimension));
  });
  for_each_of(json, "hessians", [&](const Json& item, const std::string& where) {
    found.hessians.push_back(numbers(item, where, dimension));
  });
  return found;
}

}  // namespace

Constraints read_constraints(const std::filesystem::path& file, int dimension) {
  const std::string text = read_file(file);
  try {
    return constraints_of(parsed(text), dimension);
  } catch (const InputError& e) {
    throw InputError(fmt::format("{}: {}", file.string(), e.what()));
  }
}

}  // namespace cageproof::cli
