// SPDX-License-Identifier: MIT
#include "cageproof/closed_form/published/triangle/solid_angle.h"

#include "engine/register.h"

namespace cageproof::closed_form::published {
namespace {

const auto solid_angle_form = []<Scalar R>(const Frame<R>& f, int order, std::span<const R>, Misprint misprint) {
  return solid_angle<R>(f, order, misprint);
};
const RegisterEvaluation solid_angle_published{published_family(
    "triangle.solid_angle", Misprint::None, "[T24] Appendix A, Section 3.1, after the errata", solid_angle_form)};
const RegisterEvaluation solid_angle_appendix_a{
    published_family("triangle.solid_angle", Misprint::AppendixA,
                     "[T24] with the sign of omega_t that Appendix A states", solid_angle_form)};

}  // namespace
}  // namespace cageproof::closed_form::published
