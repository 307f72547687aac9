// SPDX-License-Identifier: MIT
#include "segment_sum.h"

namespace cageproof::quadrature_ref {
namespace {

// Fewer points would not even see that an integrand is larger than modelled.
constexpr int kFewestOnPanel = 4;

}  // namespace

SegmentSum::SegmentSum(const Integrand& integrand, ArmFrame<Mp200> frame, const Query<Mp200>& query)
    : ConvergingSum(integrand, query),
      exact_frame_(std::move(frame)),
      frame50_(convert<Mp50>(exact_frame_)),
      frame100_(convert<Mp100>(exact_frame_)) {}

std::array<double, 3> SegmentSum::log10_mass(ArmCaster<Mp50>& caster, const ArmPanel& panel) const {
  std::array<double, 3> mass;
  mass.fill(kNoMass);
  Result<Mp50> tensors;
  const Mp50 whole = caster.length(panel);
  for (int i = 0; i < 3; ++i) {
    const auto size = caster.sample(panel.arm, Mp50(panel.lo + whole * i / 2), whole, tensors);
    for (int o = 0; o <= order_; ++o) mass[o] = std::max(mass[o], log10_magnitude(size[o]));
  }
  return mass;
}

SegmentSum::Cut SegmentSum::cut(const PanelDesign& design) {
  Cut c;
  set_arm_panels(exact_frame_, design, c.panels);
  ArmCaster<Mp50> caster(frame50_, integrand_, task<Mp50>());
  for (const ArmPanel& panel : c.panels) c.mass.push_back(log10_mass(caster, panel));
  return c;
}

template <Scalar W>
void SegmentSum::add_panel(const ArmFrame<W>& frame, const ArmPanel& panel, int n, Result<Mp200>& total) {
  Result<W> sums = empty<W>();
  ArmCaster<W>(frame, integrand_, task<W>()).add_panel(panel, n, sums);
  add(sums, total);
}

Result<Mp200> SegmentSum::with_error(const Cut& cut, const std::array<double, 3>& log10_error) {
  Result<Mp200> total = empty();
  for (std::size_t i = 0; i < cut.panels.size(); ++i) {
    const ArmPanel& panel = cut.panels[i];
    double digits = 0;
    for (int o = 0; o <= order_; ++o)
      if (cut.mass[i][o] > kNoMass) digits = std::max(digits, cut.mass[i][o] - log10_error[o]);
    digits = std::min(digits, kDigitsIn200);
    // Where both cuts are one panel, rules that share their nodes would agree in any case.
    const int n = std::max(kFewestOnPanel, nodes_for(panel.lo, panel.hi, exact_frame_.singular, digits)) +
                  (&cut == cuts_.data() ? 1 : 0);
    if (digits <= kDigitsIn50) add_panel(frame50_, panel, n, total);
    else if (digits <= kDigitsIn100) add_panel(frame100_, panel, n, total);
    else add_panel(exact_frame_, panel, n, total);
  }
  return total;
}

void SegmentSum::scout(double digits) {
  const int nodes = digits > 50 ? 64 : 32;
  cuts_ = {cut({.nodes = nodes, .digits = nodes * .94}), cut({.nodes = nodes * 3 / 4, .digits = nodes * .94})};
  std::array<double, 3> mass;
  mass.fill(kNoMass);
  for (const auto& of_panel : cuts_[0].mass)
    for (int o = 0; o <= order_; ++o) mass[o] = std::max(mass[o], of_panel[o]);
  find_log10_norms(mass, [&](const auto& error) { return with_error(cuts_[0], error); });
}

Result<Mp200> SegmentSum::at(double digits) {
  // Rules know an integrand's singularities, not how a power grows along a panel, which takes ten digits of r^6 log r.
  // Along a line more digits cost next to nothing.
  constexpr double kMore = 16;
  digits += kMore;
  if (cuts_.empty()) scout(digits);
  next_ = 1 - next_;
  return with_error(cuts_[next_], error_of(digits));
}

}  // namespace cageproof::quadrature_ref
