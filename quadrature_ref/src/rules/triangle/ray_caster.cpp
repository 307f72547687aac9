// SPDX-License-Identifier: MIT
#include "polar_cells.h"

namespace cageproof::quadrature_ref {
namespace {

// The ends of a cell's range of w, tau = distance sinh w, on a ray that meets the edge at w_edge.
template <Scalar W>
void w_range(const PolarCell& cell, const W& w_edge, W& w_lo, W& w_hi) {
  if (cell.reaches_edge) {
    const W length = w_edge - cell.w_lo;
    w_lo = cell.w_lo + length * cell.lower;
    w_hi = cell.w_lo + length * cell.upper;
  } else {
    w_lo = cell.w_lo;
    w_hi = cell.w_hi;
  }
}

template <Scalar W>
RadialPoint<W> radial_point(const W& distance, const W& w, const W& weight) {
  W sinh_w, cosh_w;
  sinh_cosh(w, sinh_w, cosh_w);
  const W tau = distance * sinh_w;
  return {tau, weight * tau * distance * cosh_w};
}

// The n-point Gauss-Legendre rule in w on [w_lo, w_hi], tau = distance sinh w.
template <Scalar W>
void radial_rule(const W& distance, const W& w_lo, const W& w_hi, int n, std::vector<RadialPoint<W>>& points) {
  const GaussNodes<W>& rule = gauss_nodes<W>(n);
  const W length = w_hi - w_lo;
  points.resize(n);
  for (int j = 0; j < n; ++j)
    points[j] = radial_point(distance, W(w_lo + length * rule.nodes[j]), W(length * rule.weights[j]));
}

}  // namespace

template <Scalar W>
W RayCaster<W>::aim(const PolarEdge<W>& edge, const W& t, W& cosh_v) {
  W sinh_v, sinh_half, cosh_half;
  sinh_cosh(W(edge.v0 + t), sinh_v, cosh_v);
  for (int i = 0; i < 3; ++i) direction_[i] = (edge.nu[i] + edge.u[i] * sinh_v) / cosh_v;
  const W radius = edge.a * cosh_v;
  // Slopes of the hat functions, from their values at c and at the edge: gradients over a thin triangle would cancel.
  const W half = t / 2;
  sinh_cosh(half, sinh_half, cosh_half);
  W sinh_middle, cosh_middle;
  sinh_cosh(W(edge.v0 + half), sinh_middle, cosh_middle);
  const W fraction = edge.relative_height * cosh_middle * sinh_half;
  const int first = edge.start, second = (first + 1) % 3, third = (first + 2) % 3;
  slope_[first] = (1 - fraction - frame_.hat[first]) / radius;
  slope_[second] = (fraction - frame_.hat[second]) / radius;
  slope_[third] = -frame_.hat[third] / radius;
  return inverse_sinh(W(radius / frame_.distance));
}

template <Scalar W>
void RayCaster<W>::aim_around(const W& angle) {
  using std::cos, std::sin;
  const W c = cos(angle), s = sin(angle);
  for (int i = 0; i < 3; ++i) direction_[i] = frame_.along[i] * c + frame_.across[i] * s;
  for (int k = 0; k < 3; ++k) slope_[k] = frame_.slope_along[k] * c + frame_.slope_across[k] * s;
}

template <Scalar W>
void RayCaster<W>::cast(std::span<const RadialPoint<W>> points, const W& weight, Result<W>& sums) {
  static thread_local std::vector<Node<W>> nodes;
  set_flat(nodes, points.size(), frame_.normal, frame_.height, log_of_unit<W>(frame_.exponent));
  for (std::size_t j = 0; j < points.size(); ++j) {
    Node<W>& node = nodes[j];
    const W& tau = points[j].tau;
    for (int i = 0; i < 3; ++i) node.x[i] = frame_.base[i] + tau * direction_[i];
    for (int k = 0; k < 3; ++k) node.hat[k] = frame_.hat[k] + tau * slope_[k];
    node.weight = weight * points[j].weight;
  }
  kernel_.accumulate(nodes, task_, sums);
  sums.nodes += points.size();
}

template <Scalar W>
W RayCaster<W>::t_length(const PolarCell& cell) const {
  if (cell.edge < 0) return 2 * pi<W>();
  return (cell.last ? frame_.edges[cell.edge].v_length : W(cell.t_hi)) - cell.t_lo;
}

template <Scalar W>
void RayCaster<W>::add_cell(const PolarCell& cell, CellPoints points, Result<W>& sums) {
  static thread_local std::vector<RadialPoint<W>> radial;
  W w_lo, w_hi, cosh_v;
  if (!cell.reaches_edge) {
    w_range(cell, W(0), w_lo, w_hi);
    radial_rule(frame_.distance, w_lo, w_hi, points.w, radial);
  }
  if (cell.edge < 0) {
    const W step = 2 * pi<W>() / points.t;
    for (int i = 0; i < points.t; ++i) {
      aim_around(W(step * i));
      cast(radial, step, sums);
    }
    return;
  }
  const GaussNodes<W>& rule = gauss_nodes<W>(points.t);
  const W length = t_length(cell);
  for (int i = 0; i < points.t; ++i) {
    const W w_edge = aim(frame_.edges[cell.edge], W(cell.t_lo + length * rule.nodes[i]), cosh_v);
    if (cell.reaches_edge) {
      w_range(cell, w_edge, w_lo, w_hi);
      radial_rule(frame_.distance, w_lo, w_hi, points.w, radial);
    }
    cast(radial, W(length * rule.weights[i] / cosh_v), sums);
  }
}

template <Scalar W>
std::array<double, 3> RayCaster<W>::log10_mass(const PolarCell& cell) {
  std::array<double, 3> mass;
  mass.fill(-std::numeric_limits<double>::infinity());
  Result<W> sample;
  const W length = t_length(cell);
  W cosh_v = 1, w_lo, w_hi;
  for (int i = 0; i < 3; ++i) {
    const W t = cell.t_lo + length * i / 2;
    W w_edge = 0;
    if (cell.edge < 0) aim_around(t);
    else w_edge = aim(frame_.edges[cell.edge], t, cosh_v);
    w_range(cell, w_edge, w_lo, w_hi);
    const W w_length = w_hi - w_lo;
    for (int j = 0; j < 3; ++j) {
      const RadialPoint<W> point = radial_point(frame_.distance, W(w_lo + w_length * j / 2), w_length);
      integrand_.reset(sample, task_.order);
      cast({&point, 1}, W(length / cosh_v), sample);
      for (int order = 0; order <= task_.order; ++order)
        mass[order] = std::max(mass[order], log10_norm(sample.of(order)));
    }
  }
  return mass;
}

template class RayCaster<double>;
template class RayCaster<Mp50>;
template class RayCaster<Mp100>;
template class RayCaster<Mp200>;

}  // namespace cageproof::quadrature_ref
