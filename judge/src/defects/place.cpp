// SPDX-License-Identifier: MIT
// Where a point lies to an element, up to roundings.
#include "defects/probes.h"

#include "cageproof/core/geometry/orientation.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace cageproof::judge {
namespace {

using validation::Sample;

// Roundings of the largest coordinate that plain arithmetic may lose in a difference or a product of differences.
constexpr double kRoundings = 8;

double largest_coordinate(const Sample& sample) {
  double largest = sample.point.cwiseAbs().maxCoeff();
  for (const auto& corner : sample.corners) largest = std::max(largest, corner.cwiseAbs().maxCoeff());
  return largest;
}

std::array<double, 4> basis_at(ElementKind element, const Sample& sample, const Vec3<double>& foot) {
  const auto& c = sample.corners;
  if (element == ElementKind::Quad) return type_of(element).contact(c, sample.point).basis;
  if (element == ElementKind::Segment) {
    const Vec3<double> edge = c[1] - c[0];
    const double t = edge.dot(foot - c[0]) / edge.squaredNorm();
    return {1 - t, t};
  }
  const Vec3<double> normal = (c[1] - c[0]).cross(c[2] - c[0]);
  std::array<double, 4> basis{};
  for (std::size_t k = 0; k < 3; ++k)
    basis[k] = (c[(k + 1) % 3] - foot).cross(c[(k + 2) % 3] - foot).dot(normal) / normal.squaredNorm();
  return basis;
}

// Quads are not flat: theirs is what rounding makes of it.
bool exactly_in_plane(ElementKind element, const Sample& sample) {
  const auto& c = sample.corners;
  if (element == ElementKind::Triangle) return side_of_plane({c[0], c[1], c[2]}, sample.point) == 0;
  if (element == ElementKind::Segment) return side_of_line({c[0], c[1]}, sample.point) == 0;
  return type_of(element).contact(c, sample.point).contact != Contact::Off;
}

}  // namespace

Place place_of(ElementKind element, const Sample& sample) {
  const ElementType& type = type_of(element);
  const auto& c = sample.corners;
  Place place;
  place.rounding = std::numeric_limits<double>::epsilon() * largest_coordinate(sample);
  const double rounding = kRoundings * place.rounding;

  place.size = 0;
  place.distance = place.edge = place.line = std::numeric_limits<double>::infinity();
  for (std::size_t k = 0; k < c.size(); ++k) {
    const Vec3<double> edge = c[(k + 1) % c.size()] - c[k], to = sample.point - c[k];
    const double along = std::clamp(to.dot(edge) / edge.squaredNorm(), 0.0, 1.0);
    place.size = std::max(place.size, edge.norm());
    place.distance = std::min(place.distance, to.norm());
    place.line = std::min(place.line, edge.cross(to).norm() / edge.norm());
    place.edge = std::min(place.edge, (to - along * edge).norm());
  }
  const Vec3<double> normal = type.normal(c, {0.25, 0.25, 0.25, 0.25}), unit = normal / normal.norm();
  const double height = unit.dot(sample.point - c[0]);
  place.normal = unit;
  place.foot = sample.point - height * unit;
  place.basis = basis_at(element, sample, place.foot);
  place.in_plane = std::abs(height) <= rounding;
  place.at_vertex = place.distance <= rounding;
  const bool has_border = type.dimension == 3;
  const bool inside =
      std::all_of(place.basis.begin(), place.basis.begin() + type.corners, [](double b) { return b > 0; });
  if (place.at_vertex || (has_border && place.edge <= rounding)) place.contact = Contact::Border;
  else if (place.in_plane && inside) place.contact = Contact::Interior;
  const Contact exactly = type.contact(c, sample.point).contact;
  place.exactly_off = exactly == Contact::Off;
  if (place.contact == Contact::Off && !place.exactly_off) place.contact = exactly;
  const bool is_corner = std::ranges::count(c, sample.point) > 0;
  place.ambiguous =
      exactly != place.contact || is_corner != place.at_vertex || exactly_in_plane(element, sample) != place.in_plane;
  place.height = std::abs(height) / place.size;
  place.distance /= place.size;
  place.edge /= place.size;
  place.line /= place.size;
  if (has_border) place.aspect = type.extent(c).norm() / (place.size * place.size);
  return place;
}

}  // namespace cageproof::judge
