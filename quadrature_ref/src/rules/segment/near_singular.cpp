// SPDX-License-Identifier: MIT
#include "../adaptive.h"
#include "../converted.h"
#include "arm_caster.h"

#include "segment_rules.h"

namespace cageproof::quadrature_ref {
namespace {

// The frame of a point; a point on the segment is moved inside by kInward. Nothing for degenerate segments.
std::optional<ArmFrame<Mp200>> arm_frame_moved_inward(std::span<const Vec3<Mp200>> corners, const Vec3<Mp200>& point) {
  const auto s = segment_frame(corners, point);
  if (!s) return std::nullopt;
  const OnSegment on = on_segment(*s);
  return arm_frame(*s, on.yes ? Mp200(on.clearance * kInward) : Mp200(0));
}

}  // namespace

template <Scalar R>
void segment::integrate_near_singular(const Integrand& integrand, int n, const Batch<R>& batch,
                                      const BatchOutput<R>& output) {
  using W = std::conditional_t<std::same_as<R, float>, double, R>;
  static thread_local std::vector<ArmPanel> panels;
  const PanelDesign design{.nodes = n, .digits = std::min<double>(n, std::numeric_limits<W>::digits10)};
  const ConvertedBatch<Mp200> exact(batch);
  const ConvertedBatch<W> wide(batch);
  const KernelTask<W> task = integrand.task<W>(wide.parameters, batch.order);
  integrate_block<W>(
      integrand, batch, output,
      [&](const Vec3<R>& point) { return arm_frame_moved_inward(exact.corners, cageproof::convert<Mp200>(point)); },
      [&](const ArmFrame<Mp200>& exact_frame, Result<W>& sums) {
        const auto frame = convert<W>(exact_frame);
        ArmCaster<W> caster(frame, integrand, task);
        set_arm_panels(exact_frame, design, panels);
        for (const ArmPanel& panel : panels) caster.add_panel(panel, n, sums);
      });
}

#define CAGEPROOF_INSTANTIATE(R) \
  template void segment::integrate_near_singular<R>(const Integrand&, int, const Batch<R>&, const BatchOutput<R>&);
CAGEPROOF_INSTANTIATE(float)
CAGEPROOF_INSTANTIATE(double)
CAGEPROOF_INSTANTIATE(Mp50)
CAGEPROOF_INSTANTIATE(Mp100)
CAGEPROOF_INSTANTIATE(Mp200)
#undef CAGEPROOF_INSTANTIATE

}  // namespace cageproof::quadrature_ref
