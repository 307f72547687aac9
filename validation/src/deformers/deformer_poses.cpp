// SPDX-License-Identifier: MIT
#include "deformer_poses.h"

#include "cageproof/core/numbers/random_stream.h"
#include "cageproof/core/numbers/scalar_names.h"
#include "run/fingerprint.h"

#include <fmt/format.h>

#include <Eigen/Geometry>

#include <algorithm>

namespace cageproof::validation {

std::vector<SpaceMap> space_maps(int dimension) {
  const Vec3<double> axis = dimension == 3 ? Vec3<double>(1, 2, 3) : Vec3<double>(0, 0, 1);
  SpaceMap identity{"keeps_rigid", "identity"}, shift{"keeps_rigid", "shift"}, rotation{"keeps_rigid", "rotation"},
      scale{"keeps_scale", "scale"}, mirror{"keeps_mirror", "mirror"}, linear{"keeps_linear", "linear"};
  shift.shift << 0.3, -0.2, (dimension == 3 ? 0.5 : 0);
  rotation.linear = Eigen::AngleAxisd(0.8, axis.normalized()).toRotationMatrix();
  scale.linear *= 1.5;
  mirror.linear(dimension - 1, dimension - 1) = -1;
  linear.linear << 1.3, 0.2, -0.1, 0.05, 0.8, 0.3, -0.2, 0.1, 1.1;
  if (dimension == 2) {
    linear.linear.row(2).setZero();
    linear.linear.col(2).setZero();
  }
  return {identity, shift, rotation, scale, mirror, linear};
}

std::array<SpaceMap, 2> offsets(int dimension) {
  std::array<SpaceMap, 2> found{SpaceMap{"keeps_offset", "1e3 sizes off"}, SpaceMap{"keeps_offset", "1e6 sizes off"}};
  const Vec3<double> along(1, -0.7, dimension == 3 ? 0.4 : 0);
  found[0].shift = 1e3 * along;
  found[1].shift = 1e6 * along;
  return found;
}

double largest_coordinate(const std::vector<Vec3<double>>& points) {
  double largest = 0;
  for (const Vec3<double>& p : points) largest = std::max(largest, p.cwiseAbs().maxCoeff());
  return largest;
}

std::vector<Vec3<double>> posed_by(const SpaceMap& map, const Cage& cage) {
  std::vector<Vec3<double>> posed;
  posed.reserve(cage.vertices().size());
  for (const Vec3<double>& v : cage.vertices()) posed.push_back(map(v, cage.size()));
  return posed;
}

std::vector<Vec3<double>> bent(const Cage& cage) {
  std::vector<Vec3<double>> posed = cage.vertices();
  const std::string stream = fmt::format("bent/{}", drawn_by(cage));
  for (std::size_t v = 0; v < posed.size(); ++v) {
    RandomStream random(0, stream, v);
    for (int c = 0; c < cage.dimension(); ++c) posed[v][c] += cage.size() * random.uniform(-0.05, 0.05);
  }
  return posed;
}

}  // namespace cageproof::validation
