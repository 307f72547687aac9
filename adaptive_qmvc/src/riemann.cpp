// SPDX-License-Identifier: MIT
// Registers the paper's scheme: `riemann-<n>`.
#include "counted_family.h"

#include "cageproof/adaptive_qmvc/riemann.h"

namespace cageproof::adaptive_qmvc {
namespace {

struct Riemann {
  template <Scalar R>
  Vec4<R> operator()(const Quad<R>& q, const Vec3<R>& point, int n) const {
    thread_local RiemannWorkspace<R> work;
    return quad_weights<R>(q, point, n, work);
  }
};

const RegisterEvaluation registered{counted_family("riemann", {"riemann-4", "riemann-7", "riemann-10"},
                                                   "the paper's scheme: Riemann sum of (2n + 1)^2 samples about the projection",
                                                   Riemann{})};

}  // namespace
}  // namespace cageproof::adaptive_qmvc
