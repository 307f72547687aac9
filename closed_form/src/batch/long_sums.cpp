// SPDX-License-Identifier: MIT
#include "long_sums.h"

#include <cmath>

namespace cageproof::closed_form::batch {

// What the terms of edges and faces take of their numbers.
inline bool less(const Mp200& a, const Mp200& b) { return a < b; }
inline Mp200 magnitude(const Mp200& a) { return a < Mp200(0) ? Mp200(-a) : a; }
inline Mp200 root(const Mp200& a) { return sqrt(a); }
inline Mp200 select(bool which, const Mp200& a, const Mp200& b) { return which ? a : b; }
inline Mp200 log_of_quotient(const Mp200& num, const Mp200& den, const Mp200&, const Mp200&) { return log(num / den); }

}  // namespace cageproof::closed_form::batch

#include "face_terms.h"

namespace cageproof::closed_form::batch {
namespace {

// Distances below this, over the face's, leave too few of 200 digits where they enter squared.
const double kLeast = 1e-75;

template <Layers L, int O>
bool add_all(const Geometry& geometry, const std::vector<int>& faces, int on, const double* point, const Mp200& beta,
             const Sums<Mp200>& sums) {
  for (const int f : faces) {
    const LongFace table = geometry.long_face(f);
    std::array<Three<Mp200>, 3> x;
    std::array<Mp200, 3> r;
    const double* const vertex = geometry.tables().vertex;
    for (int k = 0; k < 3; ++k) {
      for (int i = 0; i < 3; ++i) x[k][i] = Mp200(vertex[3 * table.face.vertex[k] + i]) - point[i];
      r[k] = root(dot(x[k], x[k]));
    }
    std::array<EdgeTerms<Mp200>, 3> edge;
    for (int e = 0; e < 3; ++e) {
      const int a = table.face.along[e] > 0 ? e : (e + 1) % 3, b = table.face.along[e] > 0 ? (e + 1) % 3 : e;
      edge[e] = edge_terms<L, O, Mp200, Mp200>(table.edge[e], x[a], x[b], r[a], r[b]);
    }
    const Mp200 product = r[0] * r[1] * r[2];
    const Mp200 across = dot(table.face.n, x[0]) * table.face.area2;
    const Mp200 along = product + edge[0].between * r[2] + edge[1].between * r[0] + edge[2].between * r[1];
    const Mp200 high = magnitude(across), wide = magnitude(along);
    const bool beside = high > kLeast * product || wide > kLeast * product;
    const bool sided = f == on || along > Mp200(0) || high > kLeast * wide;
    const bool apart = r[0] > Mp200(kLeast) && r[1] > Mp200(kLeast) && r[2] > Mp200(kLeast);
    if (!beside || !sided || !apart) return false;
    const Mp200 omega = Mp200(2) * (f == on ? pi<Mp200>() : atan2(across, along));
    const Three<Mp200>* const corners[3] = {&x[0], &x[1], &x[2]};
    const EdgeTerms<Mp200>* const edges[3] = {&edge[0], &edge[1], &edge[2]};
    const FaceTerms<L, O, Mp200, Mp200> terms(table.face, corners, omega, edges);
    if constexpr (L == Layers::Kelvin) terms.add_kelvin(f, beta, sums);
    else terms.add(f, sums);
  }
  return true;
}

template <Layers L>
bool add_order(const Geometry& geometry, int order, const std::vector<int>& faces, int on, const double* point,
               const Mp200& beta, const Sums<Mp200>& sums) {
  switch (order) {
    case 0: return add_all<L, 0>(geometry, faces, on, point, beta, sums);
    case 1: return add_all<L, 1>(geometry, faces, on, point, beta, sums);
    default: return add_all<L, 2>(geometry, faces, on, point, beta, sums);
  }
}

}  // namespace

bool add_in_long(const Geometry& geometry, Layers layers, int order, const std::vector<int>& faces, int on,
                 const double* point, const Mp200& beta, const Columns& layout, double* columns, int stride) {
  std::vector<Mp200> sums(layout.count);
  const Sums<Mp200> to{sums.data(), &layout};
  const bool decided = layers == Layers::Kelvin ? add_all<Layers::Kelvin, 0>(geometry, faces, on, point, beta, to)
                       : layers == Layers::Harmonic
                           ? add_order<Layers::Harmonic>(geometry, order, faces, on, point, beta, to)
                           : add_order<Layers::Biharmonic>(geometry, order, faces, on, point, beta, to);
  if (!decided) return false;
  for (int c = 0; c < layout.count; ++c) columns[c * stride] += static_cast<double>(sums[c]);
  return true;
}

}  // namespace cageproof::closed_form::batch
