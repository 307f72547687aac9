// SPDX-License-Identifier: MIT
// Registers the baseline: `tessellated-<n>`, quad mean value weights from triangles in the quad's place ([T18] Section
// 2.3).
#include "../bilinear_basis.h"
#include "../counted_family.h"

#include <limits>
#include <vector>

namespace cageproof::adaptive_qmvc {
namespace {

template <Scalar R>
Vec3<R> surface_point(std::span<const Vec3<R>> q, const Basis<R>& basis) {
  return basis[0] * q[0] + basis[1] * q[1] + basis[2] * q[2] + basis[3] * q[3];
}

/// Sums over triangles, one entry per point, in memory that is kept from one batch to the next.
template <Scalar R>
struct TessellationSums {
  std::vector<R> weights;  ///< of one triangle's corners
  std::vector<Basis<R>> finite, diverging;
  std::vector<char> diverges;

  explicit TessellationSums(std::size_t points = 0) { reset(points); }
  void reset(std::size_t points) {
    weights.resize(3 * points);
    finite.assign(points, Basis<R>{R(0), R(0), R(0), R(0)});
    diverging = finite;
    diverges.assign(points, 0);
  }
};

/// The weights of n x n sub-quads, each cut from its corner 0 to its corner 2, with basis functions linear on each
/// triangle. On a triangle they diverge: infinite for the corners whose interpolated basis function is positive there,
/// zero for the others.
struct Tessellated {
  template <Scalar R>
  void operator()(const Batch<R>& batch, int n, const BatchOutput<R>& output) const {
    thread_local TessellationSums<R> sums;
    sums.reset(batch.points.size());
    for (int i = 0; i < n; ++i)
      for (int j = 0; j < n; ++j) {
        const auto basis = [&](int a, int b) { return bilinear_basis<R>(R(i + a) / R(n), R(j + b) / R(n)); };
        add_triangle(batch, {basis(0, 0), basis(1, 0), basis(1, 1)}, sums);
        add_triangle(batch, {basis(0, 0), basis(1, 1), basis(0, 1)}, sums);
      }
    for (std::size_t p = 0; p < batch.points.size(); ++p) {
      Basis<R>& sum = sums.finite[p];
      if (sums.diverges[p])
        for (int k = 0; k < 4; ++k) sum[k] = sums.diverging[p][k] > 0 ? std::numeric_limits<R>::infinity() : R(0);
      output.put(p, 0, sum);
      output.state(p, {.nodes = 2 * static_cast<std::size_t>(n) * n});
    }
  }

 private:
  /// Adds one triangle's weights at all points.
  /// \param basis the quad's basis functions at the triangle's corners
  template <Scalar R>
  static void add_triangle(const Batch<R>& batch, const std::array<Basis<R>, 3>& basis, TessellationSums<R>& sums) {
    // Looked up when first asked for: evaluations register themselves in any order.
    static const Evaluation triangle =
        *EvaluationRegister::instance().with_role("triangle.mean_value", Role::Recommended);
    const Triangle<R> t{surface_point(batch.corners, basis[0]), surface_point(batch.corners, basis[1]),
                        surface_point(batch.corners, basis[2])};
    triangle(Batch<R>{t, batch.points}, BatchOutput<R>{.tensors = {sums.weights.data()}, .stride = {3}});
    for (std::size_t p = 0; p < batch.points.size(); ++p)
      for (int c = 0; c < 3; ++c) {
        const R& w = sums.weights[3 * p + c];
        const bool infinite = w == std::numeric_limits<R>::infinity();
        Basis<R>& sum = infinite ? sums.diverging[p] : sums.finite[p];
        for (int k = 0; k < 4; ++k) sum[k] += basis[c][k] * (infinite ? R(1) : w);
        sums.diverges[p] |= infinite;
      }
  }
};

const RegisterEvaluation register_tessellated{
    counted_family("quad.mean_value", "tessellated", {"tessellated-5"}, {"tessellated-5", "tessellated-40"},
                   "2 n^2 triangles in the quad's place, closed form of each", Tessellated{})};

}  // namespace
}  // namespace cageproof::adaptive_qmvc
