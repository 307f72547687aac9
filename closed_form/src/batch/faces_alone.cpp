// SPDX-License-Identifier: MIT
#include "faces_alone.h"

#include "cageproof/core/evaluation.h"

#include <array>

namespace cageproof::closed_form::batch {

void add_faces_alone(const Block& block, int lanes, int count) {
  static const Evaluation accurate = evaluation_named("triangle.mean_value", "accurate");
  constexpr std::array<int, 3> kept{1, 3, 6};
  // Where the kept entries of a Hessian are among all nine.
  constexpr std::array<int, 6> upper{0, 1, 2, 4, 5, 8};
  Result<double> weights;
  for (int m = 0; m < block.marked; ++m) {
    const Mark mark = block.marks[m];
    const FaceTable<double>& face = block.cage->face[mark.face];
    std::array<Vec3<double>, 3> corners;
    for (int k = 0; k < 3; ++k) corners[k] = Eigen::Map<const Vec3<double>>(block.cage->vertex + 3 * face.vertex[k]);
    for (int p = 0; p < count; ++p) {
      if ((mark.points >> p & 1u) == 0 || (block.left >> p & 1u) != 0) continue;
      const Vec3<double> point(block.points[p], block.points[lanes + p], block.points[2 * lanes + p]);
      accurate(Query<double>{.corners = corners, .point = point, .order = block.order}, weights);
      for (int o = 0; o <= block.order; ++o)
        for (int k = 0; k < 3; ++k)
          for (int i = 0; i < kept[o]; ++i) {
            const int column = block.layout.first[o][0] + face.vertex[k] * kept[o] + i;
            const std::size_t from = o == 2 ? 9 * k + upper[i] : kept[o] * k + i;
            block.columns[column * lanes + p] += 2 * weights.of(o)[from];
          }
    }
  }
}

}  // namespace cageproof::closed_form::batch
