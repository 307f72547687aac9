// SPDX-License-Identifier: MIT
// Registers the paper's scheme: `riemann-<n>`.
#include "../../counted_family.h"
#include "instances.h"

namespace cageproof::adaptive_qmvc {
namespace {

struct Riemann {
  template <Scalar R>
  void operator()(const Batch<R>& batch, int n, const BatchOutput<R>& output) const {
    riemann_batch<R>(batch, n, output);
  }
};

const RegisterEvaluation register_riemann{counted_family(
    "quad.mean_value", "riemann", {"riemann-4", "riemann-7", "riemann-10"},
    {"riemann-2", "riemann-4", "riemann-10", "riemann-40", "riemann-160"},
    "the paper's scheme: Riemann sum of (2n + 1)^2 samples about the projection; in double, from 4096 sizes on, its "
    "linear system is solved in 50 digits",
    Riemann{})};

}  // namespace
}  // namespace cageproof::adaptive_qmvc
