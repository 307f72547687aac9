// SPDX-License-Identifier: MIT
#include "long_sums.h"

#include <algorithm>

namespace cageproof::closed_form::batch {

// Operations that the terms of edges and faces need of their number type.
inline bool less(const Mp200& a, const Mp200& b) { return a < b; }
inline Mp200 magnitude(const Mp200& a) { return a < Mp200(0) ? Mp200(-a) : a; }
inline Mp200 root(const Mp200& a) { return sqrt(a); }
inline Mp200 select(bool which, const Mp200& a, const Mp200& b) { return which ? a : b; }
inline Mp200 log_of_quotient(const Mp200& num, const Mp200& den, const Mp200&, const Mp200&) { return log(num / den); }

}  // namespace cageproof::closed_form::batch

#include "seen_face.h"

namespace cageproof::closed_form::batch {
namespace {

// Distances below this, over the face's, leave too few of 200 digits where they enter squared.
constexpr double kLeast = 1e-75;

template <Layers L, int O>
bool add_all(const Geometry& geometry, const std::vector<int>& faces, int on, const double* point, const Mp200& beta,
             const Sums<Mp200>& sums) {
  const double* const vertex = geometry.tables().vertex;
  for (const int f : faces) {
    const LongFace table = geometry.long_face(f);
    const SeenFace<L, O, Mp200, Mp200> seen(
        table.face, [&](int e) -> const auto& { return table.edge[e]; },
        [&](int k, int i) { return Mp200(vertex[3 * table.face.vertex[k] + i]) - point[i]; });
    const Mp200 high = magnitude(seen.across), wide = magnitude(seen.along);
    const bool beside = high > kLeast * seen.product || wide > kLeast * seen.product;
    const bool sided = f == on || seen.along > Mp200(0) || high > kLeast * wide;
    const bool apart = std::ranges::all_of(seen.r, [](const Mp200& r) { return r > Mp200(kLeast); });
    if (!beside || !sided || !apart) return false;
    const Mp200 omega = Mp200(2) * (f == on ? pi<Mp200>() : atan2(seen.across, seen.along));
    seen.add(table.face, f, omega, beta, sums);
  }
  return true;
}

}  // namespace

bool add_in_long(const Geometry& geometry, Layers layers, int order, const std::vector<int>& faces, int on,
                 const double* point, const Mp200& beta, const Columns& layout, double* columns, int stride) {
  std::vector<Mp200> sums(layout.count);
  const Sums<Mp200> to{sums.data(), &layout};
  const bool decided =
      with_layers(layers, order, [&]<Layers L, int O> { return add_all<L, O>(geometry, faces, on, point, beta, to); });
  if (!decided) return false;
  for (int c = 0; c < layout.count; ++c) columns[c * stride] += static_cast<double>(sums[c]);
  return true;
}

}  // namespace cageproof::closed_form::batch
