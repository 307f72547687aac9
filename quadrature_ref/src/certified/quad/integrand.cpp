// SPDX-License-Identifier: MIT
#include "integrand.h"

#include "ball_vectors.h"

#include <algorithm>
#include <cstdlib>

namespace cageproof::quadrature_ref::certified {
namespace {

Real power_of(const Real& x, int exponent) {
  Real y;
  arb_pow_ui(y.raw(), x.raw(), static_cast<ulong>(std::abs(exponent)), working_bits);
  return exponent < 0 ? Real(1) / y : y;
}

Real smaller(const Real& a, const Real& b) {
  Real c;
  arb_min(c.raw(), a.raw(), b.raw(), working_bits);
  return c;
}

}  // namespace

QuadIntegrand::QuadIntegrand(const QuadKernel& kernel, int order, const std::vector<Real>& parameters, bool flat)
    : weights_(kernel.formula().shape.per_corner ? 2 : 1), constants_(kernel.constants(parameters)) {
  const int hat = kernel.formula().shape.per_corner ? 1 : 0;
  std::map<int, int> degrees;
  for (int o = 0; o <= order; ++o) {
    auto& entries = orders_.emplace_back();
    for (const auto& component : kernel.terms(o))
      for (const QuadPolynomial& derivative : component) {
        Entry& entry = entries.emplace_back();
        for (const auto& [with, polynomial] : derivative) {
          if (flat && with == QuadFactor::Height) continue;
          for (const auto& [m, factor] : polynomial.terms()) {
            if (m.constant != 0 && constants_[m.constant - 1].is_zero()) continue;
            const int degree = m.powers[0] + m.powers[1] + m.powers[2];
            const int top = degree + hat + (with == QuadFactor::One ? 0 : 1);
            degrees[m.q] = std::max(degrees[m.q], top);
            const int x = product(m.powers), y = weighted(m.q, with, degree + hat);
            entry.push_back({x, m.q, y, degree, factor, m.constant, with});
            cost_ += static_cast<double>(weights_) * (degree + 2);
          }
        }
      }
    auto& alike = alike_.emplace_back();
    for (const Entry& entry : entries) note_alike(entry, alike);
    values_.emplace_back(entries.size() * weights_);
  }
  moments_.emplace_back(degrees);
  x_.resize(products_.size());
  y_.resize(weighted_.size());
  // Moments come to as much as some sums; eight products take the time of a step of CertifiedEffort::most_work.
  cost_ = (cost_ + 100) / 8;
}

void QuadIntegrand::note_alike(const Entry& entry, std::map<Alike, Real>& alike) const {
  std::map<Alike, Real> sums;
  for (const Term& term : entry) {
    const bool height = term.with == QuadFactor::Height;
    Real size(std::abs(term.factor));
    if (term.constant != 0) size = upper_bound(constants_[term.constant - 1]) * size;
    sums[{term.degree + (height ? 1 : 0), term.q, term.with != QuadFactor::One}] += size;
  }
  for (const auto& [key, sum] : sums) arb_max(alike[key].raw(), alike[key].raw(), sum.raw(), working_bits);
}

int QuadIntegrand::product(const std::array<int, 3>& powers) {
  for (std::size_t i = 0; i < products_.size(); ++i)
    if (products_[i].powers == powers) return static_cast<int>(i);
  Product p{powers, -1, -1};
  for (int i = 0; i < 3 && p.without < 0; ++i)
    if (powers[i] > 0) {
      std::array<int, 3> less = powers;
      --less[i];
      p.coordinate = i;
      p.without = product(less);
    }
  products_.push_back(p);
  return static_cast<int>(products_.size()) - 1;
}

int QuadIntegrand::weighted(int q, QuadFactor with, int degree) {
  for (std::size_t i = 0; i < weighted_.size(); ++i)
    if (weighted_[i].q == q && weighted_[i].with == with && weighted_[i].degree == degree) return static_cast<int>(i);
  weighted_.push_back({q, with, degree});
  return static_cast<int>(weighted_.size()) - 1;
}

bool QuadIntegrand::vanishes(int order) const { return std::ranges::all_of(orders_[order], &Entry::empty); }

const std::vector<std::vector<Real>>& QuadIntegrand::operator()(const QuadStretch& stretch, const SeenQuad& quad,
                                                                const Real& t) {
  const std::array<Vector, 2> p{moved(stretch.ends[0], t, quad.across[0]), moved(stretch.ends[1], t, quad.across[1])};
  const Vector along = minus(p[1], p[0]);
  // N and N.x are linear along the line.
  std::array<std::array<Real, 2>, 5> factors;
  for (int u = 0; u < 2; ++u) {
    Vector normal = cross(along, quad.across[u]);
    for (int i = 0; i < 3; ++i) factors[static_cast<int>(QuadFactor::NormalX) + i][u] = std::move(normal[i]);
    factors[static_cast<int>(QuadFactor::Height)][u] = stretch.heights[u] + t * stretch.slopes[u];
  }
  SeenLine line;
  line.a = sqrt(dot(p[0], p[0]));
  line.b = sqrt(dot(p[1], p[1]));
  line.S = line.a + line.b;
  line.c = dot(along, along);
  line.g = dot(p[0], p[1]);
  const Vector perpendicular = cross(p[0], along);
  line.D = dot(perpendicular, perpendicular);
  const Real ab = line.a * line.b;
  line.w = arb_is_negative(line.g.raw()) != 0 ? line.D / (ab - line.g) : ab + line.g;
  LineMoments& moments = moments_.front();
  moments.set(line);
  for (std::size_t i = 0; i < products_.size(); ++i) {
    const Product& product = products_[i];
    if (product.without < 0) {
      x_[i] = {Real(1)};
      continue;
    }
    const auto& less = x_[product.without];
    x_[i].assign(less.size() + 1, Real(0));
    for (std::size_t j = 0; j < less.size(); ++j)
      for (int u = 0; u < 2; ++u) add_product(x_[i][j + u], less[j], p[u][product.coordinate]);
  }
  for (std::size_t i = 0; i < weighted_.size(); ++i) {
    const Weighted& weighted = weighted_[i];
    if (weighted.with == QuadFactor::One) {
      y_[i] = moments(weighted.q, weighted.degree);
      continue;
    }
    const auto& higher = moments(weighted.q, weighted.degree + 1);
    y_[i].assign(weighted.degree + 1, Real(0));
    for (int j = 0; j <= weighted.degree; ++j)
      for (int u = 0; u < 2; ++u) add_product(y_[i][j], factors[static_cast<int>(weighted.with)][u], higher[j + u]);
  }
  Real part;
  for (std::size_t o = 0; o < orders_.size(); ++o)
    for (std::size_t e = 0; e < orders_[o].size(); ++e)
      for (std::size_t weight = 0; weight < weights_; ++weight) {
        Real& sum = values_[o][e * weights_ + weight];
        sum = Real(0);
        for (const Term& term : orders_[o][e]) {
          const auto& x = x_[term.x];
          const auto& y = y_[term.y];
          part = Real(0);
          for (std::size_t j = 0; j < x.size(); ++j) add_product(part, x[j], y[j + weight]);
          part = part * term.factor;
          if (term.constant == 0) sum += part;
          else add_product(sum, part, constants_[term.constant - 1]);
        }
      }
  return values_;
}

Real QuadIntegrand::bound(int order, const LineBounds& line) const {
  const Real more = Real(1) + line.kappa, less = Real(1) - line.kappa;
  // int |x|^(-s) du along the middle's line, where |x|^2 >= nearest^2 + length^2 (u - u_nearest)^2.
  const auto integral = [&](int s) {
    if (s <= 0) return power_of(line.farthest, -s);
    Real height = power_of(line.nearest, -s);
    if (s < 2 || line.length.is_zero()) return height;
    return smaller(height, pi_ball() * power_of(line.nearest, 1 - s) / line.length);
  };
  Real sum;
  for (const auto& [alike, factors] : alike_[order]) {
    Real bound = power_of(more, alike.of_x) * integral(alike.q - alike.of_x) * factors;
    bound = alike.q < 0 ? bound * power_of(more, -alike.q) : bound / power_of(less, alike.q);
    sum += alike.normal ? bound * line.normal : bound;
  }
  return upper_bound(sum);
}

}  // namespace cageproof::quadrature_ref::certified
