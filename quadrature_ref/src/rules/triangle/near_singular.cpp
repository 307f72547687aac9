// SPDX-License-Identifier: MIT
#include "moved_inward.h"
#include "polar_cells.h"

#include "triangle_rules.h"

namespace cageproof::quadrature_ref {

template <Scalar R>
void triangle::integrate_near_singular(const Integrand& integrand, int n, const Batch<R>& batch,
                                       const BatchOutput<R>& output) {
  using W = std::conditional_t<std::same_as<R, float>, double, R>;
  static thread_local std::vector<PolarCell> cells;
  const PanelDesign design{.nodes = n, .digits = std::min<double>(n, std::numeric_limits<W>::digits10)};
  const ConvertedBatch<Mp200> exact(batch);
  const ConvertedBatch<W> wide(batch);
  const KernelTask<W> task = integrand.task<W>(wide.parameters, batch.order);
  integrate_block<W>(
      integrand, batch, output,
      [&](const Vec3<R>& point) { return frame_moved_inward(exact.corners, cageproof::convert<Mp200>(point)); },
      [&](const PolarFrame<Mp200>& exact_frame, Result<W>& sums) {
        const auto frame = convert<W>(exact_frame);
        RayCaster<W> caster(frame, integrand, task);
        set_polar_cells(exact_frame, design, cells);
        for (const PolarCell& cell : cells) caster.add_cell(cell, {cell.edge < 0 ? kRingDirections : n, n}, sums);
      });
}

#define CAGEPROOF_INSTANTIATE(R) \
  template void triangle::integrate_near_singular<R>(const Integrand&, int, const Batch<R>&, const BatchOutput<R>&);
CAGEPROOF_INSTANTIATE(float)
CAGEPROOF_INSTANTIATE(double)
CAGEPROOF_INSTANTIATE(Mp50)
CAGEPROOF_INSTANTIATE(Mp100)
CAGEPROOF_INSTANTIATE(Mp200)
#undef CAGEPROOF_INSTANTIATE

}  // namespace cageproof::quadrature_ref
