// SPDX-License-Identifier: MIT
#include "enclose.h"

#include "../gauss_nodes.h"
#include "panels.h"

namespace cageproof::quadrature_ref::certified {
namespace {

// An order's integrals along lines, integrated across them: [weight of v][...], weights 1 - v and v, or one that is 1.
using Across = std::array<std::vector<Real>, 2>;

void add_panel(const QuadPanel& panel, const SeenQuad& quad, QuadIntegrand& integrand, std::vector<Across>& sums) {
  const auto rule = half_rule(panel.nodes, working_bits);
  const bool weighted = integrand.weights() == 2;
  for (std::size_t node = 0; node < rule->nodes.size(); ++node)
    for (const int side : {-1, 1}) {
      const Real t = panel.stretch.half * rule->nodes[node] * side;
      const auto& values = integrand(panel.stretch, quad, t);
      const Real weight = panel.stretch.half * rule->weights[node];
      const Real v = (panel.stretch.middle + t) * weight;
      const std::array<Real, 2> weights{weighted ? weight - v : weight, v};
      for (int o = 0; o < integrand.orders(); ++o)
        for (int w = 0; w < (weighted ? 2 : 1); ++w)
          for (std::size_t i = 0; i < values[o].size(); ++i) add_product(sums[o][w][i], values[o][i], weights[w]);
    }
  for (int o = 0; o < integrand.orders(); ++o)
    for (auto& sum : sums[o])
      for (Real& x : sum) x = x.widened(panel.errors[o]);
}

// Corner by corner: corners 0 to 3 have u = 0, 1, 1, 0 and v = 0, 0, 1, 1.
std::vector<Real> tensor_of(const Across& sums, const Formula& formula, int order, std::size_t weights) {
  constexpr std::array<std::size_t, 4> along{0, 1, 1, 0}, across{0, 0, 1, 1};
  const std::size_t derivatives = order == 0 ? 1 : order == 1 ? 3 : 6;
  const std::size_t entries = static_cast<std::size_t>(formula.shape.entries()) * derivatives;
  // Places in a Hessian's upper half, row by row.
  constexpr std::array<std::size_t, 9> of_half{0, 1, 2, 1, 3, 4, 2, 4, 5};
  std::vector<Real> tensor;
  for (int corner = 0; corner < formula.tensors(); ++corner)
    for (std::size_t first = 0; first < entries; first += derivatives)
      for (std::size_t i = 0; i < (order == 2 ? 9 : derivatives); ++i) {
        const std::size_t entry = first + (order == 2 ? of_half[i] : i);
        tensor.push_back(weights == 1 ? sums[0][entry] : sums[across[corner]][entry * weights + along[corner]]);
      }
  return tensor;
}

}  // namespace

template <Scalar R>
std::optional<QuadEnclosure> enclose_quad(std::string_view formula, const Query<R>& query, int goal,
                                          double& work_left) {
  const QuadKernel& kernel = quad_kernel_of(formula);
  const auto quad = seen_quad(query);
  if (!quad) return std::nullopt;
  std::vector<Real> parameters;
  for (const R& p : query.parameters) parameters.push_back(Real::exactly(p));
  QuadIntegrand integrand(kernel, query.order, parameters, quad->flat);
  const auto panels = quad_panels(*quad, integrand, goal, work_left);
  if (!panels) return std::nullopt;
  QuadEnclosure found;
  for (const QuadPanel& panel : *panels) found.nodes += static_cast<std::size_t>(panel.nodes);
  const double words = static_cast<double>(working_bits) / 64;
  work_left -= static_cast<double>(found.nodes) * integrand.cost() * (1 + words * std::sqrt(words) / 8);
  if (work_left < 0) return std::nullopt;
  std::vector<Across> sums(integrand.orders());
  for (int o = 0; o < integrand.orders(); ++o)
    for (auto& sum : sums[o]) sum.resize(integrand.size(o));
  for (const QuadPanel& panel : *panels) add_panel(panel, *quad, integrand, sums);
  for (int o = 0; o < integrand.orders(); ++o)
    found.tensors[o] = tensor_of(sums[o], kernel.formula(), o, integrand.weights());
  return found;
}

#define CAGEPROOF_INSTANTIATE(R) \
  template std::optional<QuadEnclosure> enclose_quad<R>(std::string_view, const Query<R>&, int, double&);
CAGEPROOF_INSTANTIATE(float)
CAGEPROOF_INSTANTIATE(double)
CAGEPROOF_INSTANTIATE(Mp50)
CAGEPROOF_INSTANTIATE(Mp100)
CAGEPROOF_INSTANTIATE(Mp200)
#undef CAGEPROOF_INSTANTIATE

std::vector<std::string> formulas_enclosed_on_quads() {
  std::vector<std::string> names;
  for (const QuadKernel& kernel : quad_kernels()) names.emplace_back(kernel.formula().name);
  return names;
}

}  // namespace cageproof::quadrature_ref::certified
