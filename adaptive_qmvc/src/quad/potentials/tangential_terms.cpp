// SPDX-License-Identifier: MIT
// Derivatives along the quad, moved onto the basis functions and the border. For P a product of basis functions and of
// what is polynomial in u and v, and f any function of x = xi - eta,
//
//   int P (N x grad f) du dv = around the border P f dl - int C[P] f du dv,   C[P] = xi_v dP/du - xi_u dP/dv.
//
// First where N stands in the kernel, exactly: N_a d_a d_j f = eps_laj (N x grad)_l d_a f + N_j Laplace f. Then in
// coordinates whose z axis is the normal n at the point that lines are taken about, N = n z + M: d_x f and d_y f are
// components of N x grad f over n, less what M, which vanishes at that point, adds; and d_z d_z f follows from the
// Laplacian.
#include "line_terms.h"

#include <initializer_list>
#include <map>
#include <span>

namespace cageproof::adaptive_qmvc {
namespace {

using namespace line_factor;

// The weight of a function of x.
struct Weight {
  double factor = 1;
  LineTerm of;  // without x and r
};
using Weights = std::vector<Weight>;

const Weights kPhi{Weight{}};

// Component l of C for a weight that consists of basis functions, xi_u and xi_v.
Weights tangential_derivative(const Weights& weights, int l) {
  Weights result;
  const auto add = [&](double factor, const LineTerm& of, int further) {
    result.push_back({factor, of.times(further)});
  };
  // The derivative of a weight by u or by v, times -+ xi_v or xi_u.
  const auto derive = [&](const Weight& weight, bool by_u) {
    const int direction = (by_u ? kAlongV : kAlongU) + l;
    const double factor = by_u ? weight.factor : -weight.factor;
    const BasisPart basis = weight.of.basis;
    const bool is_done = basis == BasisPart::PhiUV || basis == (by_u ? BasisPart::PhiU : BasisPart::PhiV);
    if (!is_done) {
      LineTerm of = weight.of;
      of.basis = basis == BasisPart::Phi ? (by_u ? BasisPart::PhiU : BasisPart::PhiV) : BasisPart::PhiUV;
      add(factor, of, direction);
    }
    // d xi_v/du = d xi_u/dv = w.
    const int changes = by_u ? kAlongV : kAlongU;
    for (const int other : weight.of.others)
      if (other >= changes && other < changes + 3) {
        LineTerm of = weight.of;
        *std::ranges::find(of.others, other) = kTwist + other - changes;
        std::ranges::sort(of.others);
        add(factor, of, direction);
      }
  };
  for (const Weight& weight : weights) {
    derive(weight, true);
    derive(weight, false);
  }
  return result;
}

Weights times(const Weights& weights, int factor, double by) {
  Weights result;
  for (const Weight& weight : weights) result.push_back({by * weight.factor, weight.of.times(factor)});
  return result;
}

// A derivative by x of 1/r, or of r: how often by each component.
struct Radial {
  bool biharmonic = false;
  std::array<int, 3> by{0, 0, 0};

  Radial derived(int i) const {
    Radial more = *this;
    ++more.by[i];
    return more;
  }
  Radial without(int i, int times = 1) const {
    Radial less = *this;
    less.by[i] -= times;
    return less;
  }
};

struct PowerTerm {
  std::array<std::int8_t, 3> power;
  int m;
  auto operator<=>(const PowerTerm&) const = default;
};

std::map<PowerTerm, double> terms_of(const Radial& radial) {
  std::map<PowerTerm, double> terms{{{{0, 0, 0}, radial.biharmonic ? -1 : 0}, 1}};
  for (int i = 0; i < 3; ++i)
    for (int n = 0; n < radial.by[i]; ++n) {
      std::map<PowerTerm, double> derived;
      for (const auto& [term, factor] : terms) {
        PowerTerm further = term, less = term;
        ++further.m;
        ++further.power[i];
        derived[further] -= (2 * term.m + 1) * factor;
        if (--less.power[i] >= 0) derived[less] += term.power[i] * factor;
      }
      terms = std::move(derived);
    }
  return terms;
}

// Where sums are added to, with the coefficients of both parameters.
struct Sum {
  LineTerms& terms;
  Factors factors;

  Sum by(double factor) const { return {terms, {factor * factors[0], factor * factors[1]}}; }

  // int weights f
  void add(const Weights& weights, const Radial& f, double factor, bool around = false, bool divided = false) const {
    for (const auto& [term, radial] : terms_of(f))
      for (const Weight& weight : weights) {
        LineTerm to = weight.of;
        to.m = term.m;
        to.power = term.power;
        to.around = around;
        to.divided = divided;
        add_to(terms, to, factors, factor * radial * weight.factor);
      }
  }

  // int weights (N x grad f)_l, over the normal's length where that is asked for.
  void add_tangential(const Weights& weights, const Radial& f, int l, double factor, bool divided) const {
    add(times(weights, kStep + l, 1), f, factor, true, divided);
    add(tangential_derivative(weights, l), f, -factor, false, divided);
  }

  // int weights f for a third derivative of 1/r's size: as one of the second, or multiplied with M.
  void add_frozen(const Weights& weights, const Radial& f, double factor) const {
    if (f.by[0] > 0 || f.by[1] > 0) {
      // (N x grad f)_y = (n + M_z) d_x f - M_x d_z f, (N x grad f)_x = M_y d_z f - (n + M_z) d_y f
      const bool is_x = f.by[0] > 0;
      const int axis = is_x ? 0 : 1;
      const double sign = is_x ? factor : -factor;
      const Radial less = f.without(axis);
      add_tangential(weights, less, is_x ? 1 : 0, sign, true);
      add(times(weights, kTurn + 2, 1), f, -factor, false, true);
      add(times(weights, kTurn + axis, 1), less.derived(2), factor, false, true);
      return;
    }
    // d_z d_z = Laplace - d_x d_x - d_y d_y, and the Laplacian of r is 2/r.
    const Radial less = f.without(2, 2);
    add_frozen(weights, less.derived(0).derived(0), -factor);
    add_frozen(weights, less.derived(1).derived(1), -factor);
    if (f.biharmonic) add_frozen(weights, {false, less.by}, 2 * factor);
  }
};

double permutation(int i, int j, int k) { return (j - i) * (k - j) * (k - i) / 2.; }

// A gradient by eta whose only terms are int C_l f and border integrals of f dl_l, f a derivative of order n, and its
// own gradients: unchanged for one order more, frozen for two.
struct Curls {
  struct Term {
    int l;
    Radial f;
    Factors factors;
  };
  std::vector<Term> terms;  // of int Phi (N x grad f)_l

  // The terms' derivatives by eta.
  void add(LineTerms& to, std::span<const int> derived) const {
    const double sign = derived.size() % 2 == 0 ? 1 : -1;
    for (const Term& term : terms) {
      Radial f = term.f;
      for (const int i : derived) f = f.derived(i);
      const Sum sum{to, term.factors};
      const int order = f.by[0] + f.by[1] + f.by[2] - (f.biharmonic ? 2 : 0);
      if (order < 2) {
        sum.add_tangential(kPhi, f, term.l, sign, false);
      } else {
        sum.add(times(kPhi, kStep + term.l, 1), f, sign, true);
        sum.by(-sign).add_frozen(tangential_derivative(kPhi, term.l), f, 1);
      }
    }
  }
};

}  // namespace

bool make_tangential(Potential potential, int order, TapeEntries& entries) {
  const auto radial = [](bool biharmonic, std::initializer_list<int> by) {
    Radial f{biharmonic, {0, 0, 0}};
    for (const int i : by) f = f.derived(i);
    return f;
  };
  switch (potential) {
    case Potential::SingleLayer:
      if (order < 2) return false;
      for (int i = 0; i < 3; ++i)
        for (int j = 0; j < 3; ++j) {
          LineTerms& to = entries[2][3 * i + j];
          to.clear();
          Sum{to, {1, 0}}.add_frozen(kPhi, radial(false, {i, j}), 1);
        }
      return true;
    case Potential::KelvinDisplacement:
      // I/r + x x'/r^3 - I/r, where x x'/r^3 = I/r - grad grad r.
      if (order < 2) return false;
      for (int e = 0; e < 9; ++e)
        for (int i = 0; i < 3; ++i)
          for (int j = 0; j < 3; ++j) {
            LineTerms& to = entries[2][9 * e + 3 * i + j];
            to.clear();
            if (e / 3 == e % 3) Sum{to, {1, 1}}.add_frozen(kPhi, radial(false, {i, j}), 1);
            Sum{to, {0, 1}}.add_frozen(kPhi, radial(true, {e / 3, e % 3, i, j}), -1);
          }
      return true;
    case Potential::DoubleLayer:
      if (order < 1) return false;
      // d/d eta_j of -N_a d_a 1/r: eps_laj (N x grad)_l d_a 1/r.
      for (int j = 0; j < 3; ++j) {
        Curls curls;
        for (int l = 0; l < 3; ++l)
          for (int a = 0; a < 3; ++a)
            if (const double sign = permutation(l, a, j); sign != 0)
              curls.terms.push_back({l, radial(false, {a}), {sign, 0}});
        entries[1][j].clear();
        curls.add(entries[1][j], {});
        for (int i = 0; order >= 2 && i < 3; ++i) {
          LineTerms& to = entries[2][3 * j + i];
          to.clear();
          const std::array derived{i};
          curls.add(to, derived);
        }
      }
      return true;
    case Potential::KelvinTraction:
      if (order < 1) return false;
      for (int e = 0; e < 9; ++e) {
        const int i = e / 3, j = e % 3;
        // -delta_ij N_a d_a 1/r + eps_lji (N x grad)_l 1/r + 2 beta eps_laj (N x grad)_l d_a d_i r, of whose parameters
        // the first is 1 - 2 beta and the second 6 beta.
        constexpr Factors kOne{1, 1. / 3}, kTwoBeta{0, 1. / 3};
        Curls shear;
        for (int l = 0; l < 3; ++l) {
          if (const double sign = permutation(l, j, i); sign != 0)
            shear.terms.push_back({l, radial(false, {}), {sign * kOne[0], sign * kOne[1]}});
          for (int a = 0; a < 3; ++a)
            if (const double sign = permutation(l, a, j); sign != 0)
              shear.terms.push_back({l, radial(true, {a, i}), {sign * kTwoBeta[0], sign * kTwoBeta[1]}});
        }
        for (int p = 0; p < 3; ++p) {
          // The gradient of the double layer, from the first term.
          Curls pressure;
          for (int l = 0; l < 3 && i == j; ++l)
            for (int a = 0; a < 3; ++a)
              if (const double sign = permutation(l, a, p); sign != 0)
                pressure.terms.push_back({l, radial(false, {a}), {sign * kOne[0], sign * kOne[1]}});
          LineTerms& gradient = entries[1][3 * e + p];
          gradient.clear();
          const std::array first{p};
          pressure.add(gradient, {});
          shear.add(gradient, first);
          for (int q = 0; order >= 2 && q < 3; ++q) {
            LineTerms& hessian = entries[2][9 * e + 3 * p + q];
            hessian.clear();
            const std::array second{q};
            const std::array both{p, q};
            pressure.add(hessian, second);
            shear.add(hessian, both);
          }
        }
      }
      return true;
    default: return false;
  }
}

}  // namespace cageproof::adaptive_qmvc
