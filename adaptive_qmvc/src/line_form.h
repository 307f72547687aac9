// SPDX-License-Identifier: MIT
// The line form at every order and scalar, compiled one file a scalar.
#pragma once

#include "cageproof/adaptive_qmvc/line_form.h"

namespace cageproof::adaptive_qmvc {

/// line_form at the query's order.
template <Scalar R>
void line_weights(const Query<R>& query, double digits, Result<R>& result);

}  // namespace cageproof::adaptive_qmvc

#define CAGEPROOF_LINE_WEIGHTS(R)                                                 \
  template <>                                                                     \
  void cageproof::adaptive_qmvc::line_weights<R>(const Query<R>& query, double digits, Result<R>& result) { \
    if (query.order == 0) line_form<0>(query, digits, result);                    \
    else if (query.order == 1) line_form<1>(query, digits, result);               \
    else line_form<2>(query, digits, result);                                     \
  }
