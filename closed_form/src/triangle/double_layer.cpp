// SPDX-License-Identifier: MIT
#include "cageproof/closed_form/triangle/double_layer.h"

#include "../register.h"

namespace cageproof::closed_form {
namespace {

const RegisterEvaluation registered{triangle_family(
    "triangle.double_layer", "edge form",
    []<Scalar R>(const Triangle<R>& t, const Vec3<R>& eta, int order) { return double_layer<R>(t, eta, order); })};

}  // namespace
}  // namespace cageproof::closed_form
