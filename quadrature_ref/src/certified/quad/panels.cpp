// SPDX-License-Identifier: MIT
#include "panels.h"

#include "ball_vectors.h"

#include <algorithm>

namespace cageproof::quadrature_ref::certified {
namespace {

constexpr slong planning_bits = 512;
constexpr int deepest = 450;          // bisections
constexpr double least_reach = 1.25;  // semi-major axis over half: rho is two
constexpr double planning_cost = 60;  // of a stretch

// A lower bound of a as an exact ball; zero unless it is positive.
Real lower_bound(const Real& a) {
  Real c;
  arb_get_lbound_arf(arb_midref(c.raw()), a.raw(), MAG_BITS);
  return arb_is_positive(c.raw()) != 0 ? c : Real(0);
}
Real root_below(const Real& square) { return lower_bound(sqrt(lower_bound(square))); }
Real root_above(const Real& square) { return upper_bound(sqrt(upper_bound(square))); }
// An upper bound of both.
Real larger(const Real& a, const Real& b) {
  Real c;
  arb_max(c.raw(), a.raw(), b.raw(), working_bits);
  return upper_bound(c);
}

// The stretch's middle line, and how far complex v may be from the middle: |x(u, v)| >= |x(u, middle)| - |v - middle|
// |across(u)| where x.x = 0 has no root, since the roots of x.x in v - middle are |x(u, middle)|/|across(u)| away.
struct Surroundings {
  LineBounds line;
  Real across;       // upper bound of |across(u)|
  double reach = 0;  // nearest/(across half), an estimate
};

Surroundings surroundings_of(const SeenQuad& quad, const QuadStretch& stretch) {
  const WorkingBits planning(planning_bits);
  const auto& [first, last] = stretch.ends;
  const Vector along = minus(last, first);
  const Real squared = dot(along, along), a = dot(first, first), b = dot(last, last);
  Surroundings s;
  s.line.length = root_below(squared);
  s.line.farthest = larger(root_above(a), root_above(b));
  // The line's distance is a lower bound wherever the foot is; beyond an end that end is nearest.
  const Vector perpendicular = cross(first, along);
  if (arb_is_nonnegative(dot(first, along).raw()) != 0) s.line.nearest = root_below(a);
  else if (arb_is_nonpositive(dot(last, along).raw()) != 0) s.line.nearest = root_below(b);
  else if (!s.line.length.is_zero()) s.line.nearest = root_below(dot(perpendicular, perpendicular) / squared);
  s.across = larger(root_above(dot(quad.across[0], quad.across[0])), root_above(dot(quad.across[1], quad.across[1])));
  if (!s.line.nearest.is_zero()) s.reach = std::exp2((s.line.nearest / (s.across * stretch.half)).log2_size());
  return s;
}

class Planner {
 public:
  Planner(const SeenQuad& quad, QuadIntegrand& integrand, int goal, double& work_left)
      : quad_(quad), integrand_(integrand), goal_(goal), work_left_(work_left) {
    const WorkingBits planning(planning_bits);
    for (int o = 0; o < integrand.orders(); ++o) scale_.push_back(-HUGE_VAL);
    // W = across[1] - across[0] is the change of the lines' directions.
    const Vector twist = minus(quad.across[1], quad.across[0]);
    twist_ = root_above(dot(twist, twist));
  }

  std::optional<std::vector<QuadPanel>> run() {
    const Real half = Real(1) / 2;
    std::vector<QuadPanel> coarse;
    if (!cut({stretch_of(quad_, half, half), 0, 0, {}, {}}, coarse)) return std::nullopt;
    for (const QuadPanel& panel : coarse) note_scale(panel);
    std::vector<QuadPanel> panels;
    for (const QuadPanel& panel : coarse)
      if (!refine(panel, panels)) return std::nullopt;
    return panels;
  }

 private:
  bool spend(double work) {
    work_left_ -= work;
    return work_left_ > 0;
  }

  std::array<QuadPanel, 2> halves_of(const QuadPanel& panel) const {
    const WorkingBits exact = WorkingBits::exact();
    Real quarter;
    arb_mul_2exp_si(quarter.raw(), panel.stretch.half.raw(), -1);
    return {QuadPanel{stretch_of(quad_, panel.stretch.middle - quarter, quarter), panel.depth + 1, 0, {}, {}},
            QuadPanel{stretch_of(quad_, panel.stretch.middle + quarter, quarter), panel.depth + 1, 0, {}, {}}};
  }

  // Bisects until a panel is short against its distance from the point.
  bool cut(QuadPanel panel, std::vector<QuadPanel>& into) {
    std::vector<QuadPanel> stack;
    stack.push_back(std::move(panel));
    while (!stack.empty()) {
      const QuadPanel top = std::move(stack.back());
      stack.pop_back();
      if (!spend(planning_cost)) return false;
      if (surroundings_of(quad_, top.stretch).reach * 0.8 >= least_reach) {
        into.push_back(top);
        continue;
      }
      if (top.depth >= deepest) return false;
      auto [low, high] = halves_of(top);
      stack.push_back(std::move(high));
      stack.push_back(std::move(low));
    }
    return true;
  }

  // Estimates: they decide what is spent, and prove nothing.
  void note_scale(const QuadPanel& panel) {
    spend(integrand_.cost());
    const auto& values = integrand_(panel.stretch, quad_, Real(0));
    for (int o = 0; o < integrand_.orders(); ++o)
      for (const Real& value : values[o]) {
        const double size = value.log2_size() + panel.stretch.half.log2_size();
        if (size < HUGE_VAL) scale_[o] = std::max(scale_[o], size);
      }
  }

  bool refine(const QuadPanel& panel, std::vector<QuadPanel>& into) {
    if (!spend(planning_cost)) return false;
    const Surroundings around = surroundings_of(quad_, panel.stretch);
    QuadPanel best = panel;
    for (const double share : {0.5, 0.8, 0.95}) {
      QuadPanel tried = panel;
      if (!(around.reach * share > 1.0625) || !bound(tried, around, around.reach * share)) continue;
      if (best.nodes == 0 || tried.nodes < best.nodes) best = std::move(tried);
    }
    if (best.nodes != 0 && (best.nodes <= goal_ / 2 + 16 || best.depth >= deepest)) {
      into.push_back(std::move(best));
      return true;
    }
    if (panel.depth >= deepest) return false;
    for (const QuadPanel& part : halves_of(panel))
      if (!refine(part, into)) return false;
    return true;
  }

  // Gauss-Legendre's n nodes on [-1, 1] are off by at most 64/15 M rho^(-2n)/(1 - rho^(-2)), n >= 2
  // (../README.md), M a bound in the ellipse, which is inside the disc of its semi-major axis.
  bool bound(QuadPanel& panel, const Surroundings& around, double semi_major) const {
    const WorkingBits planning(planning_bits / 4);
    const double rho = semi_major + std::sqrt(semi_major * semi_major - 1);
    if (!std::isfinite(rho)) return false;
    panel.rho = Real::exactly(rho);
    const Real inverse = Real(1) / panel.rho;
    const Real major = upper_bound(panel.stretch.half * (panel.rho + inverse) / 2);
    LineBounds line = around.line;
    line.kappa = upper_bound(major * around.across / line.nearest);
    if (arb_lt(line.kappa.raw(), Real(1).raw()) == 0) return false;
    const Vector along = minus(panel.stretch.ends[1], panel.stretch.ends[0]);
    line.normal = upper_bound((root_above(dot(along, along)) + major * twist_) * around.across);
    const Real& middle = panel.stretch.middle;
    const Real weight = integrand_.weights() == 1 ? Real(1) : larger(middle, Real(1) - middle) + major;
    const Real common = weight * panel.stretch.half * 64 / 15 / (Real(1) - inverse * inverse);
    double most = 0;
    for (int o = 0; o < integrand_.orders(); ++o) {
      panel.errors.push_back(integrand_.vanishes(o) ? Real(0) : upper_bound(common * integrand_.bound(o, line)));
      if (panel.errors[o].is_zero() || scale_[o] == -HUGE_VAL) continue;
      most = std::fmax(most, goal_ + panel.errors[o].log2_size() - scale_[o]);
    }
    if (!(most < 1e6)) return false;
    const int least = std::max(2, static_cast<int>(std::ceil(most / (2 * std::log2(rho)))));
    const int step = least <= 32 ? 2 : 8;  // few rules, computed once
    panel.nodes = (least + step - 1) / step * step;
    Real power;
    arb_pow_ui(power.raw(), inverse.raw(), 2 * static_cast<ulong>(panel.nodes), working_bits);
    for (Real& error : panel.errors) error = upper_bound(error * power);
    return true;
  }

  const SeenQuad& quad_;
  QuadIntegrand& integrand_;
  int goal_;
  double& work_left_;
  Real twist_;
  std::vector<double> scale_;  // per order, log2 of the largest contribution
};

}  // namespace

std::optional<std::vector<QuadPanel>> quad_panels(const SeenQuad& quad, QuadIntegrand& integrand, int goal,
                                                  double& work_left) {
  return Planner(quad, integrand, goal, work_left).run();
}

}  // namespace cageproof::quadrature_ref::certified
