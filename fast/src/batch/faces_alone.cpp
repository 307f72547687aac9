// SPDX-License-Identifier: MIT
#include "faces_alone.h"

#include "cageproof/core/catalogue/evaluation.h"
#include "cageproof/core/numbers/mp.h"

#include <array>
#include <span>
#include <vector>

namespace cageproof::closed_form::batch {
namespace {

constexpr std::array<int, 3> kKeptEntries{1, 3, 6};
// Where the kept entries of a Hessian are among all nine.
constexpr std::array<int, 6> kUpperEntries{0, 1, 2, 4, 5, 8};

// Weights of one face, which is asked in numbers of more digits than double has, or in double.
template <class Number>
class FaceAlone {
 public:
  FaceAlone(const Block& block, int lanes, const Evaluation& evaluation)
      : block_(block), lanes_(lanes), evaluation_(evaluation) {}

  // Calls add(column, number) for all of a face's numbers at a point of the block.
  template <class Add>
  void at(int f, int p, Add add) {
    const FaceTable<double>& face = block_.cage->face[f];
    std::array<Vec3<Number>, 3> corners;
    for (int k = 0; k < 3; ++k)
      for (int i = 0; i < 3; ++i) corners[k][i] = block_.cage->vertex[3 * face.vertex[k] + i];
    const double* const point = block_.points + p;
    evaluation_(Query<Number>{.corners = corners,
                              .point = Vec3<Number>(point[0], point[lanes_], point[2 * lanes_]),
                              .order = block_.order},
                weights_);
    for (int o = 0; o <= block_.order; ++o)
      for (int k = 0; k < 3; ++k)
        for (int i = 0; i < kKeptEntries[o]; ++i)
          add(block_.layout.first[o][0] + face.vertex[k] * kKeptEntries[o] + i,
              Number(2 * weights_.of(o)[o == 2 ? 9 * k + kUpperEntries[i] : kKeptEntries[o] * k + i]));
  }

 private:
  const Block& block_;
  int lanes_;
  const Evaluation& evaluation_;
  Result<Number> weights_;
};

bool is_of(unsigned points, int p) { return (points >> p & 1u) != 0; }

}  // namespace

void add_faces_alone(const Block& block, int lanes, int count) {
  static const Evaluation accurate = evaluation_named("triangle.mean_value", "accurate");
  static const Evaluation closed_form = evaluation_named("triangle.mean_value", "closed_form");
  FaceAlone<double> in_double(block, lanes, accurate);
  for (const Mark& mark : std::span(block.marks, block.marked))
    for (int p = 0; p < count; ++p)
      if (is_of(mark.points & ~block.left, p))
        in_double.at(mark.face, p, [&](int column, double x) { block.columns[column * lanes + p] += x; });
  if (block.beyond_marked == 0) return;
  FaceAlone<Mp50> in_more(block, lanes, closed_form);
  std::vector<Mp50> sums(block.layout.count);
  for (int p = 0; p < count; ++p) {
    std::ranges::fill(sums, Mp50(0));
    bool any = false;
    for (const Mark& mark : std::span(block.beyond, block.beyond_marked)) {
      if (!is_of(mark.points & ~block.left, p)) continue;
      any = true;
      in_more.at(mark.face, p, [&](int column, const Mp50& x) { sums[column] += x; });
    }
    for (std::size_t c = 0; any && c < sums.size(); ++c) block.columns[c * lanes + p] += static_cast<double>(sums[c]);
  }
}

}  // namespace cageproof::closed_form::batch
