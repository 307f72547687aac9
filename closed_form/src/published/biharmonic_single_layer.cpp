// SPDX-License-Identifier: MIT
#include "cageproof/closed_form/published/biharmonic.h"

#include "register.h"

namespace cageproof::closed_form::published {
namespace {

const auto form = []<Scalar R>(const Setting<R>& s, const Query<R>& q, Misprint misprint) {
  return biharmonic_single_layer<R>(s, q.order, misprint);
};
const RegisterEvaluation published{published_family("triangle.biharmonic_single_layer", Misprint::None,
                                                    "[T24] Eq 9-14, Appendix C, after the errata", form)};
const RegisterEvaluation appendix_a{published_family("triangle.biharmonic_single_layer", Misprint::AppendixA,
                                                     "[T24] with the sign of omega_t that Appendix A states", form)};
const RegisterEvaluation appendix_c{published_family("triangle.biharmonic_single_layer", Misprint::AppendixC,
                                                     "[T24] with Appendix C as printed", form)};

}  // namespace
}  // namespace cageproof::closed_form::published
