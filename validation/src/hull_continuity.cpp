// SPDX-License-Identifier: MIT
#include "hull_continuity.h"

#include "cageproof/adaptive_qmvc/continuity.h"
#include "cageproof/validation/campaign.h"
#include "cageproof/validation/promise.h"

#include <algorithm>

namespace cageproof::validation {

std::vector<ResultRow> run_hull_continuity(const std::string& evaluations, std::uint64_t seed) {
  constexpr int points = 64;
  std::vector<ResultRow> rows;
  for (const char* name : {"closed_form", "riemann-4"}) {
    if (!matches(evaluations, name)) continue;
    std::array<double, 2> worst{}, median{};
    std::uint64_t samples = 0;
    for (const double lift : {0.1, 0.3, 0.6}) {
      const Quad<double> q{Vec3<double>(0, 0, 0), Vec3<double>(1, 0, 0), Vec3<double>(1, 1, lift), Vec3<double>(0, 1, 0)};
      const auto study = adaptive_qmvc::study_continuity(name, q, points, seed);
      worst = {std::max(worst[0], study.hull_worst.value), std::max(worst[1], study.hull_worst.derivative)};
      median = {std::max(median[0], study.hull_median.value), std::max(median[1], study.hull_median.derivative)};
      samples += points;
    }
    for (int order = 0; order < 2; ++order) {
      ResultRow row;
      row.subject = "quad.mean_value";
      row.evaluation = name;
      row.scalar = "double";
      row.regime = hull_regime;
      row.check = "hull_jump";
      row.order = order;
      row.unit = "relative";
      row.samples = samples;
      row.max = row.p999 = row.max_relative = worst[order];
      row.median = median[order];
      judge(row);
      rows.push_back(std::move(row));
    }
  }
  return rows;
}

}  // namespace cageproof::validation
