// SPDX-License-Identifier: MIT
#include "published/segment/double_layer.h"

#include "engine/register.h"

namespace cageproof::closed_form::published {
namespace {

const RegisterPlaneForm plane_double_layer_forms{
    "segment.double_layer",
    {{Misprint::None, "[W12] Appendix A"}},
    []<Scalar R>(const PlaneEdge<R>& e, Misprint misprint) { return double_layer<R>(e, misprint); }};

}  // namespace
}  // namespace cageproof::closed_form::published
