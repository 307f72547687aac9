// SPDX-License-Identifier: MIT
#include "cageproof/closed_form/triangle/biharmonic_single_layer.h"

#include "../register.h"

namespace cageproof::closed_form {
namespace {

const RegisterEvaluation registered{triangle_family(
    "triangle.biharmonic_single_layer", "closed_form", "edge form",
    []<Scalar R>(const Triangle<R>& t, const Query<R>& q) { return biharmonic_single_layer<R>(t, q.point, q.order); })};

}  // namespace
}  // namespace cageproof::closed_form
