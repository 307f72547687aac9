// SPDX-License-Identifier: MIT
// A closed triangle cage as kernels of whole cages see it: everything that does not depend on the point. Plain arrays,
// so that sources compiled for one instruction set leave no functions behind that others might be linked to.
#pragma once

namespace cageproof::closed_form::batch {

/// A constant of twice the digits of double: their unevaluated sum.
struct TwoDoubles {
  double high, low;
};

/// An edge, run through in one direction for both of its faces. T: the type of constants.
template <class T>
struct EdgeTable {
  int from, to;    ///< vertices
  T u[3];          ///< unit direction
  T length, over;  ///< length, and one over it
};

/// A triangle; its edge i runs from corner i to corner i + 1.
template <class T>
struct FaceTable {
  // First what values take, since tables of many faces come from memory.
  int vertex[3], edge[3];
  double along[3];      ///< of edges: 1, or -1 where the edge's table runs the other way
  double steep;         ///< the largest of `across`: how much differences of integrals over its edges are multiplied
  double steep_around;  ///< the same times a third of its circumference
  T area2;              ///< twice the area
  T n[3];               ///< outward unit normal
  T nu[3][3];           ///< of edges: outward in-plane unit normal
  T hat[2];             ///< of corners 0 and 1: the hat function over the height above the line of the opposite edge
  T across[2][3];       ///< gradient of that hat function times each edge's nu
  T length[3];          ///< of edges
  T g[2][3];            ///< of corners 0 and 1: gradient of the hat function
  T u[3][3];            ///< of edges: direction, from corner to corner
  T middle[3][3];       ///< of edges: vector from corner 0 to the middle
};

/// The layers that kinds of coordinates are made of.
enum class Layers {
  Harmonic,    ///< phi, psi
  Biharmonic,  ///< phi, psi, phibar, psibar
  Kelvin,      ///< T, K
  MeanValue,   ///< lambda
};

/// Calls f.template operator()<L, O>() for layers that are sums of edge terms.
template <class F>
auto with_layers(Layers layers, int order, F f) {
  if (layers == Layers::Kelvin) {
    if (order == 0) return f.template operator()<Layers::Kelvin, 0>();
    if (order == 1) return f.template operator()<Layers::Kelvin, 1>();
    return f.template operator()<Layers::Kelvin, 2>();
  }
  if (layers == Layers::Harmonic) {
    if (order == 0) return f.template operator()<Layers::Harmonic, 0>();
    if (order == 1) return f.template operator()<Layers::Harmonic, 1>();
    return f.template operator()<Layers::Harmonic, 2>();
  }
  if (order == 0) return f.template operator()<Layers::Biharmonic, 0>();
  if (order == 1) return f.template operator()<Layers::Biharmonic, 1>();
  return f.template operator()<Layers::Biharmonic, 2>();
}

inline constexpr int kMostBlocks = 4;

/// Where sums over faces lie: numbers of block b and order o begin at first[o][b], [coordinate][entry][derivative]: one
/// of order 0, three of order 1, six of order 2 (xx, xy, xz, yy, yz, zz); in the plane two and three (xx, xy, yy).
struct Columns {
  int first[3][kMostBlocks];
  int count;
};

struct FarRule;
struct LineRule;

/// An edge that faces of a tile have.
struct TileEdge {
  int edge, from, to;  ///< the edge's number; its ends among the tile's vertices
};

/// Groups of faces near each other, so that the results of their vertices and edges stay in caches.
struct Tiles {
  int count;
  const int *first_face, *first_vertex, *first_edge;  ///< [count + 1], in:
  const int* face;                                    ///< all faces
  const int* vertex;                                  ///< each tile's vertices
  const TileEdge* edge;                               ///< each tile's edges
  const int (*slot)[6];  ///< of faces by their numbers: corners and edges among those of their tile
};

/// Tables of one cage, in a unit in which its size is about one.
struct CageTables {
  int vertices, edges, faces;
  const double* vertex;  ///< [vertex][3]
  const double* reach;   ///< of vertices: distances below this are next to them
  const EdgeTable<double>* edge;
  const FaceTable<double>* face;
  const EdgeTable<TwoDoubles>* fine_edge;
  const FaceTable<TwoDoubles>* fine_face;
  double size;         ///< about its diagonal
  const char* folded;  ///< of faces: whether one lies on another nearly where they meet
  /// Numbers that rules are chosen by: [3][stride] centroids of faces, and [stride] one over the square of a corner's
  /// largest distance from there. The stride is the number of faces, rounded up to whole vectors; the first face fills
  /// them up.
  const double* centroid;
  const double* over_square;
  int stride;
  const FarRule* rules;  ///< kFarRules
  const LineRule* line;
  Tiles tiles;
};

/// A face, and the points of a block for which it is treated differently: a bit each.
struct Mark {
  int face;
  unsigned points;
};

/// A block of as many points as a vector has lanes, and memory for its results.
struct Block {
  const CageTables* cage;
  Layers layers;
  int order;
  TwoDoubles beta;  ///< 1/(2 (1 - nu)), of Kelvin's layers
  Columns layout;
  const double* points;  ///< [3][lanes]
  unsigned whole;        ///< points for which every face is summed in double-double
  double* columns;       ///< [column][lanes]: sums over faces
  void* scratch;         ///< scratch_bytes of it, aligned to 64
  void* measured;        ///< measured_bytes of it, aligned to 64: how much faces cancel, for sum_again
  Mark* marks;           ///< room for one per face: the faces that are summed in double-double
  int marked;
  unsigned left;  ///< points without a result
  Mark* beyond;   ///< room for one per face: the faces for which double-double is not enough
  int beyond_marked;
};

/// Where rows of one order and block of coordinates go: that of point p begins at to + row[p] stride.
struct Rows {
  double* to;
  long stride;
  const long* row;
  int coordinates, entries, width;  ///< width: one derivative, two or four in the plane, three or nine in space
  const double* from;               ///< the columns, where three stand for four and six for nine
  double factor;
  bool streaming;  ///< whether rows are not to be kept in caches
};

/// Cage data to multiply one order's columns of a block with: [coordinate][column][set].
struct Products {
  double* to;  ///< [point][row][set][derivative], added to; that of point p begins at to + point[p] stride
  long stride;
  const long* point;
  int coordinates, rows, columns, sets, width;
  const double* from;
  const double* data;
  double factor;
};

struct PlaneBlock;

/// The functions of one instruction set.
struct Kernels {
  const char* name;
  int lanes;
  long (*scratch_bytes)(int vertices, int edges, int faces, int columns);
  long (*measured_bytes)();
  /// Sums over faces in double; lists the faces that points are next to, and leaves these out for them.
  void (*sum)(Block&);
  /// Adds the marked faces in double-double; lists those for which that is not enough, and leaves them out.
  void (*sum_marked)(Block&);
  /// Once all faces are added: whether points cancel more than double may. Then sums are made anew as `sum` does, with
  /// more faces summed by rules or left out, until it says no.
  bool (*sum_again)(Block&);
  /// Divides the sums of normalised coordinates by their total.
  void (*normalise)(Block&);
  long (*plane_scratch_bytes)(int vertices);
  /// Sums over a polygon's edges.
  void (*sum_plane)(PlaneBlock&);
  void (*store)(const Rows&, int points);
  void (*multiply)(const Products&, int points);
};

}  // namespace cageproof::closed_form::batch
