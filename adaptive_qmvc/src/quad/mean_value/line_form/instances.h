// SPDX-License-Identifier: MIT
// The line form for a block of points at every order; each scalar is compiled in a file of its own.
#pragma once

#include "quad/mean_value/line_form/line_form.h"

namespace cageproof::adaptive_qmvc {

/// line_form at each point of the batch, at the batch's order.
template <Scalar R>
void line_batch(const Batch<R>& batch, double digits, const BatchOutput<R>& output);
// Said before its uses, whichever source of one build comes first.
template <>
void line_batch<double>(const Batch<double>& batch, double digits, const BatchOutput<double>& output);
template <>
void line_batch<Mp50>(const Batch<Mp50>& batch, double digits, const BatchOutput<Mp50>& output);
template <>
void line_batch<Mp100>(const Batch<Mp100>& batch, double digits, const BatchOutput<Mp100>& output);
template <>
void line_batch<Mp200>(const Batch<Mp200>& batch, double digits, const BatchOutput<Mp200>& output);

template <int Order, Scalar R>
void line_batch_of_order(const Batch<R>& batch, double digits, const BatchOutput<R>& output) {
  WeightTensors<R> weights;
  for (std::size_t p = 0; p < batch.points.size(); ++p) {
    output.state(p, line_form<Order, R>(batch.corners, batch.points[p], digits, weights));
    for (int o = 0; o <= Order; ++o) output.put(p, o, weights.of(o));
  }
}

}  // namespace cageproof::adaptive_qmvc

#define CAGEPROOF_LINE_BATCH(R)                                                                                      \
  template <>                                                                                                        \
  void cageproof::adaptive_qmvc::line_batch<R>(const Batch<R>& batch, double digits, const BatchOutput<R>& output) { \
    if (batch.order == 0) line_batch_of_order<0>(batch, digits, output);                                             \
    else if (batch.order == 1) line_batch_of_order<1>(batch, digits, output);                                        \
    else line_batch_of_order<2>(batch, digits, output);                                                              \
  }

#define CAGEPROOF_LINE_FORM_OF_ORDER(Order, R)                                 \
  template cageproof::Statement cageproof::adaptive_qmvc::line_form<Order, R>( \
      std::span<const cageproof::Vec3<R>>, const cageproof::Vec3<R>&, double,  \
      cageproof::adaptive_qmvc::WeightTensors<R>&);
#define CAGEPROOF_LINE_FORM(R)       \
  CAGEPROOF_LINE_FORM_OF_ORDER(0, R) \
  CAGEPROOF_LINE_FORM_OF_ORDER(1, R) \
  CAGEPROOF_LINE_FORM_OF_ORDER(2, R)
