// SPDX-License-Identifier: MIT
#include "data_cages.h"

#include "cageproof/core/input_error.h"
#include "cageproof/core/cage/mesh_io.h"

#include <fmt/format.h>

#include <algorithm>

namespace cageproof::benchmarks {

std::vector<std::shared_ptr<const DeformedCage>> cages_in(const std::filesystem::path& folder) {
  if (!std::filesystem::is_directory(folder)) throw InputError(fmt::format("{}: not a folder", folder.string()));
  constexpr std::string_view ending = "_Cage";
  std::vector<std::string> names;
  for (const auto& entry : std::filesystem::directory_iterator(folder)) {
    const std::string stem = entry.path().stem().string();
    if (entry.path().extension() != ".obj" || !stem.ends_with(ending)) continue;
    std::string name = stem.substr(0, stem.size() - ending.size());
    if (std::filesystem::exists(folder / (name + ".obj"))) names.push_back(std::move(name));
  }
  if (names.empty())
    throw InputError(fmt::format("{}: no cage X_Cage.obj with a mesh X.obj next to it", folder.string()));
  std::ranges::sort(names);
  std::vector<std::shared_ptr<const DeformedCage>> found;
  found.reserve(names.size());
  for (const std::string& name : names) {
    Cage cage = read_cage(folder / (name + "_Cage.obj"));
    const auto deformed = folder / (name + "_Cage_Deformed.obj");
    std::vector<Vec3<double>> posed =
        std::filesystem::exists(deformed) ? read_points(deformed, cage.dimension()) : cage.vertices();
    if (posed.size() != cage.vertices().size())
      throw InputError(
          fmt::format("{}: {} vertices, but the cage has {}", deformed.string(), posed.size(), cage.vertices().size()));
    auto points = read_points(folder / (name + ".obj"), cage.dimension());
    found.push_back(
        std::make_shared<const DeformedCage>(DeformedCage{name, std::move(cage), std::move(posed), std::move(points)}));
  }
  return found;
}

}  // namespace cageproof::benchmarks
