// SPDX-License-Identifier: MIT
#include "kernel_terms.h"

namespace cageproof::quadrature_ref::certified {

void Polynomial::add(const Monomial& monomial, int factor) {
  const auto [at, fresh] = terms_.try_emplace(monomial, 0);
  at->second += factor;
  if (at->second == 0) terms_.erase(at);
}

Polynomial Polynomial::derivative(int i) const {
  Polynomial result;
  for (const auto& [monomial, factor] : terms_) {
    if (monomial.powers[i] > 0) {
      Monomial lower = monomial;
      --lower.powers[i];
      result.add(lower, -factor * monomial.powers[i]);
    }
    if (monomial.q != 0) {
      Monomial steeper = monomial;
      ++steeper.powers[i];
      steeper.q += 2;
      result.add(steeper, factor * monomial.q);
    }
    if (monomial.logarithms != 0) {
      Monomial without = monomial;
      --without.logarithms;
      ++without.powers[i];
      without.q += 2;
      result.add(without, -factor * monomial.logarithms);
    }
  }
  return result;
}

Polynomial operator+(const Polynomial& a, const Polynomial& b) {
  Polynomial sum = a;
  for (const auto& [monomial, factor] : b.terms_) sum.add(monomial, factor);
  return sum;
}

Polynomial operator*(const Polynomial& a, const Polynomial& b) {
  Polynomial product;
  for (const auto& [m, f] : a.terms_)
    for (const auto& [n, g] : b.terms_) {
      Monomial both;
      for (int i = 0; i < 3; ++i) both.powers[i] = m.powers[i] + n.powers[i];
      both.q = m.q + n.q;
      both.logarithms = m.logarithms + n.logarithms;
      both.constant = m.constant + n.constant;
      product.add(both, f * g);
    }
  return product;
}

Polynomial operator*(int factor, const Polynomial& a) {
  Polynomial product;
  for (const auto& [monomial, f] : a.terms_) product.add(monomial, factor * f);
  return product;
}

Polynomial coordinate(int i) {
  Monomial m;
  m.powers[i] = 1;
  return Polynomial(m);
}

Polynomial inverse_distance(int q) {
  Monomial m;
  m.q = q;
  return Polynomial(m);
}

Polynomial logarithm() {
  Monomial m;
  m.logarithms = 1;
  return Polynomial(m);
}

Polynomial constant(int number) {
  Monomial m;
  m.constant = number;
  return Polynomial(m);
}

}  // namespace cageproof::quadrature_ref::certified
