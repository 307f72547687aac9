// SPDX-License-Identifier: MIT
#include "cageproof/deformation/stretch.h"

#include "cageproof/core/input_error.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>

namespace cageproof::deformation {
namespace {

// Length, without overflow or underflow.
template <Scalar R>
R length_of(const Vec3<R>& v) {
  using std::sqrt;
  const R largest = v.cwiseAbs().maxCoeff();
  if (!(largest > 0)) return R(0);
  const Vec3<R> scaled = v / largest;
  return largest * R(sqrt(R(scaled.dot(scaled))));
}

// The edges from the first corner: one of a segment, two of a triangle.
template <Scalar R, class Vertices>
std::array<Vec3<R>, 2> edges_of(const CageElements& rest, const Vertices& vertices, std::size_t element) {
  const auto corners = rest.vertices_of(element);
  const Vec3<R> first = convert<R>(vertices[corners[0]]);
  return {convert<R>(vertices[corners[1]]) - first,
          corners.size() > 2 ? Vec3<R>(convert<R>(vertices[corners[2]]) - first) : Vec3<R>(R(0), R(0), R(1))};
}

// Outward, as long as the segment, or as twice the triangle's area; of edges over their largest number, so that nothing
// leaves the range.
template <Scalar R>
Vec3<R> extent(const CageElements& rest, const std::vector<Vec3<R>>& vertices, std::size_t element) {
  auto [u, v] = edges_of<R>(rest, vertices, element);
  const R of_u = u.cwiseAbs().maxCoeff(), of_v = v.cwiseAbs().maxCoeff();
  if (!(of_u > 0) || !(of_v > 0)) return Vec3<R>::Zero();
  u /= of_u;
  v /= of_v;
  if (rest.dimension() == 2) return {u[1], -u[0], R(0)};
  return u.cross(v);
}

// The squares' sum and the product of the singular values: with the rest edges' Gram matrix g and the posed ones' h,
// trace(g^-1 h) and sqrt(det h / det g).
template <Scalar R>
std::array<R, 2> singular_values_of(const std::array<Vec3<R>, 2>& from, const std::array<Vec3<R>, 2>& to) {
  using std::sqrt;
  const R a = from[0].dot(from[0]), b = from[0].dot(from[1]), c = from[1].dot(from[1]);
  const Vec3<R> area = from[0].cross(from[1]), posed = to[0].cross(to[1]);
  const R square = area.dot(area);
  const R trace = (c * to[0].dot(to[0]) - 2 * b * to[0].dot(to[1]) + a * to[1].dot(to[1])) / square;
  return {trace, R(length_of(posed) / sqrt(square))};
}

}  // namespace

const std::vector<std::string_view>& stretch_names() {
  static const std::vector<std::string_view> names{"rms", "mean", "area", "unit"};
  return names;
}

template <Scalar R>
std::vector<Vec3<R>> vertices_in(const CageElements& rest) {
  std::vector<Vec3<R>> found;
  found.reserve(rest.vertices().size());
  for (const Vec3<double>& v : rest.vertices()) found.push_back(convert<R>(v));
  return found;
}

Owner normals_owner(const CageCoordinates& coordinates) {
  const auto found = std::ranges::find(coordinates.blocks(), Reproduces::Normals, &CoordinateBlock::reproduces);
  return found == coordinates.blocks().end() ? Owner::Element : found->owner;
}

template <Scalar R>
void check_pose(const CageElements& rest, const Pose<R>& pose, Owner normals_of) {
  const auto& [vertices, normals, laplacians, derivatives] = pose;
  const auto is_finite = [](const Vec3<R>& row) { return row - row == Vec3<R>::Zero(); };
  if (vertices.size() != rest.vertices().size())
    throw InputError(
        fmt::format("the posed cage has {} vertices, the rest cage {}", vertices.size(), rest.vertices().size()));
  for (std::size_t v = 0; v < vertices.size(); ++v)
    if (!is_finite(vertices[v])) throw InputError(fmt::format("the posed cage's vertex {} is not finite", v));
  const auto check = [&](const std::vector<Vec3<R>>& rows, std::size_t count, std::string_view what,
                         std::string_view of) {
    if (!rows.empty() && rows.size() != count)
      throw InputError(fmt::format("there are {} {}, the rest cage has {} {}", rows.size(), what, count, of));
    for (std::size_t i = 0; i < rows.size(); ++i)
      if (!is_finite(rows[i])) throw InputError(fmt::format("row {} of the {} is not finite", i, what));
  };
  check(normals, rest.count(normals_of), "normal derivatives",
        normals_of == Owner::Corner ? "corners of elements" : "elements");
  check(laplacians, vertices.size(), "Laplacians", "vertices");
  check(derivatives, rest.count(), "normal derivatives of Laplacians", "elements");
}

template <Scalar R>
Vec3<R> posed_normal(const CageElements& rest, const std::vector<Vec3<R>>& vertices, std::size_t element) {
  const Vec3<R> n = extent(rest, vertices, element);
  const R length = length_of(n);
  if (!(length > 0))
    throw InputError(fmt::format("the posed {} {} (vertices {}) has no {}, and so no normal", rest.type(element).name,
                                 element, fmt::join(rest.vertices_of(element), ", "),
                                 rest.dimension() == 2 ? "length" : "area"));
  return n / length;
}

template <Scalar R>
R stretch_of(Stretch stretch, const CageElements& rest, const std::vector<Vec3<R>>& vertices, std::size_t element) {
  using std::sqrt;
  if (stretch == Stretch::Unit) return R(1);
  auto from = edges_of<R>(rest, rest.vertices(), element), to = edges_of<R>(rest, vertices, element);
  if (rest.dimension() == 2) return length_of(to[0]) / length_of(from[0]);
  // In a unit of the rest element's own, so that squares of areas stay in range.
  const R unit = length_of(from[0]);
  for (auto* edges : {&from, &to})
    for (Vec3<R>& edge : *edges) edge /= unit;
  const auto [squares, product] = singular_values_of(from, to);
  if (stretch == Stretch::Rms) return sqrt(R(squares / 2));
  if (stretch == Stretch::Mean) return sqrt(R(squares + 2 * product)) / 2;
  return sqrt(product);
}

template <Scalar R>
std::vector<Vec3<R>> stretched_normals(Stretch stretch, const CageElements& rest,
                                       const std::vector<Vec3<R>>& vertices) {
  std::vector<Vec3<R>> normals;
  normals.reserve(rest.count());
  for (std::size_t e = 0; e < rest.count(); ++e) {
    const R factor = stretch_of(stretch, rest, vertices, e);
    if (stretch == Stretch::Area && factor == 0) normals.push_back(Vec3<R>::Zero());
    else normals.push_back(factor * posed_normal(rest, vertices, e));
  }
  return normals;
}

#define CAGEPROOF_INSTANTIATE(R)                                                                    \
  template std::vector<Vec3<R>> vertices_in<R>(const CageElements&);                                \
  template void check_pose<R>(const CageElements&, const Pose<R>&, Owner);                          \
  template Vec3<R> posed_normal<R>(const CageElements&, const std::vector<Vec3<R>>&, std::size_t);  \
  template R stretch_of<R>(Stretch, const CageElements&, const std::vector<Vec3<R>>&, std::size_t); \
  template std::vector<Vec3<R>> stretched_normals<R>(Stretch, const CageElements&, const std::vector<Vec3<R>>&);
CAGEPROOF_INSTANTIATE(double)
CAGEPROOF_INSTANTIATE(Mp50)
#undef CAGEPROOF_INSTANTIATE

}  // namespace cageproof::deformation
