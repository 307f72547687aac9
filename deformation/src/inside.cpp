// SPDX-License-Identifier: MIT
#include "cageproof/deformation/inside.h"

#include "cageproof/core/geometry/quad_geometry.h"
#include "cageproof/core/geometry/winding_number.h"

#include <optional>

namespace cageproof::deformation {
namespace {

using TrianglePair = std::array<Triangle<double>, 2>;

bool touches(const TrianglePair& pair, const Vec3<double>& point) {
  const ElementType& type = type_of(ElementKind::Triangle);
  return type.contact(pair[0], point).contact != Contact::Off || type.contact(pair[1], point).contact != Contact::Off;
}

// Two triangles with the quad's border that the point sees under the quad's own solid angle. \pre the point is not on
// the quad
TrianglePair seen_as(const Quad<double>& q, const Vec3<double>& point) {
  TrianglePair first{Triangle<double>{q[0], q[1], q[2]}, {q[0], q[2], q[3]}},
      second{Triangle<double>{q[1], q[2], q[3]}, {q[1], q[3], q[0]}};
  switch (seen_triangles(q, point)) {
    case SeenTriangles::Diagonal02: return first;
    case SeenTriangles::Diagonal13: return second;
    case SeenTriangles::Coplanar: break;
  }
  // Off the triangles that the point lies in the plane of, both pairs are the same to it; on one of them, the quad is
  // on the other pair's side.
  return touches(first, point) ? second : first;
}

}  // namespace

Inside::Inside(const CageElements& elements) {
  for (std::size_t e = 0; e < elements.count(); ++e) {
    const auto c = elements.corners(e);
    if (c.size() == 2) segments_.push_back({c[0], c[1]});
    else if (c.size() == 3) triangles_.push_back({c[0], c[1], c[2]});
    else quads_.push_back({c[0], c[1], c[2], c[3]});
  }
}

bool Inside::holds(const Vec3<double>& point) const {
  std::optional<int> winding;
  if (!segments_.empty()) {
    winding = winding_number(segments_, point);
  } else {
    std::vector<Triangle<double>> seen = triangles_;
    for (const Quad<double>& q : quads_) {
      if (on_quad(q, point)) return true;
      for (const Triangle<double>& triangle : seen_as(q, point)) seen.push_back(triangle);
    }
    winding = winding_number(seen, point);
  }
  return !winding || *winding != 0;
}

}  // namespace cageproof::deformation
