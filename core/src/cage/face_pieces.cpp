// SPDX-License-Identifier: MIT
#include "face_pieces.h"

#include "../geometry/lengths.h"
#include "cageproof/core/geometry/orientation.h"

#include <algorithm>

namespace cageproof {
namespace {

std::array<Triangle<double>, 2> halves_of(const std::vector<Vec3<double>>& vertices, const Face& face,
                                          const ElementSplit& split) {
  std::array<Triangle<double>, 2> halves;
  for (int i = 0; i < 2; ++i)
    for (int k = 0; k < 3; ++k) halves[i][k] = vertices[face.vertices[split.triangles[i][k]]];
  return halves;
}

// Adds the pieces of both triangles of a face that have an area.
void add_pieces(const std::vector<Vec3<double>>& vertices, const Face& face, const ElementSplit& split,
                Pieces& pieces) {
  const auto halves = halves_of(vertices, face, split);
  for (int i = 0; i < 2; ++i) {
    const auto& corners = split.triangles[i];
    if (!on_a_line(halves[i]))
      pieces.push_back({face.vertices[corners[0]], face.vertices[corners[1]], face.vertices[corners[2]]});
  }
}

}  // namespace

bool folds(const std::vector<Vec3<double>>& vertices, const Face& face, const ElementSplit& split) {
  const auto [first, second] = halves_of(vertices, face, split);
  return sign_with_both_normals(first, second) < 0 || sign_with_both_normals(second, first) < 0;
}

const ElementSplit& split_of(const std::vector<Vec3<double>>& vertices, const Face& face, Triangulation rule) {
  const std::span<const ElementSplit> splits = type_of(face.kind()).splits;
  const auto diagonal = [&](const ElementSplit& split) {
    return Segment<double>{vertices[face.vertices[split.diagonal[0]]], vertices[face.vertices[split.diagonal[1]]]};
  };
  // Exact, so that the split never hangs on a rounding.
  const auto is_shorter = [&](const ElementSplit& a, const ElementSplit& b) {
    return compare_lengths(diagonal(a), diagonal(b)) < 0;
  };
  const auto chosen = rule == Triangulation::Shortest ? std::ranges::min_element(splits, is_shorter) : splits.begin();
  if (!folds(vertices, face, *chosen)) return *chosen;
  const auto unfolded =
      std::ranges::find_if(splits, [&](const ElementSplit& split) { return !folds(vertices, face, split); });
  return unfolded != splits.end() ? *unfolded : *chosen;
}

Pieces pieces_of(const std::vector<Vec3<double>>& vertices, const Face& face) {
  const auto splits = type_of(face.kind()).splits;
  if (splits.empty()) return {{face.vertices[0], face.vertices[1], face.vertices[2]}};
  const bool other = folds(vertices, face, splits[0]) && !folds(vertices, face, splits[1]);
  Pieces pieces;
  add_pieces(vertices, face, splits[other ? 1 : 0], pieces);
  return pieces;
}

Pieces all_pieces_of(const std::vector<Vec3<double>>& vertices, const Face& face) {
  const auto splits = type_of(face.kind()).splits;
  if (splits.empty()) return pieces_of(vertices, face);
  Pieces all;
  for (const ElementSplit& split : splits)
    if (!folds(vertices, face, split)) add_pieces(vertices, face, split, all);
  return all;
}

}  // namespace cageproof
