// SPDX-License-Identifier: MIT
// How far the scheme of a kind is from what it approximates: the coordinates themselves, and their data on the cage.
#include "cageproof/validation/scheme_errors.h"

#include "cageproof/validation/cage_errors.h"
#include "cageproof/validation/cage_campaign.h"

#include <algorithm>
#include <cmath>

namespace cageproof::validation {
namespace {

// NaN counts as infinite.
void keep_largest(double difference, double& largest) {
  largest = std::isnan(difference) ? HUGE_VAL : std::max(largest, std::abs(difference));
}

}  // namespace

std::optional<CageCoordinates> approximated_by(const Cage& cage, const CoordinateKind& kind, Triangulation rule) {
  if (kind.approximates.empty()) return std::nullopt;
  const CoordinateKind& other = coordinate_kind_named(kind.approximates);
  if (!accepts(other, cage)) return std::nullopt;
  CageCoordinates found(cage, other, CoordinateOptions{.triangulation = rule});
  const std::optional<double> residual = boundary_residuals(found)[0];
  if (residual && !(*residual <= worst_truth)) return std::nullopt;
  return found;
}

std::array<double, 3> scheme_errors_at(const CageCoordinates& coordinates, const CageCoordinates& approximated,
                                       const Cage& cage, const Vec3<double>& point, int order) {
  std::array<double, 3> worst{};
  const auto found = coordinates.at<double>(point, order), truth = approximated.at<double>(point, order);
  for (int o = 0; o <= order; ++o)
    for (std::size_t b = 0; b < truth.size(); ++b) {
      const double unit = std::pow(cage.size(), coordinates.blocks()[b].degree - o);
      for (std::size_t i = 0; i < truth[b].of(o).size(); ++i)
        keep_largest((found[b].of(o)[i] - truth[b].of(o)[i]) / unit, worst[o]);
    }
  return worst;
}

std::optional<std::array<std::optional<double>, 2>> boundary_data_errors_at(const CageCoordinates& coordinates,
                                                                            const Cage& cage,
                                                                            const Vec3<double>& point) {
  const std::vector<Touching> on = coordinates.elements().touching(point);
  if (on.empty()) return std::nullopt;
  const std::vector<CoordinateBlock>& blocks = coordinates.blocks();
  std::vector<double> hats(coordinates.elements().vertices().size());
  for (const Touching& touch : on) {
    const std::span<const int> corners = coordinates.elements().vertices_of(touch.element);
    for (std::size_t k = 0; k < corners.size(); ++k) hats[corners[k]] = touch.basis[k];
  }
  // Only within an edge the boundary has a normal, and only data with normal derivatives say what is due along it.
  const bool slopes = on.size() == 1 && blocks.size() > 1;
  const auto found = coordinates.at<double>(point, slopes ? 1 : 0);
  std::array<std::optional<double>, 2> worst{0., {}};
  if (slopes) worst[1] = 0;
  const Vec3<double> normal = coordinates.elements().normal_at(on.front());
  for (std::size_t b = 0; b < blocks.size(); ++b)
    for (int i = 0; i < blocks[b].size; ++i) {
      const double unit = std::pow(cage.size(), blocks[b].degree);
      keep_largest((found[b].value[i] - (b == 0 ? hats[i] : 0)) / unit, *worst[0]);
      if (!slopes) continue;
      const double slope = found[b].gradient[2 * i] * normal[0] + found[b].gradient[2 * i + 1] * normal[1];
      keep_largest((slope - (b == 1 && i == on.front().element ? 1 : 0)) * cage.size() / unit, *worst[1]);
    }
  return worst;
}

}  // namespace cageproof::validation
