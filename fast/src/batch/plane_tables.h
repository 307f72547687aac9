// SPDX-License-Identifier: MIT
// A polygon as kernels of whole cages see it. Plain arrays, as in tables.h.
#pragma once

#include "cageproof/closed_form/batch/tables.h"

namespace cageproof::closed_form::batch {

/// An edge E of a polygon; its outward normal is to the right.
struct SideTable {
  int from, to;    ///< vertices
  double e[2];     ///< E
  double u[2];     ///< its unit direction
  double over[2];  ///< 1/E, as a complex number
  double length, square;
};

/// Tables of one polygon, in a unit in which its size is about one.
struct PolygonTables {
  int vertices, sides;
  const double* vertex;  ///< [vertex][2]
  const SideTable* side;
};

/// A block of as many points as a vector has lanes, and memory for its results.
struct PlaneBlock {
  const PolygonTables* cage;
  Layers layers;
  int order;
  double beta;      ///< 1/(2 (1 - nu)), of Kelvin's layers
  double unit_log;  ///< the logarithm of the tables' unit in the caller's
  Columns layout;
  const double* points;  ///< [2][lanes]
  double* columns;       ///< [column][lanes]: sums over edges
  void* scratch;         ///< plane_scratch_bytes of it, aligned to 64
  unsigned left;         ///< points without a result: a bit each
  /// Exactly: 1 where the point is to the right of the line through `from` and `to`, -1 to the left, 0 on it.
  int (*side_of)(const double* from, const double* to, const double* point);
};

}  // namespace cageproof::closed_form::batch
