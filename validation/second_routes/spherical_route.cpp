// SPDX-License-Identifier: MIT
#include "spherical_route.h"

#include "panels.h"

#include <algorithm>
#include <array>

namespace cageproof::second_routes {
namespace {

using Vec = Vec3<Mp100>;

Mp100 length_of(const Vec& v) { return sqrt(Mp100(v.dot(v))); }

Vec unit_of(const Vec& v) { return v / length_of(v); }

const Vec& next_of(std::span<const Vec> polygon, std::size_t i) { return polygon[(i + 1) % polygon.size()]; }

// An axis to count polar coordinates from: any serves, since the integral over the whole sphere is zero. Of two that
// lie within most polygons the one that is further from the great circles of the arcs.
Vec axis_of(std::span<const Vec> corners) {
  Vec turning = Vec::Zero(), middle = Vec::Zero();
  for (std::size_t i = 0; i < corners.size(); ++i) {
    turning += corners[i].cross(next_of(corners, i));
    middle += corners[i];
  }
  const auto distance = [&](const Vec& axis) {
    double least = 2;
    for (std::size_t i = 0; i < corners.size(); ++i) {
      const Vec normal = corners[i].cross(next_of(corners, i));
      least = std::min(least, std::abs(static_cast<double>(Mp100(axis.dot(normal) / length_of(normal)))));
    }
    return least;
  };
  Vec best = Vec::Zero();
  double furthest = -1;
  for (const Vec& axis : {turning, middle}) {
    if (Mp100(axis.dot(axis)) < Mp100("1e-60")) continue;
    const double found = distance(unit_of(axis));
    if (found > furthest) best = unit_of(axis), furthest = found;
  }
  return best;
}

Vec across(const Vec& p, const Vec& axis) { return p - p.dot(axis) * axis; }

// The part of the mean vector over the spherical triangle of the axis and an arc, signed.
Vec over_triangle(const Vec& axis, const Vec& a, const Vec& b) {
  const Mp100 turn = axis.dot(a.cross(b));
  std::vector<std::complex<double>> poles = zeros_of_length(convert<double>(a), convert<double>(b));
  std::ranges::copy(zeros_of_length(convert<double>(across(a, axis)), convert<double>(across(b, axis))),
                    std::back_inserter(poles));
  Vec sum = Vec::Zero();
  // Along the chord: the azimuth phi grows by turn/|p'|^2 dt, p' = p across the axis. The integral over a radius,
  // theta from 0 to that of p, of (axis cos theta + e sin theta) sin theta d theta is elementary.
  over_panels(panel_ends(poles), [&](const Mp100& t, const Mp100& weight) {
    const Vec p = (1 - t) * a + t * b, aside = across(p, axis);
    const Mp100 far = length_of(aside), up = p.dot(axis), square = far * far + up * up;
    const Mp100 of_axis = far * far / square / 2, of_aside = (atan2(far, up) - far * up / square) / 2;
    const Mp100 d_phi = weight * turn / (far * far);
    sum += d_phi * of_axis * axis + d_phi * of_aside / far * aside;
  });
  return sum;
}

// Weights w of a face's corners with sum w_i (q_i - x) the face's mean vector, in its mean value coordinates.
std::vector<Mp100> weights_of(std::span<const Vec> to_corner) {
  std::vector<Vec> corners, tangents;
  for (const Vec& q : to_corner) corners.push_back(unit_of(q));
  const Vec mean = mean_vector(corners);
  const Mp100 size = length_of(mean);
  // In the plane of a planar face the mean vector vanishes, and with it the rule's weights.
  if (size < Mp100("1e-45")) return std::vector<Mp100>(to_corner.size());
  const Vec axis = mean / size;
  for (const Vec& u : corners) tangents.push_back(unit_of(across(u, axis)));
  std::vector<Mp100> weights = shares_of_directions(tangents, axis);
  Mp100 along = 0;
  for (std::size_t i = 0; i < weights.size(); ++i) {
    weights[i] /= length_of(across(to_corner[i], axis));
    along += weights[i] * to_corner[i].dot(axis);
  }
  for (Mp100& w : weights) w *= size / along;
  return weights;
}

}  // namespace

Vec3<Mp100> mean_vector(std::span<const Vec3<Mp100>> corners) {
  const Vec axis = axis_of(corners);
  Vec sum = Vec::Zero();
  for (std::size_t i = 0; i < corners.size(); ++i) sum += over_triangle(axis, corners[i], next_of(corners, i));
  return sum;
}

std::vector<Mp100> shares_of_directions(std::span<const Vec3<Mp100>> tangents, const Vec3<Mp100>& axis) {
  std::vector<Mp100> shares(tangents.size());
  for (std::size_t i = 0; i < tangents.size(); ++i) {
    const Vec &a = tangents[i], &b = next_of(tangents, i);
    const Mp100 turn = axis.dot(a.cross(b));
    // The direction of q = (1 - t) a + t b is q/|q|, and turns by turn/|q|^2 dt.
    over_panels(panel_ends(zeros_of_length(convert<double>(a), convert<double>(b))),
                [&](const Mp100& t, const Mp100& weight) {
                  const Vec q = (1 - t) * a + t * b;
                  const Mp100 square = q.dot(q), density = weight * turn / (square * sqrt(square));
                  shares[i] += (1 - t) * density;
                  shares[(i + 1) % tangents.size()] += t * density;
                });
  }
  return shares;
}

std::vector<Mp100> spherical_coordinates(const Cage& cage, const Vec3<double>& point) {
  const Vec x = convert<Mp100>(point);
  std::vector<Mp100> found(cage.vertices().size());
  for (const Face& face : cage.faces()) {
    std::vector<Vec> to_corner;
    to_corner.reserve(face.size());
    for (int k = 0; k < face.size(); ++k) to_corner.push_back(convert<Mp100>(cage.vertices()[face.vertices[k]]) - x);
    const std::vector<Mp100> weights = weights_of(to_corner);
    for (int k = 0; k < face.size(); ++k) found[face.vertices[k]] += weights[k];
  }
  Mp100 total = 0;
  for (const Mp100& w : found) total += w;
  for (Mp100& w : found) w /= total;
  return found;
}

}  // namespace cageproof::second_routes
