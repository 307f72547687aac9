// SPDX-License-Identifier: MIT
#include "cageproof/deformation/pose_reach.h"

#include "cageproof/core/cage/embedded_cages.h"
#include "cageproof/core/input_error.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace cageproof::deformation {
namespace {

constexpr double kRounding = std::numeric_limits<double>::epsilon();
// Roundings of a few operations.
constexpr double kOutward = 1 + 32 * kRounding;

// The largest norm of sum u_k g_k', over vectors u_k of length one, as pose_reach() says. Corners in units of the cage.
double most_change(const std::array<Vec3<double>, 3>& corners) {
  std::array<double, 3> squares{};
  for (int k = 0; k < 3; ++k) squares[k] = (corners[(k + 2) % 3] - corners[(k + 1) % 3]).squaredNorm();
  const double longest = std::ranges::max(squares);
  const double cross = (corners[1] - corners[0]).cross(corners[2] - corners[0]).norm();
  const double twice_area = cross - 8 * kRounding * longest;
  if (!(twice_area > 0)) return std::numeric_limits<double>::infinity();
  // |g_k| is an edge over twice the area, and any two of them span a parallelogram of 1/(twice the area).
  const double trace = (squares[0] + squares[1] + squares[2]) / twice_area / twice_area;
  const double product = 3 / twice_area / twice_area;
  const double largest = (trace + std::sqrt(std::max(0.0, trace * trace - 4 * product))) / 2;
  const double sum = (std::sqrt(squares[0]) + std::sqrt(squares[1]) + std::sqrt(squares[2])) / twice_area;
  return kOutward * std::min(sum, std::sqrt(3 * largest));
}

// How far a stretched normal may be from the normal at rest.
double most_turned(const CageElements& elements, std::size_t element, double moved, double size) {
  std::vector<Vec3<double>> corners = elements.corners(element);
  for (const Vec3<double> origin = corners[0]; Vec3<double> & corner : corners) corner = (corner - origin) / size;
  const double share = moved / size;
  if (share == 0) return 0;
  const double rho =
      kOutward * share *
      (elements.dimension() == 2 ? 2 / corners[1].norm() : most_change({corners[0], corners[1], corners[2]}));
  const double always = 2 + rho / std::sqrt(2.0);
  if (!(rho < .999)) return kOutward * always;
  const double near = rho * std::sqrt(1 + 2 * (1 + rho) / (1 + std::sqrt(1 - rho * rho)));
  return kOutward * std::min(always, near);
}

std::string why_not(const CoordinateBlock& block, const CageElements& elements) {
  if (block.entries() > 1) return fmt::format("its {} are matrices, which multiply tractions, too", block.label);
  if (block.reproduces == Reproduces::Nothing)
    return fmt::format("its {} multiply data of one's own, such as Laplacians, which no pose bounds", block.label);
  if (block.reproduces != Reproduces::Normals) return "";
  if (block.owner == Owner::Corner)
    return fmt::format("its {} multiply normal derivatives that vary within an element", block.label);
  for (std::size_t e = 0; e < elements.count(); ++e)
    if (!elements.type(e).flat) return fmt::format("its {} multiply normals of bilinear quads", block.label);
  return "";
}

}  // namespace

std::string why_without_reach(const CageCoordinates& coordinates) {
  for (const CoordinateBlock& block : coordinates.blocks())
    if (std::string why = why_not(block, coordinates.elements()); !why.empty()) return why;
  return "";
}

std::vector<std::string_view> kinds_with_reach(int dimension) {
  const Cage cage = embedded_cage(dimension == 2 ? "square" : "cube");
  std::vector<std::string_view> names;
  for (const CoordinateKind& kind : coordinate_kinds())
    if (accepts(kind, cage) && why_without_reach(CageCoordinates(cage, kind, CoordinateOptions{})).empty())
      names.push_back(kind.name);
  return names;
}

std::vector<PoseReach> pose_reach(const CageCoordinates& coordinates, double moved, double size) {
  if (const std::string why = why_without_reach(coordinates); !why.empty())
    throw InputError(fmt::format("{}: {}", coordinates.kind().name, why));
  const CageElements& elements = coordinates.elements();
  std::vector<PoseReach> reaches;
  int group = 0;
  for (const CoordinateBlock& block : coordinates.blocks()) {
    for (std::size_t i = 0; i < static_cast<std::size_t>(block.size); ++i) {
      if (block.reproduces == Reproduces::Normals) {
        const std::size_t e = elements.element_of(i, block.owner);
        const double factor = block.normal_factor;
        reaches.push_back(
            {factor * elements.normals()[e], most_turned(elements, e, moved, size) * std::abs(factor), -1});
      } else {
        const Vec3<double>& v = elements.vertices()[i];
        const bool turned = block.reproduces == Reproduces::TurnedVertices;
        reaches.push_back({turned ? Vec3<double>(-v[1], v[0], 0) : v, moved, group});
      }
    }
    if (block.reproduces != Reproduces::Normals) ++group;
  }
  return reaches;
}

}  // namespace cageproof::deformation
