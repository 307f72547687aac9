// SPDX-License-Identifier: MIT
// Registers the baseline: `tessellated-<n>`.
#include "cageproof/adaptive_qmvc/tessellated.h"

#include "counted_family.h"

// closed_form compiles these once for all.
namespace cageproof::closed_form {
#define CAGEPROOF_THERE(R)         \
  extern template class EvenForm<R, 0>; \
  extern template struct Frame<R>;
CAGEPROOF_THERE(double)
CAGEPROOF_THERE(Mp50)
CAGEPROOF_THERE(Mp100)
CAGEPROOF_THERE(Mp200)
CAGEPROOF_THERE(Tracked<double>)
CAGEPROOF_THERE(Tracked<TwoDoubles>)
CAGEPROOF_THERE(Tracked<Mp200>)
#undef CAGEPROOF_THERE
}  // namespace cageproof::closed_form

namespace cageproof::adaptive_qmvc {
namespace {

struct Tessellated {
  template <Scalar R>
  Vec4<R> operator()(const Quad<R>& q, const Vec3<R>& point, int n) const {
    return tessellated_weights<R>(q, point, n);
  }
};

const RegisterEvaluation registered{counted_family("tessellated", {"tessellated-5"},
                                                   "2 n^2 triangles in the quad's place, closed form of each", Tessellated{})};

}  // namespace
}  // namespace cageproof::adaptive_qmvc
