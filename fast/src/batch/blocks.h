// SPDX-License-Identifier: MIT
// Runs blocks of points through the kernels: one block's sums over all faces, near and far.
#pragma once

#include "aligned.h"
#include "geometry.h"
#include "kernels.h"

#include "cageproof/core/coordinates/coordinates.h"

#include <cstddef>
#include <span>
#include <vector>

namespace cageproof::closed_form::batch {

/// A request that is the same for all blocks.
struct Request {
  Layers layers;
  int order;
  TwoDoubles beta;  ///< 1/(2 (1 - nu))
  Mp200 long_beta;
  Columns layout;
};

/// Memory for one block after the other, within one thread.
class BlockRunner {
 public:
  /// The arguments must outlive this.
  BlockRunner(const Geometry& geometry, const CageElements& elements, const Request& request,
              const Kernels& with = kernels())
      : BlockRunner(geometry, &elements, request, with) {}
  /// \param elements null for a part of a cage. Then points on the part's border are left to others, and sums are not
  /// made again where they are small against their terms: the whole sums are not, at points inside.
  BlockRunner(const Geometry& geometry, const CageElements* elements, const Request& request,
              const Kernels& with = kernels());

  /// Up to as many points as the kernels have lanes. \return a bit for each point that the kernels leave to others: on
  /// the cage, too near to it, or too far away
  unsigned run(std::span<const Vec3<double>> points);
  /// All faces but some at one point, in double-doubles, as the first lane of the columns. These then hold coordinates
  /// of the vertices around which no face is left out. \pre layers are sums \return whether more digits decide as well
  bool run_without(const std::vector<char>& left_out, const Vec3<double>& point);
  /// [column][lanes], as Columns says.
  const double* columns() const { return columns_.get(); }

 private:
  unsigned add_marked(std::span<const Vec3<double>> points);
  unsigned add_beyond(std::span<const Vec3<double>> points);

  const Geometry& geometry_;
  const CageElements* elements_;
  const Request& request_;
  const Kernels& kernels_;
  CageTables tables_;
  Aligned<double> points_, columns_;
  Aligned<std::byte> scratch_, measured_;
  std::vector<Mark> marks_, beyond_;
  Block block_{};
};

}  // namespace cageproof::closed_form::batch
