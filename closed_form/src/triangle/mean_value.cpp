// SPDX-License-Identifier: MIT
#include "cageproof/closed_form/triangle/mean_value.h"

#include "../register.h"

namespace cageproof::closed_form {
namespace {

const RegisterEvaluation registered{triangle_family(
    "triangle.mean_value", "closed_form", "edge form over even powers of the distance",
    []<Scalar R>(const Triangle<R>& t, const Query<R>& q) { return mean_value<R>(t, q.point, q.order); })};

}  // namespace
}  // namespace cageproof::closed_form
