// SPDX-License-Identifier: MIT
// The triangles of a cage, cut into pieces that boundary equations in space are solved on.
#pragma once

#include "cageproof/core/coordinates/coordinates.h"

#include <array>
#include <vector>

namespace cageproof::solved {

/// A place within a triangle of the cage: basis functions of its second and third corner, which are doubles; that of
/// the first is what is left of one, in any scalar.
struct PlaceOnTriangle {
  int triangle;
  double second, third;

  Touching touching() const { return {triangle, {1 - second - third, second, third, 0}}; }
};

/// Each triangle cut into 4^level equal pieces by lines parallel to its edges, in a frame of the cage's own: its first
/// vertex is the origin, and the largest distance between two vertices the unit of length. Pieces, and corners of
/// pieces, are numbered triangle by triangle; neighbours share no number, so that functions may jump at their edges.
class RefinedSurface {
 public:
  /// \param densities numbers that are solved for on each piece; the bound on their number is one of memory: a matrix
  /// of most_unknowns^2 doubles takes half a gigabyte
  /// \throws InputError where there would be more than most_unknowns
  RefinedSurface(const Cage& cage, const CageElements& elements, int level, int densities);

  static constexpr int most_unknowns = 8192;

  int triangles() const { return static_cast<int>(triangles_.size()); }
  int pieces_a_triangle() const { return static_cast<int>(pieces_.size()); }
  int pieces() const { return triangles() * pieces_a_triangle(); }
  /// The frame's unit in the user's.
  double unit() const { return unit_; }
  /// The cage's vertices at a triangle's corners.
  std::span<const int> vertices_of(int triangle) const { return triangles_[triangle]; }

  /// A point of the user's in the frame.
  template <Scalar R>
  Vec3<R> in_frame(const Vec3<R>& point) const {
    return (point - convert<R>(vertices_[0])) / R(unit_);
  }

  /// A triangle's corners in the frame, counter-clockwise seen from outside.
  template <Scalar R>
  std::array<Vec3<R>, 3> corners_of(int triangle) const {
    const auto& v = triangles_[triangle];
    return {in_frame<R>(convert<R>(vertices_[v[0]])), in_frame<R>(convert<R>(vertices_[v[1]])),
            in_frame<R>(convert<R>(vertices_[v[2]]))};
  }

  /// The corners of a triangle's piece number k, of the triangle itself where it is given by those corners.
  template <Scalar R>
  std::array<Vec3<R>, 3> piece(const std::array<Vec3<R>, 3>& corners, int k) const {
    std::array<Vec3<R>, 3> found;
    for (int c = 0; c < 3; ++c) found[c] = at<R>(corners, pieces_[k][c][0], pieces_[k][c][1]);
    return found;
  }

  /// The point of a triangle with these basis functions of its second and third corner, which may be dyadic.
  template <Scalar R>
  static Vec3<R> at(const std::array<Vec3<R>, 3>& corners, double second, double third) {
    return corners[0] + R(second) * (corners[1] - corners[0]) + R(third) * (corners[2] - corners[0]);
  }

  /// The place in the triangle that has these basis functions in its piece number k.
  PlaceOnTriangle place(int triangle, int k, double second, double third) const;

 private:
  double unit_ = 1;
  std::vector<Vec3<double>> vertices_;
  std::vector<std::array<int, 3>> triangles_;
  // The basis functions of the second and third corner at the corners of each piece of a triangle; dyadic, so exact.
  std::vector<std::array<std::array<double, 2>, 3>> pieces_;
};

/// Three places within each piece, at which affine functions of it are told apart, piece by piece.
std::vector<PlaceOnTriangle> collocation_places(const RefinedSurface& surface);

}  // namespace cageproof::solved
