// SPDX-License-Identifier: MIT
#include "cageproof/closed_form/triangle/solid_angle.h"

#include "../register.h"

namespace cageproof::closed_form {
namespace {

const RegisterEvaluation registered{triangle_family(
    "triangle.solid_angle", "closed_form", "edge form",
    []<Scalar R>(const Triangle<R>& t, const Query<R>& q) { return solid_angle<R>(t, q.point, q.order); })};

}  // namespace
}  // namespace cageproof::closed_form
