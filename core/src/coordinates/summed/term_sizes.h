// SPDX-License-Identifier: MIT
// The sizes of the terms that one point's coordinates are summed from, and what their roundings leave of a sum.
#pragma once

#include "cageproof/core/coordinates/prepared_coordinates.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <span>
#include <vector>

namespace cageproof {

/// Sums of absolute values, in a type whose range holds those of doubles' derivatives.
class TermSizes {
 public:
  template <Scalar W>
  explicit TermSizes(const std::vector<CoordinateTable<W>>& tables) : of_(tables.size()) {
    for (std::size_t b = 0; b < of_.size(); ++b)
      for (std::size_t o = 0; o < 3; ++o) of_[b][o].assign(tables[b].stride[o], 0);
  }

  /// Adds an element's tensors of one block, where their output puts them.
  template <Scalar W>
  void add(std::size_t b, int order, const Result<W>& part, const BatchOutput<W>& where) {
    for (int o = 0; o <= order; ++o) {
      const std::size_t size = where.block(o);
      const std::vector<W>& numbers = part.of(o);
      for (std::size_t i = 0; i < numbers.size(); ++i)
        of_[b][o][where.slot(i / size) * size + i % size] += std::abs(static_cast<long double>(numbers[i]));
    }
  }

  /// Makes sizes of weights, the first block, those of the terms of normalise(). \param sum of the weights \param lead
  /// leading()
  void normalise(int order, std::size_t dim, long double sum, std::size_t lead) {
    auto& [values, gradients, hessians] = of_[0];
    std::vector<long double> gradient(dim, 0), hessian(dim * dim, 0);
    for (std::size_t i = 0; i < gradients.size(); ++i) gradient[i % dim] += gradients[i];
    for (std::size_t i = 0; i < hessians.size(); ++i) hessian[i % (dim * dim)] += hessians[i];
    for (std::size_t i = 0; i < values.size(); ++i) {
      values[i] /= sum;
      for (std::size_t a = 0; order >= 1 && a < dim; ++a) {
        long double& g = gradients[dim * i + a];
        g = (g + values[i] * gradient[a]) / sum;
      }
      for (std::size_t a = 0; order >= 2 && a < dim * dim; ++a) {
        long double& h = hessians[dim * dim * i + a];
        h = (h + values[i] * hessian[a] + gradients[dim * i + a / dim] * gradient[a % dim] +
             gradients[dim * i + a % dim] * gradient[a / dim]) /
            sum;
      }
    }
    if (lead == values.size()) return;
    for (auto* const sizes : {&gradients, &hessians}) {
      const std::size_t derivatives = sizes->size() / values.size();
      for (std::size_t a = 0; a < derivatives; ++a) {
        long double& own = (*sizes)[derivatives * lead + a];
        own = 0;
        for (std::size_t i = 0; i < values.size(); ++i)
          if (i != lead) own += (*sizes)[derivatives * i + a];
      }
    }
  }

  /// Sets to zero what may be no more than roundings of the terms in W, and to NaN where these leave double's range
  /// themselves, so that nobody knows whether the number does.
  template <Scalar W>
  void drop_roundings(std::vector<CoordinateTable<W>>& tables) const {
    const long double share = std::ldexp(1.0L, kRoundings - std::numeric_limits<W>::digits);
    for (std::size_t b = 0; b < of_.size(); ++b)
      for (std::size_t o = 0; o < 3; ++o)
        for (std::size_t i = 0; i < of_[b][o].size(); ++i) {
          W& x = tables[b].tensors[o][i];
          const long double roundings = share * of_[b][o][i];
          if (std::abs(static_cast<long double>(x)) > roundings) continue;
          x = W(roundings > std::numeric_limits<double>::max() ? std::numeric_limits<double>::quiet_NaN() : 0.0);
        }
  }

  /// Whether roundings of the terms in W leave the first block's numbers of an order all of double's digits of the
  /// largest of them, or of `least` where that is larger.
  template <Scalar W>
  bool leave_digits(const CoordinateTable<W>& table, int order, long double least) const {
    const long double share = std::ldexp(1.0L, kRoundings - std::numeric_limits<W>::digits);
    long double largest = least, terms = 0;
    for (const W& x : table.tensors[order]) largest = std::max(largest, std::abs(static_cast<long double>(x)));
    for (const long double size : of_[0][order]) terms = std::max(terms, size);
    return share * terms <= std::ldexp(largest, -std::numeric_limits<double>::digits);
  }

 private:
  // In powers of two: more than elements' integrals and their sums make.
  static constexpr int kRoundings = 30;

  std::vector<std::array<std::vector<long double>, 3>> of_;
};

}  // namespace cageproof
