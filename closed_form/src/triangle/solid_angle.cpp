// SPDX-License-Identifier: MIT
#include "cageproof/closed_form/triangle/solid_angle.h"

#include "../register.h"

namespace cageproof::closed_form {
namespace {

const RegisterEvaluation registered{triangle_family(
    "triangle.solid_angle", "edge form",
    []<Scalar R>(const Triangle<R>& t, const Vec3<R>& eta, int order) { return solid_angle<R>(t, eta, order); })};

}  // namespace
}  // namespace cageproof::closed_form
