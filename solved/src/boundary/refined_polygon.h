// SPDX-License-Identifier: MIT
// A polygon cut into boundary elements ([W12] Section 4.3: virtual vertices), in a frame of its own.
#pragma once

#include "cageproof/core/cage/cage.h"
#include "cageproof/core/numbers/linear.h"

#include <string>
#include <vector>

namespace cageproof::solved {

/// The polygon's edges, each cut into pieces of one length, in a frame of its own: the origin is the cage's first
/// vertex, the unit of length the largest distance between two vertices. Systems that are solved in it, whose kernels
/// have the logarithm of the distance, and what comes of them, do not depend on the user's unit, place or direction;
/// and no set of that diameter has logarithmic capacity one, at which the single layer loses constants. In the user's
/// own unit, which the paper keeps, neither holds.
///
/// Nodes are the cage's vertices, by their own numbers, then the new ones, by edge; pieces go by edge, too.
class RefinedPolygon {
 public:
  enum class Unit { Diameter, Own };

  /// \param pieces per edge, at least 1 \pre the cage is in the plane
  /// \throws InputError when there would be more than most_nodes
  RefinedPolygon(const Cage& cage, int pieces, Unit unit = Unit::Diameter);

  static constexpr int most_nodes = 4096;

  int pieces_an_edge() const { return pieces_; }
  int vertices() const { return static_cast<int>(vertices_.size()); }
  int edges() const { return static_cast<int>(edges_.size()); }
  int nodes() const { return vertices() + edges() * (pieces_ - 1); }
  int pieces() const { return edges() * pieces_; }
  /// The frame's unit in the user's.
  double unit() const { return unit_; }
  /// The largest distance between two vertices, in the frame.
  double diameter() const { return diameter_ / unit_; }

  /// Whether an edge is shorter than the 128th part of the diameter.
  bool has_short_edge() const { return sees_from_ends_; }

  /// The vertices that an edge joins; the cage lies on its left.
  const std::array<int, 2>& edge(int e) const { return edges_[e]; }
  /// The edge that ends where edge e begins.
  int before(int e) const { return before_[e]; }
  /// The edge that begins where edge e ends.
  int after(int e) const { return after_[e]; }
  /// Node number k = 0 ... pieces_an_edge() of an edge.
  int node(int e, int k) const {
    if (k == 0 || k == pieces_) return edges_[e][k == 0 ? 0 : 1];
    return vertices() + e * (pieces_ - 1) + k - 1;
  }

  /// A vertex, as the user gave it.
  template <Scalar R>
  Vec3<R> vertex(int v) const {
    return convert<R>(vertices_[v]);
  }

  /// A place in the plane: a point of the user's, and a step from it in the frame.
  template <Scalar R>
  struct At {
    Vec3<R> from, step = Vec3<R>::Zero();
  };
  /// A place as it is seen from a vertex, in the frame.
  template <Scalar R>
  Vec3<R> seen_from(int v, const At<R>& place) const {
    return Vec3<R>((place.from - vertex<R>(v)) / R(unit_)) + place.step;
  }

  /// An edge in the frame: its direction, and how long its pieces are.
  template <Scalar R>
  struct Line {
    Vec3<R> direction;
    R piece;

    Vec3<R> left() const { return {-direction[1], direction[0], R(0)}; }
  };
  template <Scalar R>
  Line<R> line(int e) const {
    using std::hypot;
    const int from = sees_from_ends_ ? edges_[e][0] : 0;
    const Vec3<R> along = seen_from<R>(from, end<R>(e, 1)) - seen_from<R>(from, end<R>(e, 0));
    const R length = hypot(along[0], along[1]);
    return {along / length, length / pieces_};
  }

  /// The vertex that piece k of an edge sees others from: the nearer end of its edge where the polygon has a short
  /// edge, which in the frame loses as many digits of its length as it is shorter than the polygon; else the frame's
  /// origin, so that roundings of places are the same for all pieces.
  int seer(int e, int k) const { return sees_from_ends_ ? edges_[e][2 * k < pieces_ ? 0 : 1] : 0; }
  /// A place so many pieces along an edge, seen from one of the edge's ends or the frame's origin.
  template <Scalar R>
  Vec3<R> along(int e, const R& steps, int from) const {
    if (steps == 0) return seen_from<R>(from, end<R>(e, 0));
    if (steps == pieces_) return seen_from<R>(from, end<R>(e, 1));
    const Line<R> line = this->line<R>(e);
    if (sees_from_ends_ && from == edges_[e][1]) return R((steps - pieces_) * line.piece) * line.direction;
    return seen_from<R>(from, end<R>(e, 0)) + (steps * line.piece) * line.direction;
  }
  template <Scalar R>
  At<R> on(int e, const R& steps) const {
    const int from = seer(e, 2 * steps < pieces_ ? 0 : pieces_);
    return {vertex<R>(from), along<R>(e, steps, from)};
  }

 private:
  int pieces_;
  double unit_ = 1, diameter_ = 0;
  std::vector<Vec3<double>> vertices_;
  std::vector<std::array<int, 2>> edges_;
  std::vector<int> before_, after_;
  bool sees_from_ends_ = false;

  template <Scalar R>
  At<R> end(int e, int which) const {
    return {vertex<R>(edges_[e][which])};
  }
};

/// Pieces of an edge where nobody says how many.
inline constexpr int default_pieces = 4;

/// Why a polygon in default_pieces has no system of a size that can be solved; empty where it has.
std::string why_not_refined(const Cage& cage);

}  // namespace cageproof::solved
