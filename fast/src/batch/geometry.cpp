// SPDX-License-Identifier: MIT
#include "cageproof/core/geometry/box.h"
#include "far_rules.h"
#include "geometry.h"
#include "near_points.h"

#include <algorithm>
#include <cmath>
#include <map>

namespace cageproof::closed_form::batch {
namespace {

using LongVector = std::array<Mp200, 3>;

Mp200 product(const LongVector& a, const LongVector& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }
LongVector cross_of(const LongVector& a, const LongVector& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}
LongVector times(const LongVector& a, const Mp200& x) { return {a[0] * x, a[1] * x, a[2] * x}; }
void put(Mp200 (&to)[3], const LongVector& from) {
  for (int i = 0; i < 3; ++i) to[i] = from[i];
}

TwoDoubles two(const Mp200& x) {
  const auto high = static_cast<double>(x);
  return {high, static_cast<double>(Mp200(x - high))};
}
double one(const Mp200& x) { return static_cast<double>(x); }

// A table of other constants.
template <class To, class Convert>
FaceTable<To> converted(const FaceTable<Mp200>& from, Convert convert) {
  FaceTable<To> to;
  for (int i = 0; i < 3; ++i) {
    to.vertex[i] = from.vertex[i];
    to.edge[i] = from.edge[i];
    to.along[i] = from.along[i];
    to.length[i] = convert(from.length[i]);
    to.n[i] = convert(from.n[i]);
    for (int c = 0; c < 3; ++c) {
      to.nu[i][c] = convert(from.nu[i][c]);
      to.u[i][c] = convert(from.u[i][c]);
      to.middle[i][c] = convert(from.middle[i][c]);
    }
    for (int k = 0; k < 2; ++k) {
      to.g[k][i] = convert(from.g[k][i]);
      to.across[k][i] = convert(from.across[k][i]);
    }
  }
  for (int k = 0; k < 2; ++k) to.hat[k] = convert(from.hat[k]);
  to.area2 = convert(from.area2);
  to.steep = from.steep;
  to.steep_around = from.steep_around;
  return to;
}
template <class To, class Convert>
EdgeTable<To> converted(const EdgeTable<Mp200>& from, Convert convert) {
  return {from.from,
          from.to,
          {convert(from.u[0]), convert(from.u[1]), convert(from.u[2])},
          convert(from.length),
          convert(from.over)};
}

}  // namespace

void Geometry::find_unit(const CageElements& elements) {
  const auto [low, high] = box_of(elements.vertices());
  const double size = (high / 2 - low / 2).cwiseAbs().maxCoeff();
  sound_ = size > 0 && std::isfinite(size);
  if (!sound_) return;
  exponent_ = std::ilogb(size) + 1;
  for (const Vec3<double>& v : elements.vertices())
    for (int i = 0; i < 3; ++i) {
      vertex_.push_back(std::ldexp(v[i], -exponent_));
      sound_ = sound_ && std::ldexp(vertex_.back(), exponent_) == v[i];
    }
  for (int i = 0; i < 3; ++i) centre_[i] = std::ldexp(low[i] / 2 + high[i] / 2, -exponent_);
  for (std::size_t v = 0; v < vertex_.size(); v += 3)
    radius_ = std::max(radius_,
                       std::hypot(vertex_[v] - centre_[0], vertex_[v + 1] - centre_[1], vertex_[v + 2] - centre_[2]));
}

void Geometry::number_edges() {
  std::map<std::pair<int, int>, int> numbers;
  for (const std::array<int, 3>& corners : corner_) {
    std::array<int, 3> mine{};
    for (int e = 0; e < 3; ++e) {
      const auto ends = std::minmax(corners[e], corners[(e + 1) % 3]);
      const auto [place, added] = numbers.try_emplace({ends.first, ends.second}, static_cast<int>(ends_.size()));
      if (added) ends_.emplace_back(ends.first, ends.second);
      mine[e] = place->second;
    }
    edge_of_.push_back(mine);
  }
}

Geometry::Geometry(const CageElements& elements) {
  find_unit(elements);
  if (!sound_) return;
  for (std::size_t f = 0; f < elements.count(); ++f) {
    const auto corners = elements.vertices_of(f);
    corner_.push_back({corners[0], corners[1], corners[2]});
  }
  number_edges();
  edge_.resize(ends_.size());
  fine_edge_.resize(ends_.size());
  for (int f = 0; f < static_cast<int>(corner_.size()) && sound_; ++f) {
    const LongFace found = long_face(f);
    face_.push_back(converted<double>(found.face, one));
    fine_face_.push_back(converted<TwoDoubles>(found.face, two));
    for (int e = 0; e < 3; ++e) {
      edge_[found.face.edge[e]] = converted<double>(found.edge[e], one);
      fine_edge_[found.face.edge[e]] = converted<TwoDoubles>(found.edge[e], two);
    }
    sound_ = std::isfinite(face_.back().hat[0]) && face_.back().area2 > 0;
  }
  if (sound_) find_reach();
  if (sound_) find_folds();
  if (sound_) find_centroids();
  if (sound_) find_tiles();
}

Geometry Geometry::part(std::span<const int> faces, std::vector<int>& vertices) const {
  Geometry found;
  found.exponent_ = exponent_;
  found.centre_ = centre_;
  found.radius_ = radius_;
  std::map<int, int> vertex, edge;
  const auto vertex_of = [&](int v) {
    const auto [place, added] = vertex.try_emplace(v, static_cast<int>(vertices.size()));
    if (added) {
      vertices.push_back(v);
      found.vertex_.insert(found.vertex_.end(), &vertex_[3 * v], &vertex_[3 * v] + 3);
      found.reach_.push_back(reach_[v]);
    }
    return place->second;
  };
  const auto edge_of = [&](int e) {
    const auto [place, added] = edge.try_emplace(e, found.edges());
    if (added) {
      const std::pair ends{vertex_of(ends_[e].first), vertex_of(ends_[e].second)};
      found.ends_.push_back(ends);
      found.edge_.push_back(edge_[e]);
      found.fine_edge_.push_back(fine_edge_[e]);
      found.edge_.back().from = found.fine_edge_.back().from = ends.first;
      found.edge_.back().to = found.fine_edge_.back().to = ends.second;
    }
    return place->second;
  };
  vertices.clear();
  for (const int f : faces) {
    FaceTable<double>& face = found.face_.emplace_back(face_[f]);
    FaceTable<TwoDoubles>& fine = found.fine_face_.emplace_back(fine_face_[f]);
    for (int k = 0; k < 3; ++k) {
      face.vertex[k] = fine.vertex[k] = vertex_of(corner_[f][k]);
      face.edge[k] = fine.edge[k] = edge_of(edge_of_[f][k]);
    }
    found.corner_.push_back({face.vertex[0], face.vertex[1], face.vertex[2]});
    found.edge_of_.push_back({face.edge[0], face.edge[1], face.edge[2]});
    found.folded_.push_back(folded_[f]);
  }
  found.find_centroids();
  found.find_tiles();
  return found;
}

// Faces that meet at an edge under less than a fifth of a radian, and those at the tips of spikes as narrow.
void Geometry::find_folds() {
  const double most = std::cos(0.2);
  using Vector = Eigen::Vector3d;
  std::vector<char> narrow(vertex_.size() / 3, 1);
  std::vector<Vector> across(edge_.size(), Vector::Zero()), along(narrow.size(), Vector::Zero());
  const auto folds = [&](int e, const double(&nu)[3]) { return across[e].dot(Vector(nu[0], nu[1], nu[2])) > most; };
  const auto for_sides = [&](auto visit) {
    for (const FaceTable<double>& face : face_)
      for (int e = 0; e < 3; ++e) visit(face, e);
  };
  std::vector<char> folded_edge(edge_.size(), 0);
  for_sides([&](const FaceTable<double>& face, int e) {
    const int edge = face.edge[e];
    if (folds(edge, face.nu[e])) folded_edge[edge] = 1;
    across[edge] = Vector(face.nu[e][0], face.nu[e][1], face.nu[e][2]);
  });
  for (const EdgeTable<double>& e : edge_) {
    const Vector u(e.u[0], e.u[1], e.u[2]);
    for (const auto& [v, away] : {std::pair<int, Vector>(e.from, u), std::pair<int, Vector>(e.to, -u)}) {
      if (along[v].isZero()) along[v] = away;
      else if (along[v].dot(away) < most) narrow[v] = 0;
    }
  }
  for (std::size_t e = 0; e < edge_.size(); ++e)
    if (folded_edge[e] != 0) narrow[edge_[e].from] = narrow[edge_[e].to] = 1;
  for (const FaceTable<double>& face : face_)
    folded_.push_back(std::ranges::any_of(face.vertex, [&](int v) { return narrow[v] != 0; }) ? 1 : 0);
}

// Within 2^-7 of the shortest edge at a vertex.
void Geometry::find_reach() {
  reach_.assign(vertex_.size() / 3, std::numeric_limits<double>::infinity());
  for (const EdgeTable<double>& e : edge_)
    for (const int v : {e.from, e.to}) reach_[v] = std::min(reach_[v], 0x1p-7 * e.length);
}

// Rounds up to eight, the length of the longest vectors.
void Geometry::find_centroids() {
  constexpr std::size_t lanes = 8;
  const std::size_t stride = (face_.size() + lanes - 1) / lanes * lanes;
  centroid_.resize(3 * stride);
  over_square_.resize(stride);
  for (std::size_t f = 0; f < stride; ++f) {
    const FaceTable<double>& face = face_[f < face_.size() ? f : 0];
    const auto corner = [&](int k) { return Eigen::Map<const Eigen::Vector3d>(vertex_.data() + 3 * face.vertex[k]); };
    const Eigen::Vector3d e1 = corner(1) - corner(0), e2 = corner(2) - corner(0), middle = (e1 + e2) / 3;
    const double square = std::max({middle.squaredNorm(), (e1 - middle).squaredNorm(), (e2 - middle).squaredNorm()});
    for (std::size_t i = 0; i < 3; ++i) centroid_[i * stride + f] = corner(0)[i] + middle[i];
    over_square_[f] = 1 / square;
  }
}

void Geometry::find_tiles() {
  std::vector<Vec3<double>> centroids;
  const std::size_t stride = over_square_.size();
  for (std::size_t f = 0; f < face_.size(); ++f)
    centroids.emplace_back(centroid_[f], centroid_[stride + f], centroid_[2 * stride + f]);
  tiling_ = Tiling(face_, edge_, along_a_curve(centroids));
}

LongFace Geometry::long_face(int f) const {
  LongFace found;
  FaceTable<Mp200>& face = found.face;
  std::array<LongVector, 3> corner, along, outward;
  std::array<Mp200, 3> length;
  for (int k = 0; k < 3; ++k) {
    face.vertex[k] = corner_[f][k];
    face.edge[k] = edge_of_[f][k];
    for (int i = 0; i < 3; ++i) corner[k][i] = vertex_[3 * face.vertex[k] + i];
  }
  for (int e = 0; e < 3; ++e) {
    for (int i = 0; i < 3; ++i) along[e][i] = corner[(e + 1) % 3][i] - corner[e][i];
    length[e] = sqrt(product(along[e], along[e]));
  }
  const LongVector normal = cross_of(along[0], along[1]);
  face.area2 = sqrt(product(normal, normal));
  const LongVector n = times(normal, Mp200(1) / face.area2);
  put(face.n, n);
  for (int e = 0; e < 3; ++e) {
    const Mp200 over = Mp200(1) / length[e];
    const LongVector u = times(along[e], over);
    outward[e] = cross_of(u, n);
    put(face.nu[e], outward[e]);
    put(face.u[e], u);
    for (int i = 0; i < 3; ++i)
      face.middle[e][i] = (corner[e][i] - corner[0][i] + (corner[(e + 1) % 3][i] - corner[0][i])) / 2;
    const bool forward = ends_[face.edge[e]].first == face.vertex[e];
    face.along[e] = forward ? 1 : -1;
    face.length[e] = length[e];
    EdgeTable<Mp200>& edge = found.edge[e];
    edge.from = ends_[face.edge[e]].first;
    edge.to = ends_[face.edge[e]].second;
    put(edge.u, times(u, Mp200(face.along[e])));
    edge.length = length[e];
    edge.over = over;
  }
  face.steep = 0;
  for (int k = 0; k < 2; ++k) {
    const int opposite = k + 1;
    face.hat[k] = length[opposite] / face.area2;
    const LongVector g = times(outward[opposite], -face.hat[k]);
    put(face.g[k], g);
    for (int e = 0; e < 3; ++e) {
      face.across[k][e] = product(g, outward[e]);
      face.steep = std::max(face.steep, std::abs(static_cast<double>(face.across[k][e])));
    }
  }
  face.steep_around = face.steep * static_cast<double>(length[0] + length[1] + length[2]) / 3;
  return found;
}

CageTables Geometry::tables() const {
  return {vertices(),
          edges(),
          faces(),
          vertex_.data(),
          reach_.data(),
          edge_.data(),
          face_.data(),
          fine_edge_.data(),
          fine_face_.data(),
          2 * radius_,
          folded_.data(),
          centroid_.data(),
          over_square_.data(),
          static_cast<int>(over_square_.size()),
          far_rules(),
          line_rule(),
          tiling_.tables()};
}

}  // namespace cageproof::closed_form::batch
