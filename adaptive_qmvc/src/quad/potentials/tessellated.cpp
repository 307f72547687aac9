// SPDX-License-Identifier: MIT
// Registers what a cage cut in triangles has in a quad's place: `tessellated-<n>`, potentials of 2 n^2 triangles.
#include "../bilinear_basis.h"
#include "../counted_family.h"

#include <cmath>
#include <vector>

namespace cageproof::adaptive_qmvc {
namespace {

/// The potential of n x n cells, each cut from its corner 0 to its corner 2, with basis functions linear on each
/// triangle.
struct TessellatedPotential {
  std::string triangle_formula;
  bool by_parameters;  ///< of the measure du dv, which is a constant times a triangle's area

  template <Scalar R>
  void operator()(const Batch<R>& batch, int n, const BatchOutput<R>& output) const {
    const Evaluation triangle = *EvaluationRegister::instance().with_role(triangle_formula, Role::Recommended);
    const int entries = triangle.formula().shape.entries();
    std::array<std::vector<R>, 3> sums;
    Result<R> part;
    for (std::size_t p = 0; p < batch.points.size(); ++p) {
      for (int o = 0; o <= batch.order; ++o) sums[o].assign(4 * entries * derivative_count(3, o), R(0));
      for (int i = 0; i < n; ++i)
        for (int j = 0; j < n; ++j) {
          const auto basis = [&](int a, int b) { return bilinear_basis<R>(R(i + a) / R(n), R(j + b) / R(n)); };
          for (const std::array<Basis<R>, 3>& of :
               {std::array{basis(0, 0), basis(1, 0), basis(1, 1)}, std::array{basis(0, 0), basis(1, 1), basis(0, 1)}})
            add_triangle(triangle, batch, batch.points[p], of, n, part, sums);
        }
      for (int o = 0; o <= batch.order; ++o) output.put(p, o, sums[o]);
      output.state(p, {.nodes = 2 * static_cast<std::size_t>(n) * n});
    }
  }

 private:
  template <Scalar R>
  void add_triangle(const Evaluation& triangle, const Batch<R>& batch, const Vec3<R>& point,
                    const std::array<Basis<R>, 3>& basis, int n, Result<R>& part,
                    std::array<std::vector<R>, 3>& sums) const {
    using std::sqrt;
    std::array<Vec3<R>, 3> t;
    for (int c = 0; c < 3; ++c) {
      t[c].setZero();
      for (int k = 0; k < 4; ++k) t[c] += basis[c][k] * batch.corners[k];
    }
    R share = 1;
    if (by_parameters) {
      const Vec3<R> area = (t[1] - t[0]).cross(t[2] - t[0]);
      const R largest = area.cwiseAbs().maxCoeff();
      // A triangle without area has none of the parameters' integral that this can tell.
      if (!(largest > R(0))) return;
      const Vec3<R> of_unit_size = area / largest;
      share = 1 / (R(n) * R(n) * largest * sqrt(R(of_unit_size.dot(of_unit_size))));
    }
    triangle(Query<R>{.corners = t, .point = point, .order = batch.order, .parameters = batch.parameters}, part);
    for (int o = 0; o <= batch.order; ++o) {
      const std::size_t size = sums[o].size() / 4;
      for (int c = 0; c < 3; ++c)
        for (int k = 0; k < 4; ++k)
          for (std::size_t e = 0; e < size; ++e)
            sums[o][k * size + e] += share * basis[c][k] * part.of(o)[c * size + e];
    }
  }
};

EvaluationFamily tessellated_family(const std::string& kernel, const std::string& triangle_kernel, bool by_parameters) {
  return counted_family("quad." + kernel, "tessellated", {"tessellated-5"}, {"tessellated-5", "tessellated-20"},
                        "2 n^2 triangles in the quad's place, closed form of each",
                        TessellatedPotential{"triangle." + triangle_kernel, by_parameters}, 2);
}

const RegisterEvaluation tessellated_single_layer{tessellated_family("single_layer", "affine_single_layer", true)},
    tessellated_double_layer{tessellated_family("double_layer", "double_layer", false)},
    tessellated_biharmonic_double_layer{
        tessellated_family("biharmonic_double_layer", "biharmonic_double_layer", false)},
    tessellated_kelvin_traction{tessellated_family("kelvin_traction", "kelvin_traction", false)};

}  // namespace
}  // namespace cageproof::adaptive_qmvc
