// SPDX-License-Identifier: MIT
// What [W12] does about the boundary: points on it are moved inwards.
#include "cageproof/closed_form/put.h"

#include "cageproof/closed_form/segment/engine/closed_form.h"
#include "cageproof/closed_form/segment/biharmonic_double_layer.h"
#include "cageproof/closed_form/segment/biharmonic_single_layer.h"
#include "cageproof/closed_form/segment/double_layer.h"
#include "cageproof/closed_form/segment/single_layer.h"
#include "cageproof/core/catalogue/evaluation.h"

namespace cageproof::closed_form::published {
namespace {

constexpr double kOffset = 1e-6;  // [W12] Section 4.3, in lengths of the segment here

template <Scalar R>
bool is_on(const Segment<R>& s, const Vec3<R>& point) {
  const auto between = [&](int i) {
    return (s[0][i] <= point[i] && point[i] <= s[1][i]) || (s[1][i] <= point[i] && point[i] <= s[0][i]);
  };
  if (!between(0) || !between(1)) return false;
  return ExactSegment({convert<Mp200>(s[0]), convert<Mp200>(s[1])}, convert<Mp200>(point)).cross == 0;
}

template <Scalar R>
Vec3<R> moved(const Segment<R>& s, const Vec3<R>& point) {
  const Vec3<R> e = s[1] - s[0];
  // The outward normal is to the right of e.
  return is_on(s, point) ? Vec3<R>(point - R(kOffset) * Vec3<R>(e[1], -e[0], R(0))) : point;
}

template <class F, Scalar R>
void put_block(const Batch<R>& batch, const BatchOutput<R>& output) {
  const Segment<R> s{batch.corners[0], batch.corners[1]};
  for (std::size_t p = 0; p < batch.points.size(); ++p) {
    const Vec3<R> point = moved(s, batch.points[p]);
    if (batch.order == 0) put(segment::closed_form<F, 0, R>(s, point), 0, p, output);
    else if (batch.order == 1) put(segment::closed_form<F, 1, R>(s, point), 1, p, output);
    else put(segment::closed_form<F, 2, R>(s, point), 2, p, output);
  }
}

template <class F>
EvaluationFamily offset(std::string_view formula) {
  return single_family(formula, "offset-1e-6",
                       {.description = "the closed form, of points on the segment 1e-6 lengths inside",
                        .role = Role::Scheme,
                        .cost = CostClass::Direct},
                       true, [](Evaluation& evaluation) {
                         for (const ScalarKind kind : scalar_kinds)
                           with_scalar(kind, [&]<Scalar R>() { evaluation.set_batch<R>(&put_block<F, R>); });
                       });
}

const RegisterEvaluation of_layers[] = {
    RegisterEvaluation{offset<segment::SingleLayer>("segment.single_layer")},
    RegisterEvaluation{offset<segment::DoubleLayer>("segment.double_layer")},
    RegisterEvaluation{offset<segment::BiharmonicSingleLayer>("segment.biharmonic_single_layer")},
    RegisterEvaluation{offset<segment::BiharmonicDoubleLayer>("segment.biharmonic_double_layer")},
};

}  // namespace
}  // namespace cageproof::closed_form::published
