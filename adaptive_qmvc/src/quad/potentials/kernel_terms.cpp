// SPDX-License-Identifier: MIT
#include "quad/potentials/kernel_terms.h"

#include "line_terms.h"

#include <array>
#include <cmath>
#include <map>
#include <utility>

namespace cageproof::adaptive_qmvc {
namespace {

using namespace line_factor;

// d/d eta_i: of x_j it is -delta_ij, of g it is -N_i, of r^-(2m + 1) it is (2m + 1) x_i r^-(2m + 3).
LineTerms derivative(const LineTerms& terms, int i) {
  LineTerms result;
  for (const auto& [term, factors] : terms) {
    LineTerm further = term.times_x(i);
    ++further.m;
    add_to(result, further, factors, 2 * term.m + 1);
    if (term.power[i] > 0) {
      LineTerm less = term;
      --less.power[i];
      add_to(result, less, factors, -term.power[i]);
    }
    // No kernel has a further factor next to g.
    if (term.others[2] == kHeight) {
      LineTerm normal = term;
      normal.others[2] = kN + i;
      add_to(result, normal, factors, -1);
    }
  }
  std::erase_if(result, [](const auto& entry) { return entry.second == Factors{0, 0}; });
  return result;
}

// The entries of a kernel's tensor.
std::vector<LineTerms> kernel(Potential potential) {
  constexpr Factors kFirst{1, 0}, kSecond{0, 1};
  switch (potential) {
    case Potential::SingleLayer: return {{{LineTerm{.m = 0}, {1, 0}}}};
    case Potential::DoubleLayer: return {{{LineTerm{.m = 1}.times(kHeight), {1, 0}}}};
    case Potential::BiharmonicSingleLayer: return {{{LineTerm{.m = -1}, {0.5, 0}}}};
    case Potential::BiharmonicDoubleLayer: return {{{LineTerm{.m = 0}.times(kHeight), {-0.5, 0}}}};
    default: break;
  }
  const bool traction = potential == Potential::KelvinTraction;
  std::vector<LineTerms> entries(9);
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j) {
      LineTerms& terms = entries[3 * i + j];
      const LineTerm cube{.m = 1};
      if (i == j) add_to(terms, traction ? cube.times(kHeight) : LineTerm{.m = 0}, kFirst, 1);
      if (traction && i != j) {
        add_to(terms, cube.times(kN + i).times_x(j), kFirst, 1);
        add_to(terms, cube.times(kN + j).times_x(i), kFirst, -1);
      }
      const LineTerm square = traction ? LineTerm{.m = 2}.times(kHeight) : cube;
      add_to(terms, square.times_x(i).times_x(j), kSecond, 1);
    }
  return entries;
}

// Numbers polynomials and integrals as they are asked for.
class Numbering {
 public:
  explicit Numbering(LineIntegrals& numbered) : numbered_(numbered) {
    numbered_.polynomials.push_back({-1, 0, 0, false});
  }

  int integral(const LineTerm& term) {
    const auto [at, added] = integrals_.try_emplace(term, static_cast<int>(numbered_.integrals.size()));
    if (added) {
      numbered_.integrals.push_back(
          {number_of({.power = term.power, .others = term.others, .around = term.around}), term.m, term.basis});
      numbered_.top = std::max(numbered_.top, term.m);
    }
    return at->second;
  }

 private:
  int number_of(const LineTerm& product) {
    if (product == LineTerm{.around = product.around}) return 0;
    if (const auto known = polynomials_.find(product); known != polynomials_.end()) return known->second;
    LineTerm rest = product;
    int factor = 0;
    if (const auto last = std::ranges::find_if(rest.power, [](int p) { return p > 0; }); last != rest.power.end()) {
      factor = static_cast<int>(last - rest.power.begin());
      --*last;
    } else {
      factor = rest.others[2];
      rest.others = {-1, rest.others[0], rest.others[1]};
    }
    const int parent = number_of(rest);
    const int number = static_cast<int>(numbered_.polynomials.size());
    // Along the lines u = 0 .. 1, xi_u does not change; along the border's other sides xi_v does not.
    const bool is_linear = factor < kTwist && (product.around || factor < kAlongU || factor >= kAlongV);
    numbered_.polynomials.push_back(
        {parent, factor, numbered_.polynomials[parent].degree + (is_linear ? 1 : 0), is_linear});
    polynomials_.emplace(product, number);
    return number;
  }

  LineIntegrals& numbered_;
  std::map<LineTerm, int> integrals_, polynomials_;
};

// Kernels' factors are halves, and what follows from them by derivatives, or thirds.
int sixths(double factor) { return static_cast<int>(std::lround(6 * factor)); }

KernelTape numbered(const TapeEntries& entries, bool tangential) {
  KernelTape tape;
  tape.tangential = tangential;
  Numbering across(tape.across), around(tape.around);
  for (int o = 0; o < 3; ++o)
    for (const LineTerms& terms : entries[o]) {
      auto& parts = tape.entries[o].emplace_back();
      for (const auto& [term, factors] : terms) {
        LineTerm plain = term;
        plain.divided = false;
        for (int p = 0; p < 2; ++p)
          if (factors[p] != 0)
            parts.push_back(
                {(term.around ? around : across).integral(plain), p, sixths(factors[p]), term.around, term.divided});
      }
    }
  return tape;
}

struct Tapes {
  std::vector<KernelTape> plain, tangential;
};

const Tapes& all_tapes() {
  static const Tapes tapes = [] {
    Tapes all;
    for (const Potential p :
         {Potential::SingleLayer, Potential::DoubleLayer, Potential::BiharmonicSingleLayer,
          Potential::BiharmonicDoubleLayer, Potential::KelvinDisplacement, Potential::KelvinTraction})
      for (int o = 0; o <= 2; ++o) {
        TapeEntries entries = plain_entries(p, o);
        all.plain.push_back(numbered(entries, false));
        const bool gains = make_tangential(p, o, entries);
        all.tangential.push_back(numbered(entries, gains));
      }
    return all;
  }();
  return tapes;
}

std::size_t number_of(Potential potential, int order) {
  return 3 * static_cast<std::size_t>(potential) + static_cast<std::size_t>(order);
}

}  // namespace

TapeEntries plain_entries(Potential potential, int order) {
  TapeEntries entries;
  entries[0] = kernel(potential);
  for (int o = 1; o <= order; ++o)
    for (const LineTerms& terms : entries[o - 1])
      for (int i = 0; i < 3; ++i) entries[o].push_back(derivative(terms, i));
  return entries;
}

const KernelTape& kernel_tape(Potential potential, int order) { return all_tapes().plain[number_of(potential, order)]; }

const KernelTape& tangential_tape(Potential potential, int order) {
  return all_tapes().tangential[number_of(potential, order)];
}

}  // namespace cageproof::adaptive_qmvc
