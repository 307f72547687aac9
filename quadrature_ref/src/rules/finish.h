// SPDX-License-Identifier: MIT
// The last step of rules: scaling their sums, or the answer for inputs that have none.
#pragma once

#include "power_of_two.h"

#include "cageproof/quadrature_ref/kernel.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace cageproof::quadrature_ref {

/// Makes `count` nodes of a flat element, and sets their common members; the rule sets positions, basis functions and
/// weights.
template <Scalar R>
void set_flat(std::vector<Node<R>>& nodes, std::size_t count, const Vec3<R>& normal, const R& height,
              const R& log_unit) {
  nodes.resize(count);
  for (Node<R>& node : nodes) {
    node.normal = normal;
    node.height = height;
    node.log_unit = log_unit;
  }
}

/// Sets `result` to the tensors of `sums`, made symmetric and scaled back from units of 2^exponent.
template <Scalar R, Scalar W>
void finish(const Integrand& integrand, int exponent, const Result<W>& sums, Result<R>& result) {
  for (int order = 0; order <= 2; ++order) {
    const PowerOfTwo<W> from_unit(exponent * (integrand.degree - order));
    for (std::size_t i = 0; i < sums.of(order).size(); ++i)
      result.of(order)[i] = static_cast<R>(from_unit(sums.of(order)[i]));
  }
  fill_symmetric(result, integrand.formula.dim());
}

/// The answer of a rule where nothing can be computed.
template <Scalar R>
void fill_not_a_number(Result<R>& result) {
  for (int order = 0; order <= 2; ++order) std::ranges::fill(result.of(order), std::numeric_limits<R>::quiet_NaN());
  result.converged = false;
}

/// Applies a rule of fixed size to a block of points. Buffers are kept from call to call, so that a pair of element and
/// point costs no memory of its own. \param frame_of sees the element from a point: an optional with `exponent`, empty
/// without geometry \param add adds the rule's sums in scalar W to a Result, in the frame's unit of length
template <Scalar W, Scalar R, class FrameOf, class Add>
void integrate_block(const Integrand& integrand, const Batch<R>& batch, const BatchOutput<R>& output, FrameOf frame_of,
                     Add add) {
  static thread_local Result<W> sums;
  static thread_local Result<R> result;
  for (std::size_t p = 0; p < batch.points.size(); ++p) {
    integrand.reset(result, batch.order);
    if (const auto frame = frame_of(batch.points[p])) {
      integrand.reset(sums, batch.order);
      add(*frame, sums);
      finish(integrand, frame->exponent, sums, result);
      result.nodes = sums.nodes;
    } else {
      fill_not_a_number(result);
    }
    for (int o = 0; o <= batch.order; ++o) output.put(p, o, result.of(o));
    output.state(p, result.statement());
  }
}

}  // namespace cageproof::quadrature_ref
