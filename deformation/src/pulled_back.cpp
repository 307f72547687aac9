// SPDX-License-Identifier: MIT
#include "block_maker.h"

#include "cageproof/core/input_error.h"
#include "cageproof/core/parallel.h"
#include "cageproof/core/reused.h"

#include <fmt/format.h>

namespace cageproof::deformation {
namespace {

void refuse_missing(const std::vector<char>& missing, std::span<const double> weights, std::size_t d) {
  for (std::size_t p = 0; p < missing.size(); ++p)
    if (missing[p] && std::ranges::any_of(weights.subspan(p * d, d), [](double w) { return w != 0; }))
      throw InputError(fmt::format(
          "point {} has no image, because it lies outside the cage or is NaN: its weights must be zero", p));
}

// Points without image weigh nothing, and NaN times nothing would be NaN.
void clear_missing(std::vector<CoordinateTable<double>>& tables, const BlockPart& part,
                   const std::vector<char>& missing) {
  for (std::size_t p = 0; p < part.count; ++p)
    if (missing[part.first + p])
      for (CoordinateTable<double>& table : tables)
        std::fill_n(table.tensors[0].begin() + static_cast<std::ptrdiff_t>(p * table.stride[0]), table.stride[0], 0.0);
}

// Blocks in a few groups, each summed in order and by itself, so that the sum does not depend on threads.
// \param tables(block, holder) a block's coordinates, which may be kept in the holder
template <class Tables>
std::vector<Vec3<double>> pulled(const PoseDerivative<double>& derivative, std::span<const double> weights,
                                 std::size_t d, std::size_t points, std::size_t length, int jobs,
                                 const Tables& tables) {
  constexpr std::size_t most = 32;
  const std::size_t blocks = (points + length - 1) / length, groups = std::min(blocks, most);
  std::vector<std::vector<Matrix<double>>> sums(groups);
  Reused<std::vector<CoordinateTable<double>>> reused;
  for_each_parallel(groups, jobs, [&](std::size_t group) {
    auto held = reused.taken();
    sums[group] = derivative.nothing();
    for (std::size_t block = group * blocks / groups; block < (group + 1) * blocks / groups; ++block) {
      const auto [first, count] = part_of(block, length, points);
      derivative.gather(tables(block, *held), count, weights.subspan(first * d, count * d), sums[group]);
    }
  });
  std::vector<Matrix<double>> all = derivative.nothing();
  for (const auto& sum : sums)
    for (std::size_t b = 0; b < all.size(); ++b) all[b] += sum[b];
  return derivative.back(all);
}

}  // namespace

std::vector<Vec3<double>> pulled_back(const CageCoordinates& coordinates, std::span<const Vec3<double>> points,
                                      const PoseDerivative<double>& derivative, std::span<const double> weights,
                                      const ImageRun& run, const std::optional<Inside>& region) {
  const BlockMaker maker(coordinates, points, run, region);
  const auto d = static_cast<std::size_t>(coordinates.dimension());
  std::vector<char> missing(points.size());
  std::vector<double> beyond(run.extend ? points.size() : 0);
  auto found = pulled(
      derivative, weights, d, points.size(), maker.length(),
      run.jobs, [&](std::size_t block, std::vector<CoordinateTable<double>> & held) -> const auto& {
        maker.make(block, held, missing, beyond);
        clear_missing(held, maker.part(block), missing);
        return held;
      });
  refuse_missing(missing, weights, d);
  return found;
}

std::vector<Vec3<double>> BoundPoints::pulled_back(const PoseDerivative<double>& derivative,
                                                   std::span<const double> weights, int jobs) const {
  const auto d = static_cast<std::size_t>(dimension_);
  refuse_missing(missing_, weights, d);
  return pulled(
      derivative, weights, d, size(), std::max<std::size_t>(block_, 1),
      jobs, [&](std::size_t block, std::vector<CoordinateTable<double>> & held) -> const auto& {
        const BlockPart part = part_of(block, block_, size());
        const auto rows = std::span(missing_).subspan(part.first, part.count);
        if (std::ranges::find(rows, 1) == rows.end()) return blocks_[block];
        held = blocks_[block];
        clear_missing(held, part, missing_);
        return held;
      });
}

}  // namespace cageproof::deformation
