// SPDX-License-Identifier: MIT
// The unit of work of an evaluation: one element, a block of points, tensors stored or added where the caller wants
// them.
#pragma once

#include "cageproof/core/catalogue/formula.h"

#include <limits>
#include <span>
#include <vector>

namespace cageproof {

/// The input: one element and a block of points.
template <Scalar R>
struct Batch {
  std::span<const Vec3<R>> corners;  ///< the element's corners, corner_count(element) of them
  std::span<const Vec3<R>> points;   ///< eta, each
  int order = 0;                     ///< highest derivative wanted: 0 value, 1 gradient, 2 Hessian
  std::span<const R> parameters{};   ///< in the order of Formula::parameters
  /// On an element's border, where a value diverges like the distance's logarithm: leave that term out. Cages need it,
  /// in whose sums the terms of neighbours cancel. Evaluations without it give no finite value there.
  bool finite_part = false;
};

/// A batch of one.
template <Scalar R>
struct Query {
  std::span<const Vec3<R>> corners;
  Vec3<R> point = Vec3<R>::Zero();
  int order = 0;
  std::span<const R> parameters{};
  bool finite_part = false;
};

/// The statement of an evaluation about its own result at one point.
struct Statement {
  /// Decimal digits, relative and norm-wise, that the evaluation itself stands behind for the worst tensor asked for;
  /// NaN where it makes no statement (closed forms, fixed rules).
  double digits = std::numeric_limits<double>::quiet_NaN();
  /// False where an evaluation with a tolerance (adaptive, multiprecision) could not meet it.
  bool converged = true;
  std::size_t nodes = 0;  ///< kernel evaluations spent; 0 for closed forms
};

/// Where a batch's tensors go. The caller owns the memory, and has set it to zero where tensors are added.
///
/// The tensors of derivative order o of point p begin at tensors[o] + p * stride[o]; there, tensor k of the element
/// (one per corner, or the one) begins at slot(k) * block(o). Slots let an element's tensors be added straight to the
/// coordinates of a cage.
template <Scalar R>
struct BatchOutput {
  std::array<R*, 3> tensors{};
  std::array<std::size_t, 3> stride{};
  std::size_t entries = 1;          ///< of one tensor: rows x columns
  int dim = 3;                      ///< of the space
  std::span<const int> slots{};     ///< empty: tensor k has slot k
  bool add = false;                 ///< add to what is there, instead of storing
  Statement* statements = nullptr;  ///< one per point, or null

  std::size_t slot(std::size_t k) const { return slots.empty() ? k : static_cast<std::size_t>(slots[k]); }
  /// Numbers of one tensor of that derivative order.
  std::size_t block(int order) const { return entries * derivative_count(dim, order); }

  /// Puts an element's tensors of one order at a point; they lie one after the other.
  void put(std::size_t point, int order, std::span<const R> values) const {
    const std::size_t size = block(order);
    R* const first = tensors[order] + point * stride[order];
    for (std::size_t k = 0; k * size < values.size(); ++k) {
      R* const to = first + slot(k) * size;
      const R* const from = values.data() + k * size;
      if (add)
        for (std::size_t i = 0; i < size; ++i) to[i] += from[i];
      else
        for (std::size_t i = 0; i < size; ++i) to[i] = from[i];
    }
  }
  void state(std::size_t point, const Statement& statement) const {
    if (statements != nullptr) statements[point] = statement;
  }
};

/// The output of a batch of one, with memory of its own: tensors with respect to the point, the last index the fastest.
template <Scalar R>
struct Result {
  std::vector<R> value;     ///< [component]
  std::vector<R> gradient;  ///< [component][i], empty when order < 1
  std::vector<R> hessian;   ///< [component][i][j], empty when order < 2
  /// Radii about the entries of each tensor within which the formula's value is proven to lie, infinite where nothing
  /// is; empty when the evaluation proves nothing.
  std::vector<R> value_radius, gradient_radius, hessian_radius;
  double stated_digits = std::numeric_limits<double>::quiet_NaN();  ///< Statement::digits
  bool converged = true;                                            ///< Statement::converged
  std::size_t nodes = 0;                                            ///< Statement::nodes

  /// Sizes the arrays for `components` tensors in `dim` dimensions up to `order` and sets them to zero.
  void reset(int components, int dim, int order) {
    value.assign(components, R(0));
    gradient.assign(order >= 1 ? components * dim : 0, R(0));
    hessian.assign(order >= 2 ? components * dim * dim : 0, R(0));
    for (int o = 0; o < 3; ++o) radius_of(o).clear();
    stated_digits = std::numeric_limits<double>::quiet_NaN();
    converged = true;
    nodes = 0;
  }
  Statement statement() const { return {stated_digits, converged, nodes}; }
  /// The tensor of derivative order 0, 1 or 2.
  const std::vector<R>& of(int order) const { return order == 0 ? value : order == 1 ? gradient : hessian; }
  std::vector<R>& of(int order) { return order == 0 ? value : order == 1 ? gradient : hessian; }
  /// The radii of derivative order 0, 1 or 2.
  const std::vector<R>& radius_of(int order) const {
    return order == 0 ? value_radius : order == 1 ? gradient_radius : hessian_radius;
  }
  std::vector<R>& radius_of(int order) {
    return order == 0 ? value_radius : order == 1 ? gradient_radius : hessian_radius;
  }
};

/// The output of a batch of one that stores into a result. \pre the result was reset for the formula and order
template <Scalar R>
BatchOutput<R> output_of(const Formula& formula, Result<R>& result, Statement& statement) {
  return {.tensors = {result.value.data(), result.gradient.data(), result.hessian.data()},
          .entries = static_cast<std::size_t>(formula.shape.entries()),
          .dim = formula.dim(),
          .statements = &statement};
}

}  // namespace cageproof
