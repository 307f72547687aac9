// SPDX-License-Identifier: MIT
// Coordinates on a cage against those next to it.
#include "cages/inside_limit.h"
#include "cageproof/validation/cage_campaign.h"

#include "cageproof/core/numbers/random_stream.h"
#include "cages/point_inside.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace cageproof::validation {
namespace {

constexpr double kLeastRoom = 1e-4;

// The largest difference of one order over all blocks. Values must be finite; of derivatives those that are not are
// left out, and nothing is returned where none is left.
std::optional<double> largest_difference(const CageCoordinates& coordinates, const std::vector<Result<double>>& limit,
                                         const std::vector<Result<double>>& inside, double size, int order) {
  std::optional<double> worst;
  for (std::size_t b = 0; b < limit.size(); ++b) {
    const double scale = std::pow(size, coordinates.blocks()[b].degree - order);
    for (std::size_t i = 0; i < limit[b].of(order).size(); ++i) {
      if (order > 0 && !std::isfinite(limit[b].of(order)[i])) continue;
      const double difference = std::abs(limit[b].of(order)[i] - inside[b].of(order)[i]) / scale;
      if (std::isnan(difference)) return std::numeric_limits<double>::infinity();
      worst = std::max(worst.value_or(0), difference);
    }
  }
  return worst;
}

// Whether elements hang together where they meet: else a face crosses or touches others there, and each has an inside
// of its own.
bool share_a_vertex(const CageElements& elements, const std::vector<Touching>& on) {
  const auto first = elements.vertices_of(on.front().element);
  return std::ranges::any_of(first, [&](int vertex) {
    return std::ranges::all_of(on, [&](const Touching& touch) {
      const auto vertices = elements.vertices_of(touch.element);
      return std::ranges::find(vertices, vertex) != vertices.end();
    });
  });
}

}  // namespace

std::optional<Vec3<double>> point_inside(const CageCoordinates& coordinates, const Cage& cage,
                                         const CageLocator& locator, const Vec3<double>& point,
                                         const std::vector<Touching>& on) {
  if (!on.empty() && !share_a_vertex(coordinates.elements(), on)) return std::nullopt;
  Vec3<double> direction = Vec3<double>::Zero();
  for (const Touching& touch : on) direction -= coordinates.elements().normal_at(touch);
  Vec3<double> near = point + inside_step * cage.size() * direction.normalized();
  // Against the mean normal lies the inside of all but saddles; there another direction does.
  for (std::uint64_t attempt = 0; !(direction.norm() > 0.1) || !locator.inside(near); ++attempt) {
    if (attempt == 1000) return std::nullopt;
    RandomStream random(1, "inward", attempt);
    for (int c = 0; c < cage.dimension(); ++c) direction[c] = random.uniform(-1, 1);
    near = point + inside_step * cage.size() * direction.normalized();
  }
  if (locator.winding(near) != 1) return std::nullopt;
  return near;
}

std::array<std::optional<double>, 3> inside_limit_errors_at(const CageCoordinates& coordinates, const Cage& cage,
                                                            const CageLocator& locator, const Vec3<double>& point,
                                                            int order) {
  const std::vector<Touching> on = coordinates.elements().touching(point);
  if (on.empty()) return {NAN, NAN, NAN};
  const double room = locator.distance_but_to(on, point) / cage.size();
  if (room < kLeastRoom) return {};
  const auto near = point_inside(coordinates, cage, locator, point, on);
  if (!near) return {};
  const auto limit = coordinates.at<double>(point, order), inside = coordinates.at<double>(*near, order);
  if (!coordinates.kind().missing_because.empty() && std::isnan(limit[0].value[0] + inside[0].value[0]))
    return {NAN, NAN, NAN};
  std::array<std::optional<double>, 3> errors;
  for (int o = 0; o <= order; ++o) {
    errors[o] = largest_difference(coordinates, limit, inside, cage.size(), o);
    // Over the step derivatives change by that much of the reciprocal of the room, to a power that is one more.
    if (o > 0 && errors[o]) *errors[o] *= std::pow(room, o + 1);
  }
  return errors;
}

}  // namespace cageproof::validation
