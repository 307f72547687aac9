// SPDX-License-Identifier: MIT
// Sums at points on the cage.
#pragma once

#include "beyond_range.h"

#include <algorithm>
#include <limits>

namespace cageproof {

// One block; what the table holds of the point is added to. \param part_of as Summands::parts_in_range()
template <Scalar R, class PartOf>
void sum_on(const Summands& sum, std::size_t b, const PartOf& part_of, std::size_t p, int order,
            const std::vector<Touching>& on, CoordinateTable<R>& table) {
  const BatchOutput<R> output = sum.output_for(b, p, table);
  const std::size_t width = output.entries;
  // Adds the matrix (or number) times each basis function at the point to its vertex.
  const auto add_basis = [&](const std::vector<R>& matrix) {
    const auto owners = sum.elements->shares_of(on.front().element, sum.blocks[b].owner);
    for (std::size_t c = 0; c < owners.size(); ++c)
      for (std::size_t i = 0; i < width; ++i)
        output.tensors[0][owners[c] * width + i] += static_cast<R>(on.front().basis[c]) * matrix[i];
  };
  if (sum.normalised) {
    add_basis({R(1)});
    for (int o = 1; o <= order; ++o)
      std::fill_n(output.tensors[o], table.stride[o], std::numeric_limits<R>::quiet_NaN());
    return;
  }
  const bool jumps = sum.jumps[b] != 0;
  std::vector<R> whole(width, R(0));  // what the elements that the point is not on leave of the whole
  for (std::size_t i = 0; i < width; i += sum.blocks[b].shape.columns + 1) whole[i] = R(sum.jumps[b]);
  Result<R> part;
  for (std::size_t e = 0; e < sum.elements->count(); ++e) {
    const auto owners = sum.elements->shares_of(e, sum.blocks[b].owner);
    const auto touch = std::ranges::find(on, static_cast<int>(e), &Touching::element);
    const bool touches = jumps && touch != on.end();
    part_of(e, b, touches, part);
    BatchOutput<R> here = output;
    here.slots = owners;
    for (int o = 0; o <= order; ++o) here.put(0, o, part.of(o));
    if (!jumps) continue;
    // On the cage: the sum over all elements of int (basis - basis at the point) kernel, whose integrals exist, and
    // basis at the point.
    for (std::size_t i = 0; i < width; ++i) {
      R all = 0;
      for (std::size_t k = 0; k < owners.size(); ++k) all += part.value[k * width + i];
      if (!touches) whole[i] -= all;
      else
        for (std::size_t c = 0; c < owners.size(); ++c)
          output.tensors[0][owners[c] * width + i] -= static_cast<R>(touch->basis[c]) * all;
    }
  }
  if (jumps) add_basis(whole);
}

// A point on the cage, which stands in the tables as point `p`. Derivatives have no limit on elements' borders, and
// none of normalised kinds anywhere on the cage.
template <Scalar R>
void sum_on(const Summands& sum, const Vec3<R>& point, std::size_t p, int order, const std::vector<Touching>& on,
            std::span<CoordinateTable<R>> tables) {
  const auto part_of = sum.parts_in_range(point, order, 0);
  for (std::size_t b = 0; b < sum.blocks.size(); ++b) sum_on(sum, b, part_of, p, order, on, tables[b]);
  if (sum.has_area_elements) sum.times_area_elements_at(p, order, 0, tables);
  if constexpr (!is_multiprecision<R>) {
    if (sum.normalised || on.size() > 1 || is_finite(p, order, tables) || !sum.goes_beyond_range()) return;
    auto wide = zero_tables<Summands::Wide>(sum.blocks, sum.elements->dimension(), 1, order);
    TermSizes sizes(wide);
    const auto wide_part_of = parts_beyond_range(sum, point, order, 0, wide, sizes);
    for (std::size_t b = 0; b < sum.blocks.size(); ++b) sum_on(sum, b, wide_part_of, 0, order, on, wide[b]);
    sizes.drop_roundings(wide);
    if (sum.has_area_elements) sum.template times_area_elements_at<Summands::Wide>(0, order, 0, wide);
    put_rounded<R>(wide, p, order, tables);
  }
}

}  // namespace cageproof
