// SPDX-License-Identifier: MIT
#include "cageproof/deformation/stretch.h"

#include "posed_range.h"
#include "quad_normals.h"
#include "stretched_squares.h"

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

template <Scalar R, class Vertices>
std::array<Vec3<R>, 2> tangents(const CageElements& rest, const Vertices& vertices, std::size_t element, int corner) {
  const auto corners = rest.vertices_of(element);
  const auto at = [&](int k) { return convert<R>(vertices[corners[k]]); };
  if (corners.size() == 4) {
    const Quad<R> q{at(corner), at((corner + 1) % 4), at((corner + 2) % 4), at((corner + 3) % 4)};
    return {Vec3<R>((2 * (q[1] - q[0]) + (q[2] - q[3])) / R(3)), Vec3<R>((2 * (q[3] - q[0]) + (q[2] - q[1])) / R(3))};
  }
  return {at(1) - at(0), corners.size() > 2 ? Vec3<R>(at(2) - at(0)) : Vec3<R>(R(0), R(0), R(1))};
}

// Outward, of no particular length; of tangents over their largest number, so that nothing leaves the range.
template <Scalar R>
Vec3<R> extent(const CageElements& rest, Vec3<R> u, Vec3<R> v) {
  const R of_u = u.cwiseAbs().maxCoeff(), of_v = v.cwiseAbs().maxCoeff();
  if (!(of_u > 0) || !(of_v > 0)) return Vec3<R>::Zero();
  u /= of_u;
  v /= of_v;
  if (rest.dimension() == 2) return {u[1], -u[0], R(0)};
  return u.cross(v);
}

// Edges from the corner between the two shorter ones, whose angle is the triangle's widest.
template <Scalar R>
std::array<std::array<Vec3<R>, 2>, 2> edges_of(const CageElements& rest, const std::vector<Vec3<R>>& vertices,
                                               std::size_t element) {
  const auto corners = rest.vertices_of(element);
  const auto side = [&](const auto& of, int from, int to) {
    return Vec3<R>(convert<R>(of[corners[to % 3]]) - convert<R>(of[corners[from % 3]]));
  };
  int corner = 0;
  R longest = -1;
  for (int k = 0; k < 3; ++k) {
    const R length = length_of(side(rest.vertices(), k + 1, k + 2));
    if (length > longest) longest = length, corner = k;
  }
  const auto edges = [&](const auto& of) {
    return std::array{side(of, corner, corner + 1), side(of, corner, corner + 2)};
  };
  return {edges(rest.vertices()), edges(vertices)};
}

// Divides edges by their largest number, so that squares stay in range.
template <Scalar R>
R unit_taken_from(std::array<Vec3<R>, 2>& edges) {
  const R unit = std::max<R>(edges[0].cwiseAbs().maxCoeff(), edges[1].cwiseAbs().maxCoeff());
  if (unit > 0)
    for (Vec3<R>& edge : edges) edge /= unit;
  return unit;
}

// The squares' sum and the product of the singular values.
template <Scalar R>
std::array<R, 2> singular_values_of(const std::array<Vec3<R>, 2>& from, const std::array<Vec3<R>, 2>& to) {
  const R area = length_of(Vec3<R>(from[0].cross(from[1]))), posed = length_of(Vec3<R>(to[0].cross(to[1])));
  // Edges in line by 1e-3 and less cancel.
  if constexpr (std::same_as<R, double>)
    if (!(area > 1e-3 * length_of(from[0]) * length_of(from[1]))) {
      const auto wide = [](const std::array<Vec3<R>, 2>& edges) {
        return std::array{convert<Mp50>(edges[0]), convert<Mp50>(edges[1])};
      };
      const auto [squares, product] = singular_values_of<Mp50>(wide(from), wide(to));
      return {static_cast<R>(squares), static_cast<R>(product)};
    }
  return {R(stretched_squares(from, to, area) / area / area), R(posed / area)};
}

}  // namespace

const std::vector<std::string_view>& stretch_names() {
  static const std::vector<std::string_view> names{"rms", "mean", "area", "unit"};
  return names;
}

const std::vector<std::string_view>& quad_stretch_names() {
  static const std::vector<std::string_view> names{"rms", "mean", "area", "unit", "product"};
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

std::string_view plural_of(Owner normals) {
  if (normals == Owner::Corner) return "corners of elements";
  return normals == Owner::Normal ? "corners of quads, and triangles" : "elements";
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
  check(normals, rest.count(normals_of), "normal derivatives", plural_of(normals_of));
  check(laplacians, vertices.size(), "Laplacians", "vertices");
  check(derivatives, rest.count(), "normal derivatives of Laplacians", "elements");
}

template <Scalar R>
std::array<Vec3<R>, 2> tangents_of(const CageElements& rest, const std::vector<Vec3<R>>& vertices, std::size_t element,
                                   int corner) {
  return tangents<R>(rest, vertices, element, corner);
}

template <Scalar R>
Vec3<R> posed_normal(const CageElements& rest, const std::vector<Vec3<R>>& vertices, std::size_t element, int corner) {
  const auto [u, v] = tangents<R>(rest, vertices, element, corner);
  check_range<R>(rest, element, std::max<R>(u.cwiseAbs().maxCoeff(), v.cwiseAbs().maxCoeff()));
  const Vec3<R> n = extent<R>(rest, u, v);
  const R length = length_of(n);
  if (!(length > 0))
    throw InputError(fmt::format(
        "the posed {} {} (vertices {}) has no {}{}, and so no normal", rest.type(element).name, element,
        fmt::join(rest.vertices_of(element), ", "), rest.dimension() == 2 ? "length" : "area",
        rest.type(element).flat ? "" : fmt::format(" next to vertex {}", rest.vertices_of(element)[corner])));
  return n / length;
}

template <Scalar R>
R stretch_of(Stretch stretch, const CageElements& rest, const std::vector<Vec3<R>>& vertices, std::size_t element,
             int corner) {
  using std::sqrt;
  if (stretch == Stretch::Unit) return R(1);
  if (rest.dimension() == 2) {
    const R posed = length_of(tangents<R>(rest, vertices, element, 0)[0]);
    check_range(rest, element, posed);
    return posed / length_of(tangents<R>(rest, rest.vertices(), element, 0)[0]);
  }
  auto [from, to] = rest.type(element).flat ? edges_of<R>(rest, vertices, element)
                                            : std::array{tangents<R>(rest, rest.vertices(), element, corner),
                                                         tangents<R>(rest, vertices, element, corner)};
  const R unit = unit_taken_from(from), posed_unit = unit_taken_from(to);
  check_range(rest, element, posed_unit);
  const R ratio = posed_unit / unit;
  const auto [squares, product] = singular_values_of(from, to);
  switch (stretch) {
    case Stretch::Rms: return ratio * sqrt(R(squares / 2));
    case Stretch::Mean: return ratio * (sqrt(R(squares + 2 * product)) / 2);
    case Stretch::Product: return ratio * ratio * product;
    default: return ratio * sqrt(product);
  }
}

template <Scalar R>
std::vector<Vec3<R>> stretched_normals(Stretch stretch, const CageElements& rest,
                                       const std::vector<Vec3<R>>& vertices) {
  std::vector<Vec3<R>> normals;
  normals.reserve(rest.count(Owner::Normal));
  for (std::size_t e = 0; e < rest.count(); ++e) {
    if (!rest.type(e).flat) {
      for (Vec3<R>& normal : quad_normals(stretch, rest, vertices, e)) normals.push_back(std::move(normal));
      continue;
    }
    const R factor = stretch_of(stretch, rest, vertices, e);
    if (takes_no_area(stretch) && factor == 0) normals.push_back(Vec3<R>::Zero());
    else normals.push_back(factor * posed_normal(rest, vertices, e));
  }
  return normals;
}

#define CAGEPROOF_INSTANTIATE(R)                                                                                      \
  template std::vector<Vec3<R>> vertices_in<R>(const CageElements&);                                                  \
  template void check_pose<R>(const CageElements&, const Pose<R>&, Owner);                                            \
  template std::array<Vec3<R>, 2> tangents_of<R>(const CageElements&, const std::vector<Vec3<R>>&, std::size_t, int); \
  template Vec3<R> posed_normal<R>(const CageElements&, const std::vector<Vec3<R>>&, std::size_t, int);               \
  template R stretch_of<R>(Stretch, const CageElements&, const std::vector<Vec3<R>>&, std::size_t, int);              \
  template std::vector<Vec3<R>> stretched_normals<R>(Stretch, const CageElements&, const std::vector<Vec3<R>>&);
CAGEPROOF_INSTANTIATE(double)
CAGEPROOF_INSTANTIATE(Mp50)
#undef CAGEPROOF_INSTANTIATE

}  // namespace cageproof::deformation
