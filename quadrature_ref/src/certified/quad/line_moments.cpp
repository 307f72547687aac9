// SPDX-License-Identifier: MIT
#include "line_moments.h"

#include <algorithm>

namespace cageproof::quadrature_ref::certified {

LineMoments::LineMoments(const std::map<int, int>& degrees) {
  for (const auto& [q, wanted] : degrees) {
    const int degree = std::max(wanted, q + kLeastExcess);
    Table& table = tables_[q];
    even_ = q % 2 == 0;
    for (int j = 0; j <= degree; ++j) table.formulas.push_back(line_formula(degree - j, j, q));
    for (int d = 0; d <= degree; ++d) table.moments.emplace_back(d + 1);
    for (const LineFormula& formula : table.formulas)
      for (const auto& [product, factor] : formula.terms) {
        for (int i = 0; i < kLineSymbols; ++i) {
          powers_[i].lowest = std::min(powers_[i].lowest, product.powers[i]);
          powers_[i].highest = std::max(powers_[i].highest, product.powers[i]);
        }
        functions_ = std::max(functions_, product.function + 1);
        derivatives_ = std::max(derivatives_, product.derivative + 1);
      }
  }
}

Real LineMoments::sum_of(const LineFormula& formula, const std::vector<std::vector<Real>>& known) const {
  Real sum;
  for (const auto& [product, factor] : formula.terms) {
    Real term = product.function < 0 ? Real(1) : known[product.function][product.derivative];
    for (int i = 0; i < kLineSymbols; ++i)
      if (product.powers[i] != 0) term = term * powers_[i].values[product.powers[i] - powers_[i].lowest];
    sum += term * factor;
  }
  return sum / static_cast<int>(formula.denominator);
}

void LineMoments::set(const SeenLine& line) {
  const std::array<const Real*, kLineSymbols> symbols{&line.a, &line.b, &line.w, &line.S, &line.g};
  for (int i = 0; i < kLineSymbols; ++i) {
    Powers& p = powers_[i];
    p.values.assign(p.highest - p.lowest + 1, Real(1));
    for (int e = 1; e <= p.highest; ++e) p.values[e - p.lowest] = p.values[e - 1 - p.lowest] * *symbols[i];
    if (p.lowest == 0) continue;
    const Real inverse = Real(1) / *symbols[i];
    for (int e = -1; e >= p.lowest; --e) p.values[e - p.lowest] = p.values[e + 1 - p.lowest] * inverse;
  }
  std::vector<std::vector<Real>> known;
  if (even_) known.push_back(line_angles(line, derivatives_));
  else known = line_functions(line, functions_, derivatives_);
  for (auto& [q, table] : tables_) {
    auto& moments = table.moments;
    const int top = static_cast<int>(moments.size()) - 1;
    for (int j = 0; j <= top; ++j) moments[top][j] = sum_of(table.formulas[j], known);
    // (1-u) + u = 1.
    for (int d = top - 1; d >= 0; --d)
      for (int j = 0; j <= d; ++j) moments[d][j] = moments[d + 1][j] + moments[d + 1][j + 1];
  }
}

}  // namespace cageproof::quadrature_ref::certified
