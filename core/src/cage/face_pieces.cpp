// SPDX-License-Identifier: MIT
#include "face_pieces.h"

#include "cageproof/core/geometry/element.h"
#include "cageproof/core/geometry/orientation.h"

namespace cageproof {
namespace {

struct Halves {
  Pieces pieces;
  bool folded;
};

Halves halves_by(const std::vector<Vec3<double>>& vertices, const Face& face, const ElementSplit& split) {
  Halves halves;
  std::array<Triangle<double>, 2> sides;
  for (int i = 0; i < 2; ++i) {
    const auto& corners = split.triangles[i];
    const std::array<int, 3> t{face.vertices[corners[0]], face.vertices[corners[1]], face.vertices[corners[2]]};
    sides[i] = {vertices[t[0]], vertices[t[1]], vertices[t[2]]};
    if (!on_a_line(sides[i])) halves.pieces.push_back(t);
  }
  halves.folded = sign_of_normals(sides[0], sides[1]) < 0;
  return halves;
}

}  // namespace

Pieces pieces_of(const std::vector<Vec3<double>>& vertices, const Face& face) {
  const auto splits = type_of(face.kind()).splits;
  if (splits.empty()) return {{face.vertices[0], face.vertices[1], face.vertices[2]}};
  Halves first = halves_by(vertices, face, splits[0]);
  if (!first.folded) return std::move(first.pieces);
  Halves second = halves_by(vertices, face, splits[1]);
  return std::move(second.folded ? first.pieces : second.pieces);
}

Pieces all_pieces_of(const std::vector<Vec3<double>>& vertices, const Face& face) {
  const auto splits = type_of(face.kind()).splits;
  if (splits.empty()) return pieces_of(vertices, face);
  Pieces all;
  for (const ElementSplit& split : splits) {
    const Halves halves = halves_by(vertices, face, split);
    if (halves.folded) continue;
    all.insert(all.end(), halves.pieces.begin(), halves.pieces.end());
  }
  return all;
}

}  // namespace cageproof
