// SPDX-License-Identifier: MIT
#include "quad_caster.h"

namespace cageproof::quadrature_ref {

template <Scalar W>
typename QuadCaster<W>::Radius QuadCaster<W>::radius(const QuadCell& cell, const W& w_range, const W& fraction) const {
  const W cell_length = W(cell.w_hi) - W(cell.w_lo);
  W sinh_w, cosh_w;
  sinh_cosh(W(w_range * (W(cell.w_lo) + fraction * cell_length)), sinh_w, cosh_w);
  const W delta = cell.delta;
  Radius r;
  r.rho = delta * sinh_w;
  r.square = r.rho * r.rho;
  r.weight = r.rho * delta * cosh_w * w_range * cell_length;
  return r;
}

// Turns to the direction at a fraction of the cell's range of tau.
template <Scalar W>
void QuadCaster<W>::aim(const QuadSector<W>& sector, const QuadCell& cell, const W& fraction) {
  const W cell_length = W(cell.t_hi) - W(cell.t_lo);
  W sinh_tau, cosh_tau;
  sinh_cosh(W(sector.tau + sector.tau_length * (W(cell.t_lo) + fraction * cell_length)), sinh_tau, cosh_tau);
  const W s = sector.eps * sinh_tau;
  ray_weight_ = sector.jacobian * sector.eps * cosh_tau * sector.tau_length * cell_length;
  du_ = sector.du + s * sector.step_u;
  dv_ = sector.dv + s * sector.step_v;
  duv_ = du_ * dv_;
  for (int i = 0; i < 3; ++i) {
    direction_[i] = sector.to_edge[i] + s * sector.edge[i];
    bend_[i] = duv_ * frame_.at.twist[i];
  }
}

template <Scalar W>
void QuadCaster<W>::set_node(const Radius& radius, const W& weight, Node<W>& node) const {
  frame_.at.set_surface(W(radius.rho * du_), W(radius.rho * dv_), W(radius.square * duv_), node);
  // A d_u + B d_v cancels in thin quads; `direction_` does not.
  for (int i = 0; i < 3; ++i) node.x[i] = frame_.at.base[i] + radius.rho * direction_[i] + radius.square * bend_[i];
  node.weight = weight;
  node.log_unit = log_unit_;
}

template <Scalar W>
void QuadCaster<W>::add_cell(const QuadCell& cell, QuadPoints points, Result<W>& sums) {
  const GaussNodes<W>& t_rule = gauss_nodes<W>(points.t);
  const GaussNodes<W>& w_rule = gauss_nodes<W>(points.w);
  const W w_range = inverse_sinh(W(1 / W(cell.delta)));
  std::vector<Radius> radii;
  for (int j = 0; j < points.w; ++j) {
    radii.push_back(radius(cell, w_range, w_rule.nodes[j]));
    radii.back().weight *= w_rule.weights[j];
  }
  nodes_.resize(points.w);
  for (int i = 0; i < points.t; ++i) {
    aim(frame_.sectors[cell.sector], cell, t_rule.nodes[i]);
    const W across = ray_weight_ * t_rule.weights[i];
    for (int j = 0; j < points.w; ++j) set_node(radii[j], W(across * radii[j].weight), nodes_[j]);
    kernel_.accumulate(nodes_, task_, sums);
  }
  sums.nodes += static_cast<std::size_t>(points.t) * points.w;
}

template <Scalar W>
std::array<double, 3> QuadCaster<W>::log10_mass(const QuadCell& cell) {
  std::array<double, 3> mass;
  mass.fill(-std::numeric_limits<double>::infinity());
  const W w_range = inverse_sinh(W(1 / W(cell.delta)));
  Result<W> sample;
  nodes_.resize(1);
  for (int i = 0; i < 3; ++i) {
    aim(frame_.sectors[cell.sector], cell, W(W(i) / 2));
    for (int j = 0; j < 3; ++j) {
      // Not at rho = 0, where the area element vanishes with the largest integrand.
      const Radius r = radius(cell, w_range, W((W(j) + W(1) / 8) / W(2.125)));
      set_node(r, W(ray_weight_ * r.weight), nodes_[0]);
      integrand_.reset(sample, task_.order);
      kernel_.accumulate(nodes_, task_, sample);
      for (int o = 0; o <= task_.order; ++o) mass[o] = std::max(mass[o], log10_norm(sample.of(o)));
    }
  }
  return mass;
}

template <Scalar W>
double QuadCaster<W>::cancellation(const QuadCell& cell) {
  const auto size = [](const Vec3<W>& v) {
    return std::hypot(static_cast<double>(v[0]), static_cast<double>(v[1]), static_cast<double>(v[2]));
  };
  const auto magnitude = [](const W& x) { return std::abs(static_cast<double>(x)); };
  const W w_range = inverse_sinh(W(1 / W(cell.delta)));
  const auto& at = frame_.at;
  const QuadSector<W>& sector = frame_.sectors[cell.sector];
  nodes_.resize(1);
  double of_positions = 1, terms = 0, normals = 0;
  for (int i = 0; i < 3; ++i) {
    aim(sector, cell, W(W(i) / 2));
    const double step = size(sector.edge) > 0 ? size(Vec3<W>(direction_ - sector.to_edge)) / size(sector.edge) : 0;
    const double du = magnitude(sector.du) + step * magnitude(sector.step_u),
                 dv = magnitude(sector.dv) + step * magnitude(sector.step_v);
    const double direction = size(sector.to_edge) + step * size(sector.edge), bend = du * dv * size(at.twist);
    for (int j = 0; j < 3; ++j) {
      const Radius r = radius(cell, w_range, W(W(j) / 2));
      set_node(r, W(1), nodes_[0]);
      const double rho = magnitude(r.rho);
      const double position = size(at.base) + rho * (direction + rho * bend);
      of_positions = std::max(of_positions, position / size(nodes_[0].x));
      terms = std::max(terms, size(at.normal) + rho * (du * size(at.normal_u) + dv * size(at.normal_v)));
      normals = std::max(normals, size(nodes_[0].normal));
    }
  }
  return normals > 0 ? std::max(of_positions, terms / normals) : of_positions;
}

template class QuadCaster<double>;
template class QuadCaster<Mp50>;
template class QuadCaster<Mp100>;
template class QuadCaster<Mp200>;

}  // namespace cageproof::quadrature_ref
