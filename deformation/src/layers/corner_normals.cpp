// SPDX-License-Identifier: MIT
#include "corner_normals.h"

#include "../turns.h"

namespace cageproof::deformation {

template <Scalar R>
std::vector<Vec3<R>> corner_normals(Stretch stretch, const CageElements& rest, const std::vector<Vec3<R>>& vertices,
                                    std::vector<std::string>& warnings) {
  const int d = rest.dimension();
  const std::vector<SpaceMatrix<R>> rotations = vertex_rotations(rest, vertices, warnings);
  const std::vector<Vec3<R>> from = vertices_in<R>(rest);
  std::vector<Vec3<R>> found;
  found.reserve(rest.count(Owner::Corner));
  for (std::size_t e = 0; e < rest.count(); ++e) {
    const Vec3<R> normal = stretch_of(stretch, rest, vertices, e) * posed_normal(rest, from, e);
    for (const int v : rest.vertices_of(e)) {
      Vec3<R> turned = Vec3<R>::Zero();
      turned.head(d) = rotations[v] * normal.head(d);
      found.push_back(turned);
    }
  }
  return found;
}

template std::vector<Vec3<double>> corner_normals<double>(Stretch, const CageElements&,
                                                          const std::vector<Vec3<double>>&, std::vector<std::string>&);
template std::vector<Vec3<Mp50>> corner_normals<Mp50>(Stretch, const CageElements&, const std::vector<Vec3<Mp50>>&,
                                                      std::vector<std::string>&);

}  // namespace cageproof::deformation
