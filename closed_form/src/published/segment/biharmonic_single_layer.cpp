// SPDX-License-Identifier: MIT
#include "published/segment/biharmonic_single_layer.h"

#include "engine/register.h"

namespace cageproof::closed_form::published {
namespace {

const RegisterPlaneForm plane_biharmonic_single_layer_forms{
    "segment.biharmonic_single_layer",
    {{Misprint::None, "[W12] Appendix A"}},
    []<Scalar R>(const PlaneEdge<R>& e, Misprint misprint) { return biharmonic_single_layer<R>(e, misprint); }};

}  // namespace
}  // namespace cageproof::closed_form::published
