// SPDX-License-Identifier: MIT
// Enclosures of int_0^1 (1-u)^i u^j r^(-q) du along a line, for all i + j = degree.
#pragma once

#include "line_formulas.h"
#include "line_functions.h"

#include <map>
#include <vector>

namespace cageproof::quadrature_ref::certified {

/// The integrals of some powers q, each up to a degree.
class LineMoments {
 public:
  /// \param degrees the highest degree per power q, for which a line_formula of that degree or more exists. \pre all q
  /// are odd, or all even
  explicit LineMoments(const std::map<int, int>& degrees);
  /// At the working_bits.
  void set(const SeenLine& line);
  /// Entry j has u^j. \pre 0 <= degree <= the highest of q
  const std::vector<Real>& operator()(int q, int degree) const { return tables_.at(q).moments[degree]; }

 private:
  struct Table {
    std::vector<LineFormula> formulas;       // of the highest degree, by j
    std::vector<std::vector<Real>> moments;  // [degree][j]
  };
  // Powers of one of the symbols, from the lowest to the highest.
  struct Powers {
    int lowest = 0, highest = 0;
    std::vector<Real> values;
  };
  Real sum_of(const LineFormula& formula, const std::vector<std::vector<Real>>& known) const;

  std::map<int, Table> tables_;
  std::array<Powers, kLineSymbols> powers_;
  bool even_ = false;
  int functions_ = 0, derivatives_ = 0;
};

}  // namespace cageproof::quadrature_ref::certified
