// SPDX-License-Identifier: MIT
#include "commands.h"

#include "cageproof/core/embedded_cages.h"

#include <algorithm>

namespace cageproof::cli {

void CageArguments::add_to(CLI::App& command, bool required) {
  command.add_option("--cage", file, "cage: a file (OBJ, PLY, STL, VTP), or the name of an embedded cage")->required(required);
  command.add_flag("--flip-inward", flip_inward, "turn a cage whose normals point inward");
  command.add_option("--triangulate", triangulate, "how quads become triangles: shortest diagonal, or fan from the first corner")
      ->check(CLI::IsMember({"shortest", "fan"}))
      ->capture_default_str();
}

Cage CageArguments::load() const {
  const auto names = embedded_cage_names();
  if (std::ranges::find(names, file) != names.end()) return embedded_cage(file);
  return read_cage(file, {.flip_inward = flip_inward});
}

Mesh load_points(const std::string& file) {
  const auto extension = std::filesystem::path(file).extension();
  const bool text = extension == ".csv" || extension == ".xyz" || extension == ".txt";
  return text ? Mesh{read_points(file), {}} : read_mesh(file);
}

}  // namespace cageproof::cli
