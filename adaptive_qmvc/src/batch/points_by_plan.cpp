// SPDX-License-Identifier: MIT
#include "points_by_plan.h"

namespace cageproof::adaptive_qmvc::batch {

void PointsByPlan::sort(const FaceTables& face, const double* distances, int stride, int count) {
  const auto of = [&](int side) { return distances + static_cast<std::size_t>(face.edge[side]) * stride; };
  const double *const d0 = of(0), *const d1 = of(1), *const d2 = of(2), *const d3 = of(3);
  plan_.resize(count);
  order_.resize(count);
  first_.assign(plans_.count() + 2, 0);
  for (int p = 0; p < count; ++p) {
    const int across_v = plans_.step_of((d0[p] + d2[p]) * face.over_v);
    const int across_u = plans_.step_of((d1[p] + d3[p]) * face.over_u);
    plan_[p] = plans_.plan_of(across_v, across_u);
    ++first_[plan_[p] + 1];
  }
  for (std::size_t i = 1; i < first_.size(); ++i) first_[i] += first_[i - 1];
  for (int p = 0; p < count; ++p) order_[first_[plan_[p]]++] = p;
  // Each plan's first place is where the one before it ends.
  for (std::size_t i = first_.size() - 1; i > 0; --i) first_[i] = first_[i - 1];
  first_[0] = 0;
}

}  // namespace cageproof::adaptive_qmvc::batch
