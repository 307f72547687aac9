// SPDX-License-Identifier: MIT
#include "published/triangle/mean_value.h"

#include "engine/register.h"

namespace cageproof::closed_form::published {
namespace {

template <Scalar R>
void printed_mean_value(const Batch<R>& batch, const BatchOutput<R>& output) {
  using W = Computed<R>;
  const Triangle<W> t{convert<W>(batch.corners[0]), convert<W>(batch.corners[1]), convert<W>(batch.corners[2])};
  for (std::size_t p = 0; p < batch.points.size(); ++p) {
    const std::array<W, 3> w = mean_value<W>(t, convert<W>(batch.points[p]));
    output.put(p, 0, std::array<R, 3>{static_cast<R>(w[0]), static_cast<R>(w[1]), static_cast<R>(w[2])});
  }
}

const RegisterEvaluation printed_mean_value_form{
    single_family("triangle.mean_value", "published",
                  {.description = "angles, mean vector and edge normals, [T18] Eq 12-14 after Ju et al. 2005",
                   .role = Role::Printed,
                   .cost = CostClass::Direct,
                   .max_order = 0},
                  true, [](Evaluation& evaluation) {
                    for (const ScalarKind kind : scalar_kinds)
                      with_scalar(kind, [&]<Scalar R>() { evaluation.set_batch<R>(printed_mean_value<R>); });
                  })};

}  // namespace
}  // namespace cageproof::closed_form::published
