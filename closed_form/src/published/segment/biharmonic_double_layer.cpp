// SPDX-License-Identifier: MIT
#include "published/segment/biharmonic_double_layer.h"

#include "engine/register.h"

namespace cageproof::closed_form::published {
namespace {

const RegisterPlaneForm plane_biharmonic_double_layer_forms{
    "segment.biharmonic_double_layer",
    {{Misprint::None, "[W12] Appendix A after the errata"}, {Misprint::AppendixA, "[W12] Appendix A as printed"}},
    []<Scalar R>(const PlaneEdge<R>& e, Misprint misprint) { return biharmonic_double_layer<R>(e, misprint); }};

}  // namespace
}  // namespace cageproof::closed_form::published
