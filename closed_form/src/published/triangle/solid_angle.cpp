// SPDX-License-Identifier: MIT
#include "cageproof/closed_form/published/triangle/solid_angle.h"

#include "engine/register.h"

namespace cageproof::closed_form::published {
namespace {

const auto form = []<Scalar R>(const Frame<R>& f, const Batch<R>& batch, Misprint misprint) {
  return solid_angle<R>(f, batch.order, misprint);
};
const RegisterEvaluation published{
    published_family("triangle.solid_angle", Misprint::None, "[T24] Appendix A, Section 3.1, after the errata", form)};
const RegisterEvaluation appendix_a{published_family("triangle.solid_angle", Misprint::AppendixA,
                                                     "[T24] with the sign of omega_t that Appendix A states", form)};

}  // namespace
}  // namespace cageproof::closed_form::published
