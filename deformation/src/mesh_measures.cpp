// SPDX-License-Identifier: MIT
#include "cageproof/deformation/mesh_measures.h"

#include "in_space.h"

#include "cageproof/core/cage/enclosed.h"

#include <Eigen/SVD>

#include <algorithm>
#include <cmath>
#include <limits>

namespace cageproof::deformation {
namespace {

constexpr double not_known = std::numeric_limits<double>::quiet_NaN();

// A least singular value of so much of the largest is rounding: coordinates and their sums lose a few digits of 16.
constexpr double flat = 1e-12;

Content cage_content(const CageElements& cage, const std::vector<Vec3<double>>& vertices, double unit) {
  std::vector<std::vector<int>> faces;
  std::vector<std::array<int, 2>> segments;
  for (std::size_t e = 0; e < cage.count(); ++e) {
    const auto corners = cage.vertices_of(e);
    if (corners.size() == 2) segments.push_back({corners[0], corners[1]});
    else faces.emplace_back(corners.begin(), corners.end());
  }
  return content_of({faces, segments, cage.dimension()}, vertices, {.length = unit});
}

// Zero where the parts cancel and only rounding is left, as when a mesh is pressed flat.
double ratio_of(const Content& after, const Content& before) {
  if (!before.is_known()) return not_known;
  return after.is_known() ? after.value / before.value : 0;
}

// An open mesh holds no volume, and in the plane closed faces hold none, either.
double mesh_ratio(const Mesh& rest, const std::vector<Vec3<double>>& moved, int dimension, double unit) {
  if (!is_closed({rest.faces, rest.segments, dimension})) return not_known;
  const std::vector<std::vector<int>> no_faces;
  const Connectivity connectivity{dimension == 3 ? rest.faces : no_faces, rest.segments, dimension};
  return ratio_of(content_of(connectivity, moved, {.length = unit}),
                  content_of(connectivity, rest.vertices, {.length = unit}));
}

JacobianMeasures jacobian_measures(const std::vector<double>& jacobians, const std::vector<char>& missing, int d) {
  JacobianMeasures found{HUGE_VAL, -HUGE_VAL};
  for (std::size_t p = 0; p < missing.size(); ++p) {
    if (missing[p]) continue;
    const Eigen::Map<const Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>> jacobian(
        &jacobians[p * d * d], d, d);
    if (!jacobian.allFinite()) {
      ++found.without;
      continue;
    }
    const SpaceVector<double> values =
        Eigen::JacobiSVD<SpaceMatrix<double>, Eigen::NoQRPreconditioner>(jacobian).singularValues();
    found.least_singular_value = std::min(found.least_singular_value, values[d - 1]);
    found.largest_singular_value = std::max(found.largest_singular_value, values[0]);
    // A flat image is not turned: only rounding gives its determinant a sign.
    found.turned += values[d - 1] > flat * values[0] && in_three<double>(jacobian).determinant() < 0 ? 1 : 0;
  }
  return found;
}

}  // namespace

MeshMeasures measures_of(const CageElements& cage, double size, const std::vector<Vec3<double>>& posed,
                         const Mesh& rest, const PointImages& images, std::size_t map, int order) {
  const int d = cage.dimension();
  const std::vector<Vec3<double>> moved = vertices_of(images.maps[map], d);
  MeshMeasures found;
  double sum = 0;
  found.largest_displacement = 0;
  for (std::size_t p = 0; p < moved.size(); ++p) {
    if (images.missing[p]) continue;
    const double step = (moved[p] - rest.vertices[p]).stableNorm();
    found.largest_displacement = std::max(found.largest_displacement, step);
    sum += step;
  }
  found.missing = static_cast<std::size_t>(std::ranges::count(images.missing, 1));
  const std::size_t present = moved.size() - found.missing;
  found.mean_displacement = present > 0 ? sum / static_cast<double>(present) : not_known;
  if (present == 0) found.largest_displacement = not_known;
  found.cage_ratio =
      posed.empty() ? not_known : ratio_of(cage_content(cage, posed, size), cage_content(cage, cage.vertices(), size));
  found.mesh_ratio = mesh_ratio(rest, moved, d, size);
  if (order >= 1) found.jacobians = jacobian_measures(images.maps[map].tensors[1], images.missing, d);
  return found;
}

}  // namespace cageproof::deformation
