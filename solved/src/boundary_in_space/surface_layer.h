// SPDX-License-Identifier: MIT
// One layer on all pieces of a refined surface, off the surface and on it.
#pragma once

#include "refined_surface.h"

#include "cageproof/core/numbers/least_squares.h"

#include <span>

namespace cageproof::solved {

/// Asks an evaluation of a triangle's formula for all pieces. A piece has one slot per corner if the formula has one
/// tensor per corner, else one slot. Keeps references.
template <Scalar R>
class SurfaceLayer {
 public:
  SurfaceLayer(const RefinedSurface& surface, const Evaluation& evaluation, std::span<const R> parameters = {});

  /// Slots of all pieces.
  int slots() const { return surface_.pieces() * slots_a_piece_; }
  /// The count of numbers in one slot's tensor, rows times columns.
  int entries() const { return evaluation_.formula().shape.entries(); }

  /// A table of zeros: [point][slot][entry][derivative].
  CoordinateTable<R> table(std::size_t points, int order) const;

  /// Adds the layer at points in the frame. Values of layers that are continuous across the surface are right on it,
  /// too.
  void add(std::span<const Vec3<R>> points, int order, CoordinateTable<R>& to) const;

  /// The same at one point on the surface, limits from inside: pieces of the triangles that the point is on are seen in
  /// their triangle's own plane, in which it lies exactly, whatever rounding made of their corners.
  /// \pre the formula's tensors are numbers or matrices
  void add_on(const Vec3<R>& point, std::span<const Touching> on, int order, CoordinateTable<R>& to) const;

  /// The layer at points of the user's, in a table of its own: inside and outside, and on the surface the limits from
  /// inside. \param elements the cage's, which say exactly what a point is on
  CoordinateTable<R> around(const CageElements& elements, std::span<const Vec3<R>> points, int order) const;

  /// Values at places: one row per place and row of the tensor, one column per slot and column of the tensor. \pre the
  /// layer is continuous across the surface
  Matrix<R> rows(std::span<const PlaceOnTriangle> places) const;

 private:
  struct Piece {
    std::array<Vec3<R>, 3> corners;
    std::array<int, 3> slots;
    int triangle;
  };
  std::span<const int> slots_of(const Piece& piece) const { return std::span(piece.slots).first(slots_a_piece_); }
  void add_piece(const Piece& piece, std::span<const Vec3<R>> points, int order, CoordinateTable<R>& to) const;
  void add_in_plane(const Touching& on, int order, CoordinateTable<R>& to) const;

  const RefinedSurface& surface_;
  const Evaluation& evaluation_;
  std::vector<R> parameters_;
  int slots_a_piece_;
  std::vector<Piece> pieces_;
};

}  // namespace cageproof::solved
