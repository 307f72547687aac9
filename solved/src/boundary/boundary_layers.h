// SPDX-License-Identifier: MIT
// The layers of [W12] Section 4.2 and Appendix B on the pieces of a refined polygon, off the polygon and on it.
#pragma once

#include "refined_polygon.h"

#include "cageproof/core/numbers/least_squares.h"

#include <span>
#include <vector>

namespace cageproof::solved {

/// phi^H, psi^H, phi^BH, psi^BH, then those of Appendix B for order 3. Double layers have one number per node, single
/// layers one per piece.
enum class Layer { Double, Single, BiharmonicDouble, BiharmonicSingle, TriharmonicDouble, TriharmonicSingle };

inline constexpr std::array all_layers{
    Layer::Double,           Layer::Single, Layer::BiharmonicDouble, Layer::BiharmonicSingle, Layer::TriharmonicDouble,
    Layer::TriharmonicSingle};

constexpr bool is_per_node(Layer layer) { return static_cast<int>(layer) % 2 == 0; }

/// The layers up to an order: 1 harmonic, 2 biharmonic, 3 triharmonic.
constexpr std::span<const Layer> layers_up_to(int order) { return std::span(all_layers).first(2 * order); }

/// Evaluations of the layers on segments, by layer, up to an order.
using LayerEvaluations = std::vector<Evaluation>;

/// \param name of the evaluations; empty for the recommended ones \throws InputError where a layer has none of that
/// name
LayerEvaluations layer_evaluations(const std::string& name, int order);

/// Where a point is on the polygon: on an edge, so many pieces from its beginning.
template <Scalar R>
struct OnEdge {
  int edge;
  R steps;
};

/// A point of the polygon where equations are asked to hold: `part` of `parts` along a piece of an edge, 0 for the
/// node that the piece begins at.
struct CollocationPoint {
  int edge, piece, part, parts;

  bool is_vertex() const { return piece == 0 && part == 0; }
};

/// The layers at collocation points, limits from inside: one row per point, one column per node or piece.
template <Scalar R>
struct LayerRows {
  std::vector<Matrix<R>> layer;
  Matrix<R> hats;  ///< the nodes' hat functions there

  const Matrix<R>& operator[](Layer which) const { return layer[static_cast<std::size_t>(which)]; }
};

/// Asks the evaluations for layers of all pieces. Keeps references.
template <Scalar R>
class BoundaryLayers {
 public:
  BoundaryLayers(const RefinedPolygon& polygon, const LayerEvaluations& evaluations);

  using At = RefinedPolygon::At<R>;

  /// Layers at points off the polygon: adds to tables whose coordinates are nodes or pieces. Pieces see points as
  /// RefinedPolygon::seer says.
  void add(std::span<const Layer> layers, std::span<const At> points, int order,
           std::span<CoordinateTable<R>> tables) const;

  /// The same at one point on the polygon, limits from inside. The pieces of the edges that the point is on are seen in
  /// their edge's own direction, in which it is exactly on their line, whatever rounding made of nodes and point.
  /// \param on an edge that the point is on; both that meet where it is a vertex
  void add_on(std::span<const Layer> layers, const At& point, std::span<const OnEdge<R>> on, int order,
              std::span<CoordinateTable<R>> tables) const;

  /// At a point on the polygon the hat functions' double layer is: of pieces on other edges as off the polygon; of
  /// pieces on its own edges the hat function at the point, times what is left of one.
  /// \param inset instead of the limits the layers at points of the polygon that is offset inwards by so much, in the
  /// frame, and pieces' points by the same shares ([W12] Section 6); 0: the limits
  LayerRows<R> rows(std::span<const CollocationPoint> points, double inset = 0) const;

  /// The table of one layer at so many points, of zeros.
  CoordinateTable<R> table(Layer layer, std::size_t points, int order) const;

 private:
  struct Piece {
    int seen_from;                ///< a vertex
    std::array<Vec3<R>, 2> ends;  ///< from there
    std::array<int, 2> nodes;
    int number;
  };
  void add_piece(const Piece& piece, std::span<const Layer> layers, std::span<const Vec3<R>> points, int order,
                 std::span<CoordinateTable<R>> tables) const;
  std::vector<Vec3<R>> seen_from(int vertex, std::span<const At> points) const;
  /// Adds the layers of pieces on other edges.
  void add_others(std::span<const Layer> layers, const At& point, std::span<const OnEdge<R>> on, int order,
                  std::span<CoordinateTable<R>> tables) const;
  void add_in_line(int edge, const R& steps, std::span<const Layer> layers, int order,
                   std::span<CoordinateTable<R>> tables) const;
  Piece piece(int edge, int part) const;
  void put_limits(const CollocationPoint& point, Eigen::Index row, LayerRows<R>& rows) const;
  void put_inset(const CollocationPoint& point, double inset, Eigen::Index row, LayerRows<R>& rows) const;
  At inset_node(int edge, int k, const R& inset) const;

  // All layers that have an evaluation.
  std::span<const Layer> layers() const { return layers_up_to(static_cast<int>(evaluations_.size()) / 2); }
  // One table per layer, for one point, with only values.
  std::vector<CoordinateTable<R>> tables() const;

  const RefinedPolygon& polygon_;
  const LayerEvaluations& evaluations_;
  std::vector<Piece> pieces_;
};

}  // namespace cageproof::solved
