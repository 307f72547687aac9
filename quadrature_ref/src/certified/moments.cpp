// SPDX-License-Identifier: MIT
#include "moments.h"

#include "gauss_nodes.h"

#include <algorithm>

namespace cageproof::quadrature_ref::certified {
namespace {

constexpr slong rough_bits = 64;    // of bounds and estimates
constexpr int hopeless_depth = 12;  // bisections of a panel
constexpr int bound_boxes = 4;      // that cover half an ellipse

// Along an edge tau = distance sinh v, r = distance cosh v: no root, and no singularity closer than pi/2 to the real
// line but those of the elementary functions' forms.
template <class Number>
class EdgeIntegrand {
 public:
  EdgeIntegrand(const EdgeFrame& edge, const Real& height, const RadialRange& range)
      : edge_(edge), height_(height), height_square_(edge.height * edge.height), table(range) {
    arb_abs(height_.raw(), height_.raw());
    for (int i = 0; i < 2; ++i) across_[i] = edge.outward[i] * edge.height;
  }

  void set(const Number& v) {
    Number tau;
    sinh_cosh(v, tau, r);
    tau = tau * edge_.distance;
    r = r * edge_.distance;
    for (int i = 0; i < 2; ++i) y[i] = tau * edge_.along[i] + Number(across_[i]);
    table.set(tau * tau + Number(height_square_), r, height_);
  }

 private:
  const EdgeFrame& edge_;
  Real height_, height_square_;
  std::array<Real, 2> across_;

 public:
  RadialTable<Number> table;
  std::array<Number, 2> y;
  Number r;
};

// A stretch of an edge, with bounds of the integrand's size on the ellipse whose foci are its ends.
struct Panel {
  const EdgeFrame* edge;
  Real middle, half;
  double rho = 0;  // sum of the ellipse's semi-axes over half
  std::array<Real, 2> y_bound;
  std::vector<Real> bounds;  // |r H(m + 1, q)|
  int nodes = 0;
};

class Integrator {
 public:
  Integrator(const Frame& frame, const MomentRange& range, int goal, double& work_left)
      : frame_(frame),
        range_(range),
        goal_(goal),
        work_left_(work_left),
        radial_{range.highest_q(), std::max(3, range.highest_degree() + 1)},
        result_(range),
        scale_(radial_.count() * stride(), -HUGE_VAL) {}

  std::optional<Moments> run(std::size_t& nodes) {
    std::vector<Panel> coarse = coarse_panels();
    spend(3 * static_cast<double>(coarse.size()), 1);
    if (work_left_ < 0) return std::nullopt;
    for (const Panel& panel : coarse) note_scale(panel);
    std::vector<Panel> panels;
    double planned = 0;
    for (const Panel& panel : coarse) {
      refine(panel, 0, panels);
      if (work_left_ < 0) return std::nullopt;
    }
    for (const Panel& panel : panels) planned += panel.nodes;
    spend(planned, static_cast<double>(working_bits) / 64);
    if (work_left_ < 0) return std::nullopt;
    for (const Panel& panel : panels) {
      add(panel);
      nodes += static_cast<std::size_t>(panel.nodes);
    }
    return std::move(result_);
  }

 private:
  int stride() const { return range_.highest_degree() + 1; }
  // Counts the work of evaluations of the integrand in numbers of `words` words.
  void spend(double evaluations, double words) {
    work_left_ -= evaluations * static_cast<double>(scale_.size()) * (1 + words * std::sqrt(words) / 8);
  }

  template <class Use>
  void for_each_degree(Use use) const {
    for (int q = range_.lowest_q(); q <= range_.highest_q(); q += 2)
      for (int m = 0; m <= range_.degree(q); ++m) use(q, m, static_cast<std::size_t>(radial_.index(q) * stride() + m));
  }

  std::vector<Panel> coarse_panels() const {
    std::vector<Panel> panels;
    for (const EdgeFrame& edge : frame_.edges) {
      if (edge.passes) continue;  // the factor in front of the integral is zero
      const Real v0 = asinh(edge.first / edge.distance), v1 = asinh(edge.last / edge.distance);
      const Real range = v1 - v0;
      const int count = std::clamp(static_cast<int>(std::ceil(range.approximate() / 2)), 1, 100000);
      for (int i = 0; i < count; ++i)
        panels.push_back({&edge, v0 + range * (2 * i + 1) / (2 * count), range / (2 * count), 0, {}, {}, 0});
    }
    return panels;
  }

  // Estimates the sizes of integrals. They decide how much work is spent, and are no part of the proof.
  void note_scale(const Panel& panel) {
    const WorkingBits rough(rough_bits);
    EdgeIntegrand<Real> f(*panel.edge, frame_.height, radial_);
    for (const int side : {-1, 0, 1}) {
      f.set(panel.middle + panel.half * side);
      const double common = panel.half.log2_size() + panel.edge->height.log2_size() + f.r.log2_size();
      const double y = std::max(f.y[0].log2_size(), f.y[1].log2_size());
      for_each_degree([&](int q, int m, std::size_t i) {
        const double size = common + m * std::max(y, -1e6) + f.table(m + 1, q).log2_size();
        if (size < HUGE_VAL) scale_[i] = std::max(scale_[i], size);
      });
    }
  }

  // The number of nodes for which the error's bound is small enough; nothing where there is no bound.
  std::optional<int> nodes_for(const Panel& panel) const {
    const double common = panel.half.log2_size() + panel.edge->height.log2_size() + 3;
    const double y = std::max(panel.y_bound[0].log2_size(), panel.y_bound[1].log2_size());
    double most = 0;
    for_each_degree([&](int, int m, std::size_t i) {
      if (scale_[i] == -HUGE_VAL) return;
      most = std::fmax(most, goal_ + common + m * std::max(y, -1e6) + panel.bounds[i].log2_size() - scale_[i]);
    });
    if (!(most < 1e9)) return std::nullopt;
    const int least = std::max(2, static_cast<int>(std::ceil(most / (2 * std::log2(panel.rho)))));
    const int step = least <= 32 ? 2 : 8;  // few rules, computed once
    return (least + step - 1) / step * step;
  }

  bool bound(Panel& panel, double semi_minor) const {
    const double b = semi_minor / panel.half.approximate();
    panel.rho = b + std::sqrt(b * b + 1);
    if (!std::isfinite(panel.rho) || !(panel.rho > 1)) return false;
    const WorkingBits rough(rough_bits);
    const Real rho = Real::exactly(panel.rho), inverse = Real(1) / rho;
    const Real major = panel.half * (rho + inverse) / 2, minor = panel.half * (rho - inverse) / 2;
    panel.bounds.assign(scale_.size(), Real(0));
    panel.y_bound = {Real(0), Real(0)};
    const auto raise = [](Real& to, const Real& by) { arb_max(to.raw(), to.raw(), by.raw(), MAG_BITS + 2); };
    EdgeIntegrand<Complex> f(*panel.edge, frame_.height, radial_);
    for (int box = 0; box < bound_boxes; ++box) {
      // The integrand at the conjugate is the conjugate: the upper half is enough.
      const Real re = (panel.middle + major * (2 * box + 1 - bound_boxes) / bound_boxes).widened(major / bound_boxes);
      f.set(Complex(re, (minor / 2).widened(minor / 2)));
      bool finite = true;
      for (int i = 0; i < 2; ++i) raise(panel.y_bound[i], upper_bound(f.y[i]));
      for_each_degree([&](int q, int m, std::size_t i) {
        raise(panel.bounds[i], upper_bound(f.table(m + 1, q) * f.r));
        finite = finite && panel.bounds[i].is_finite();
      });
      if (!finite) return false;
    }
    return true;
  }

  void refine(const Panel& panel, int depth, std::vector<Panel>& panels) {
    if (work_left_ < 0) return;
    Panel best;
    for (const double semi_minor : {1.3, 1.0, 0.6, 0.3}) {
      Panel tried = panel;
      spend(4 * bound_boxes, 1);
      if (!bound(tried, semi_minor)) continue;
      const auto nodes = nodes_for(tried);
      if (!nodes || (best.nodes != 0 && *nodes >= best.nodes)) break;
      tried.nodes = *nodes;
      best = std::move(tried);
    }
    if ((best.nodes == 0 || best.nodes > goal_ / 2 + 16) && depth < hopeless_depth) {
      for (const int side : {-1, 1}) {
        Panel part = panel;
        part.half = panel.half / 2;
        part.middle = panel.middle + part.half * side;
        refine(part, depth + 1, panels);
      }
      return;
    }
    if (best.nodes == 0) {
      best = panel;
      best.nodes = 2;
      best.rho = 0;  // no bound
    }
    panels.push_back(std::move(best));
  }

  void add(const Panel& panel) {
    Moments sum(range_);
    EdgeIntegrand<Real> f(*panel.edge, frame_.height, radial_);
    const auto rule = half_rule(panel.nodes, working_bits);
    Real weighted, power, term;
    for (std::size_t node = 0; node < rule->nodes.size(); ++node)
      for (const int side : {-1, 1}) {
        f.set(panel.middle + panel.half * rule->nodes[node] * side);
        const Real weight = f.r * rule->weights[node];
        monomials(f.y, monomials_);
        for_each_degree([&](int q, int m, std::size_t) {
          arb_mul(weighted.raw(), weight.raw(), f.table(m + 1, q).raw(), working_bits);
          for (int b = 0; b <= m; ++b) add_product(sum.at(m - b, b, q), weighted, monomials_[m * (m + 1) / 2 + b]);
        });
      }
    const Real factor = panel.edge->height * panel.half;
    const Real truncation = truncation_factor(panel);
    monomials(panel.y_bound, monomials_);
    for_each_degree([&](int q, int m, std::size_t i) {
      for (int b = 0; b <= m; ++b) {
        Real& moment = sum.at(m - b, b, q);
        Real error;
        if (panel.rho == 0) arb_indeterminate(error.raw());
        else error = truncation * panel.bounds[i] * monomials_[m * (m + 1) / 2 + b];
        add_product(result_.at(m - b, b, q), moment.widened(error), factor);
      }
    });
  }

  // n Gauss nodes on [-1, 1] are off by at most 64/15 M rho^(-2n) / (1 - rho^(-2)), n >= 2 (README.md).
  static Real truncation_factor(const Panel& panel) {
    if (panel.rho == 0) return Real(0);
    const Real inverse = Real(1) / Real::exactly(panel.rho);
    Real power;
    arb_pow_ui(power.raw(), inverse.raw(), static_cast<ulong>(2 * panel.nodes), working_bits);
    return power * 64 / 15 / (Real(1) - inverse * inverse);
  }

  // y1^a y2^b at (a+b)(a+b+1)/2 + b.
  void monomials(const std::array<Real, 2>& y, std::vector<Real>& out) const {
    const int top = range_.highest_degree();
    out.resize(static_cast<std::size_t>((top + 1) * (top + 2) / 2));
    out[0] = Real(1);
    for (int m = 1, at = 1; m <= top; ++m)
      for (int b = 0; b <= m; ++b, ++at) out[at] = b == 0 ? out[at - m] * y[0] : out[at - m - 1] * y[1];
  }

  const Frame& frame_;
  const MomentRange& range_;
  int goal_;
  double& work_left_;
  RadialRange radial_;
  Moments result_;
  std::vector<double> scale_;  // log2 of the largest contribution
  std::vector<Real> monomials_;
};

}  // namespace

void MomentRange::include(int degree, int q) {
  const auto index = static_cast<std::size_t>((q - lowest_q_) / 2);
  if (degrees_.size() <= index) degrees_.resize(index + 1, -1);
  degrees_[index] = std::max(degrees_[index], degree);
}

int MomentRange::highest_degree() const { return *std::ranges::max_element(degrees_); }

std::optional<Moments> integrate_moments(const Frame& frame, const MomentRange& range, int goal, double& work_left,
                                         std::size_t& nodes) {
  return Integrator(frame, range, goal, work_left).run(nodes);
}

}  // namespace cageproof::quadrature_ref::certified
