// SPDX-License-Identifier: MIT
// The files that `coordinates` writes: the table, and what someone needs to apply it.
#pragma once

#include "coordinate_description.h"

#include <filesystem>
#include <string>
#include <utility>
#include <vector>

namespace cageproof::cli {

/// The extensions there are: ".csv, .npy, .npz or .vtp".
std::string coordinate_extensions();

/// The file next to --out that describes it: of tables without names of their own (.csv, .npy) a `.json`, of .vtp
/// the cage as a `.cage.vtp`; empty for .npz, which holds everything.
std::filesystem::path companion_of(const std::filesystem::path& out);

/// \throws InputError for an unknown extension, for a file next to --out that is no such description, and for one
/// that is read or written twice
void check_coordinate_files(const std::filesystem::path& out,
                            const std::vector<std::pair<std::string, std::string>>& others);

/// Files that hold a whole table, with their bytes, ready to be written together: .npz, or .vtp with the cage's file.
/// \param description of everything but the geometry
std::vector<std::pair<std::filesystem::path, std::string>> coordinate_files(
    const std::filesystem::path& out, const CoordinateColumns& table, const Mesh& mesh, reports::DescribedCage cage,
    const nlohmann::ordered_json& description, const CageCoordinates& coordinates);

/// Members of an .npz that describe the cage (vertices, elements, normals, metadata.json), by name and bytes.
std::vector<std::pair<std::string, std::string>> cage_members(const reports::DescribedCage& cage);

/// The description next to a .csv or .npy, which is written by rows.
std::pair<std::filesystem::path, std::string> description_file(const std::filesystem::path& out,
                                                               const reports::DescribedCage& cage,
                                                               const nlohmann::ordered_json& description);

/// Refuses, before any work is done, a table that needs more than half of the memory to write as such a file. \throws
/// InputError with the sizes, and what to do
void require_memory_for(const std::filesystem::path& out, std::size_t points, std::size_t columns);

}  // namespace cageproof::cli
