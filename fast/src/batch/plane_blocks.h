// SPDX-License-Identifier: MIT
// Blocks of points of the plane run through the kernels.
#pragma once

#include "blocks.h"
#include "plane_tables.h"
#include "polygon.h"

namespace cageproof::closed_form::batch {

/// BlockRunner for a polygon.
class PlaneRunner {
 public:
  /// The arguments must outlive this.
  PlaneRunner(const Polygon& polygon, const CageElements& elements, const Request& request,
              const Kernels& with = kernels());

  /// As BlockRunner::run; points left to others lie on a vertex, or their results leave double's range.
  unsigned run(std::span<const Vec3<double>> points);
  const double* columns() const { return columns_.get(); }

 private:
  const Polygon& polygon_;
  const Kernels& kernels_;
  PolygonTables tables_;
  Aligned<double> points_, columns_;
  Aligned<std::byte> scratch_;
  PlaneBlock block_{};
};

}  // namespace cageproof::closed_form::batch
