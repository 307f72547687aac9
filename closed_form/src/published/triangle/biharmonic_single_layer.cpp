// SPDX-License-Identifier: MIT
#include "cageproof/closed_form/published/triangle/biharmonic_single_layer.h"

#include "engine/register.h"

namespace cageproof::closed_form::published {
namespace {

const auto form = []<Scalar R>(const Frame<R>& f, const Batch<R>& batch, Misprint misprint) {
  return biharmonic_single_layer<R>(f, batch.order, misprint);
};
const RegisterEvaluation published{published_family("triangle.biharmonic_single_layer", Misprint::None,
                                                    "[T24] Eq 9-14, Appendix C, after the errata", form)};
const RegisterEvaluation appendix_a{published_family("triangle.biharmonic_single_layer", Misprint::AppendixA,
                                                     "[T24] with the sign of omega_t that Appendix A states", form)};
const RegisterEvaluation appendix_c{published_family("triangle.biharmonic_single_layer", Misprint::AppendixC,
                                                     "[T24] with Appendix C as printed", form)};

}  // namespace
}  // namespace cageproof::closed_form::published
