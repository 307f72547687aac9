// SPDX-License-Identifier: MIT
// The fuzzer and the corpus test ask this of a hostile file: an InputError of one line, or a mesh and a cage that are
// whole.
#pragma once

#include "cageproof/core/cage/mesh_io.h"
#include "cageproof/core/input_error.h"

#include <algorithm>
#include <filesystem>
#include <stdexcept>
#include <string>

namespace cageproof::fuzzing {

/// Calls f. \throws std::logic_error when its InputError says nothing, or more than a line
template <class F>
void expect_clear_error(F&& f) {
  try {
    f();
  } catch (const InputError& error) {
    const std::string message = error.what();
    if (message.empty() || message.find('\n') != std::string::npos) throw std::logic_error("unclear: " + message);
  }
}

inline void expect_whole(const Mesh& mesh) {
  const auto is_vertex = [&](int v) { return v >= 0 && static_cast<std::size_t>(v) < mesh.vertices.size(); };
  if (mesh.vertices.empty()) throw std::logic_error("a mesh without vertices");
  for (const Vec3<double>& p : mesh.vertices)
    if (!p.allFinite()) throw std::logic_error("a coordinate that is not finite");
  for (const auto& face : mesh.faces)
    if (!std::ranges::all_of(face, is_vertex)) throw std::logic_error("a face's index is out of range");
  for (const auto& segment : mesh.segments)
    if (!std::ranges::all_of(segment, is_vertex)) throw std::logic_error("a segment's index is out of range");
}

/// Reads a file as points in space, as points in the plane, and as a cage.
/// \throws std::logic_error if a result is neither whole nor a clear error; and what readers throw but should not
inline void read_input(const std::filesystem::path& path) {
  for (const int dimension : {2, 3}) expect_clear_error([&] { expect_whole(read_points_and_faces(path, dimension)); });
  expect_clear_error([&] {
    Mesh mesh = read_points_and_faces(path);
    expect_whole(as_cage_mesh(mesh, path));
    cage_from(std::move(mesh), path);
  });
}

}  // namespace cageproof::fuzzing
