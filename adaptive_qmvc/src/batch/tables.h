// SPDX-License-Identifier: MIT
// A cage of bilinear quads as kernels of whole cages see it. Plain arrays, so that sources compiled for one instruction
// set leave no functions behind that others might be linked to.
#pragma once

namespace cageproof::adaptive_qmvc::batch {

/// A quad xi = origin + u e + v b + u v w with its lines along e. N = n + u n_u + v n_v, and N.(xi - eta) is bilinear
/// in u and v: its coefficient of u v is `twist`. A triangle is a quad whose last two corners are one.
struct QuadTable {
  double origin[3], e[3], b[3], w[3];
  double n[3], n_u[3], n_v[3];
  double n_high[3], n_rest[3];  ///< n to twice the digits, the first of which have 24 bits
  double twist;
  int vertex[4];
};

/// A side of a quad, or of two.
struct EdgeTable {
  double from[3], along[3];
  double over2;  ///< one over its squared length, zero for a side without length
};

/// Lines of a quad, at most.
inline constexpr int kMostLines = 128;

/// A Gauss-Legendre rule on [0, 1]. Its arrays are longer by the widest vector, with zeros.
struct Rule {
  int count;  ///< even along lines
  const double* node;
  const double* moment[3];  ///< the weights, times the nodes, times their squares
};

/// Points of a chunk in a unit in which the cage's size is about one, and their sums.
struct Chunk {
  int stride;        ///< a multiple of every vector's width
  const double* at;  ///< [3][stride]
  double* sums;      ///< [vertex][stride]
};

/// Points that see a quad by the same rules.
struct Pairs {
  const Chunk* chunk;
  const QuadTable* quad;
  const Rule* across;
  const Rule* along;  ///< null: along lines the integral is elementary
  const int* point;   ///< their numbers in the chunk
  int count;
};

/// Where a quad's integrals with the basis functions Phi_k go, k = 0 .. 3: those of point p are added to
/// double_layer[vertex[k] * stride + p] and stored in single_layer[4 p + corner[k]].
struct LayerColumns {
  double* double_layer;
  double* single_layer;
};

/// Points that see a quad by the same rules, and where the integrals of Phi_k N.x/r^3 and Phi_k/r go, and those of
/// Phi_k N.x/r and Phi_k r, unless their columns are null.
struct LayerPairs {
  Pairs pairs;
  LayerColumns harmonic, biharmonic;
  const int* corner;
  bool close;  ///< Plan::close
};

/// A quad about the point (u0, v0) of it: xi - eta = a + t e + s b + s t w at (u0 + t, v0 + s). a x e along the line at
/// s is c0 + s c1 + s^2 c2, and N.x = g00 + s g01 + t (g10 + s g11).
struct NearQuad {
  double u0, v0;
  double a[3], e[3], b[3], w[3];
  double c0[3], c1[3], c2[3];
  double g00, g01, g10, g11;
};

/// Lines of one quad, at steps s, whose count every vector's width divides.
struct NearLines {
  const NearQuad* quad;
  int count;
  const double* step;
  const double* weight;
  bool biharmonic;  ///< whether integrals of Phi_k N.x/r and Phi_k r are wanted, too
};

/// The functions of one instruction set.
struct Kernels {
  const char* name;
  /// The distances of a chunk's points from an edge.
  void (*distances)(const Chunk&, const EdgeTable&, double* to);
  /// Adds the weights of one quad.
  void (*add)(const Pairs&);
  /// Divides the sums of `vertices` columns by all of them together, which are stored.
  void (*normalise)(const Chunk&, int vertices, double* whole);
  /// Adds the layers of one quad for points that see it from afar.
  void (*add_layers)(const LayerPairs&);
  /// Adds the layers of one quad at one point: four numbers each of Phi_k N.x/r^3, Phi_k/r and, where they are wanted,
  /// Phi_k N.x/r and Phi_k r.
  void (*add_near_layers)(const NearLines&, double* to);
};

}  // namespace cageproof::adaptive_qmvc::batch
