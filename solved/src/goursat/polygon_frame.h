// SPDX-License-Identifier: MIT
// A polygon in a unit of its own, and a point seen from its corners.
#pragma once

#include "complex.h"

#include "cageproof/core/cage/cage.h"
#include "cageproof/core/geometry/element.h"

#include <vector>

namespace cageproof::solved::goursat {

/// A point as seen from all corners: the offset from each, and its angle from the corner's bisector, continuous in the
/// whole polygon, however it winds around the corner.
template <class R>
struct SeenPoint {
  Complex<R> position;  ///< from the frame's centre
  std::vector<Complex<R>> offsets;
  std::vector<R> angles;
};

/// A simple polygon, counter-clockwise, moved to the centre of its bounding box and scaled by a power of two, so that
/// the box's diagonal lies in [1, 2). Corners are counted along the polygon, and edge k begins at corner k.
class PolygonFrame {
 public:
  struct Corner {
    Complex<double> position;
    double angle;     ///< within the polygon, in (0, 2 pi)
    double bisector;  ///< the direction of its bisector
    int vertex;       ///< of the cage
  };

  /// \throws InputError for a cage that is no single polygon of at most most_edges edges
  explicit PolygonFrame(const Cage& cage);

  int size() const { return static_cast<int>(corners_.size()); }
  const Corner& corner(int k) const { return corners_[k]; }
  int next(int k) const { return k + 1 == size() ? 0 : k + 1; }
  Complex<double> edge(int k) const { return corners_[next(k)].position - corners_[k].position; }
  double length(int k) const;
  /// The cage's face that edge k is, and back.
  int face_of_edge(int k) const { return faces_[k]; }
  /// Lengths here are 2^-exponent() times those of the cage.
  int exponent() const { return exponent_; }
  /// The largest coordinate of the cage's vertices, in its unit, by which points in the cage are rounded.
  double largest_coordinate() const { return largest_; }
  /// In the cage's unit, by edge.
  const std::vector<Segment<double>>& segments() const { return segments_; }
  /// Whether a point lies on an edge, ends included, exactly.
  bool is_on(int edge, const Vec3<double>& point) const;

  /// \pre the point lies within the polygon
  template <class R>
  SeenPoint<R> see(const Vec3<R>& point) const;
  /// A point of an edge, off its ends, seen from inside. \param from_start, from_end fractions of the edge, whose sum
  /// is one
  template <class R>
  SeenPoint<R> see_on_edge(int edge, const R& from_start, const R& from_end) const;

 private:
  template <class R>
  void set_angles(SeenPoint<R>& seen, const Vec3<double>* point, int edge) const;

  Vec3<double> centre_;
  double largest_;
  int exponent_;
  std::vector<Corner> corners_;
  std::vector<Segment<double>> segments_;  // by edge
  std::vector<int> faces_;
  int extreme_ = 0;             // a corner of the convex hull
  std::vector<double> shifts_;  // added to angles that are summed along the polygon
};

/// Why problems are not solved in such a cage; empty where they are.
std::string why_not_solved(const Cage& cage);

}  // namespace cageproof::solved::goursat
