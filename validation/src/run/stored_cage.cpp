// SPDX-License-Identifier: MIT
#include "run/stored_cage.h"

#include "run/fingerprint.h"

#include "cageproof/core/cage/embedded_cages.h"
#include "cageproof/core/input_error.h"
#include "cageproof/core/cage/mesh_io.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

namespace cageproof::validation {
namespace {

namespace fs = std::filesystem;

// Where a cage's file may lie.
std::vector<std::string> places_of(const std::string& name, const std::vector<fs::path>& folders) {
  std::vector<std::string> places{name};
  if (fs::path(name).is_absolute()) return places;
  for (const fs::path& folder : folders)
    if (fs::path place = (folder / name).lexically_normal(); place != fs::absolute(name).lexically_normal())
      places.push_back(place.string());
  return places;
}

// Cases draw on the cage's name, which is to be the stored one.
Cage named(const std::string& name, const Cage& cage) {
  return (cage.dimension() == 2 ? Cage::make_polygon : Cage::make)(name, cage.vertices(), cage.faces(), {});
}

}  // namespace

Cage stored_cage(const std::string& name, const StoredFacts& stored) {
  const auto is_the_stored = [&](const Cage& cage) {
    return stored.cage_content.empty() || fingerprint_of(cage) == stored.cage_content;
  };
  if (is_embedded_cage(name)) {
    Cage cage = embedded_cage(name);
    if (is_the_stored(cage)) return cage;
    throw InputError(fmt::format("the embedded cage '{}' has changed since the case was stored", name));
  }
  const std::vector<std::string> places = places_of(name, stored.folders);
  std::vector<std::string> changed;
  for (const std::string& place : places) {
    std::error_code ignored;
    if (!fs::exists(place, ignored)) continue;
    const Cage cage = read_cage(place, {.flip_inward = true});
    if (is_the_stored(cage)) return named(name, cage);
    changed.push_back(place);
  }
  if (changed.empty()) throw InputError(fmt::format("{}: no such file; looked for {}", name, fmt::join(places, ", ")));
  throw InputError(fmt::format("{}: the cage has changed since the case was stored, its vertices or faces are others",
                               fmt::join(changed, ", ")));
}

}  // namespace cageproof::validation
