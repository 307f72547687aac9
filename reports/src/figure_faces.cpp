// SPDX-License-Identifier: MIT
#include "figure_faces.h"

#include <algorithm>
#include <optional>

namespace cageproof::reports {
namespace {

constexpr Rgb kDarkFace{0.90, 0.66, 0.36}, kInnerFace{0.80, 0.30, 0.32};

// Pixels of the shaded faces a pixel of the picture, along each axis.
constexpr int kFiner = 3;

// Light from above the viewer's left shoulder, and some from everywhere.
Rgb shaded(const Rgb& colour, const Vec3<double>& normal, const ViewAxes& axes) {
  const Vec3<double> light = (axes.towards + 0.55 * axes.up - 0.45 * axes.right).normalized();
  const double part = 0.52 + 0.52 * std::max(0.0, normal.dot(light));
  Rgb found{};
  for (std::size_t c = 0; c < 3; ++c) found[c] = std::min(1.0, part * colour[c]);
  return found;
}

// A triangle of a face, in pixels, with its depth.
struct Piece {
  std::array<Vec3<double>, 3> corners;  ///< x and y in pixels, z towards the viewer
  std::size_t face;

  double depth() const { return corners[0][2] + corners[1][2] + corners[2][2]; }
  double longest() const {
    double found = 0;
    for (std::size_t k = 0; k < 3; ++k) found = std::max(found, (corners[(k + 1) % 3] - corners[k]).head<2>().norm());
    return found;
  }
};

// Cuts a piece in four until its sides are short.
void add_pieces(const Piece& piece, double most, std::vector<Piece>& pieces) {
  if (!(piece.longest() > most)) {
    pieces.push_back(piece);
    return;
  }
  const auto& [a, b, c] = piece.corners;
  const Vec3<double> ab = (a + b) / 2, bc = (b + c) / 2, ca = (c + a) / 2;
  using Corners = std::array<Vec3<double>, 3>;
  for (const Corners& part : {Corners{a, ab, ca}, Corners{ab, b, bc}, Corners{ca, bc, c}, Corners{ab, bc, ca}})
    add_pieces({part, piece.face}, most, pieces);
}

// All faces as triangles of similar size, because the depth of a large one's middle says little about the faces that it
// hides.
std::vector<Piece> pieces_of(const FigurePanel& panel, const FigureFrame& frame, const ViewAxes& axes) {
  std::vector<Piece> whole;
  for (std::size_t f = 0; f < panel.data.faces.size(); ++f) {
    const auto corner = [&](std::size_t k) {
      const Vec3<double>& vertex = panel.data.vertices[panel.data.faces[f][k]];
      const Place place = frame.at(vertex);
      return Vec3<double>(kFiner * (place[0] - frame.left), kFiner * (place[1] - frame.top), axes.towards.dot(vertex));
    };
    for (std::size_t k = 2; k < panel.data.faces[f].size(); ++k)
      whole.push_back({{corner(0), corner(k - 1), corner(k)}, f});
  }
  std::vector<double> sides;
  sides.reserve(whole.size());
  for (const Piece& piece : whole) sides.push_back(piece.longest());
  const auto middle = sides.begin() + static_cast<std::ptrdiff_t>(sides.size() / 2);
  if (!sides.empty()) std::ranges::nth_element(sides, middle);
  constexpr double least = 4 * kFiner;  // pixels; smaller parts cost time that nobody sees
  const double most = sides.empty() ? least : std::max(least, 2 * *middle);
  std::vector<Piece> pieces;
  pieces.reserve(whole.size());
  for (const Piece& piece : whole) add_pieces(piece, most, pieces);
  std::ranges::stable_sort(pieces, {}, &Piece::depth);
  return pieces;
}

}  // namespace

// Twice the area of a face, along its normal.
Vec3<double> area_of(const std::vector<Vec3<double>>& vertices, const std::vector<int>& face) {
  Vec3<double> sum = Vec3<double>::Zero();
  for (std::size_t k = 2; k < face.size(); ++k)
    sum += (vertices[face[k - 1]] - vertices[face[0]]).cross(vertices[face[k]] - vertices[face[0]]);
  return sum;
}

// Faces from the farthest to the nearest, without smoothing, on a finer grid of pixels: no seams between neighbours.
void draw_faces(const FigurePanel& panel, const FigureFrame& frame, const ViewAxes& axes, Canvas& canvas) {
  const auto& faces = panel.data.faces;
  std::vector<std::optional<Rgb>> colours(faces.size());
  for (std::size_t f = 0; f < faces.size(); ++f) {
    Vec3<double> normal = area_of(panel.data.vertices, faces[f]);
    if (!(normal.norm() > 0)) continue;
    normal.normalize();
    const bool inner = normal.dot(axes.towards) < 0;
    const Rgb& colour = inner ? kInnerFace : !panel.tones.empty() && panel.tones[f] ? kDarkFace : kLightFace;
    colours[f] = shaded(colour, inner ? Vec3<double>(-normal) : normal, axes);
  }
  Canvas fine(static_cast<int>(kFiner * frame.width), static_cast<int>(kFiner * frame.height), true);
  fine.set_smooth(false);
  for (const Piece& piece : pieces_of(panel, frame, axes)) {
    if (!colours[piece.face]) continue;
    std::array<Place, 3> corners{};
    for (std::size_t k = 0; k < 3; ++k) corners[k] = {piece.corners[k][0], piece.corners[k][1]};
    fine.fill(corners, *colours[piece.face]);
  }
  canvas.put(fine, frame.left, frame.top, kFiner);
}

}  // namespace cageproof::reports
