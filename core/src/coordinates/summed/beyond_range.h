// SPDX-License-Identifier: MIT
// Sums whose terms leave the scalar's range, where the sums need not.
#pragma once

#include "summands.h"
#include "term_sizes.h"

#include "cageproof/core/coordinates/coordinate_tables.h"

#include <cstdlib>
#include <numeric>

namespace cageproof {

// As Summands::parts_in_range(), with integrals that leave R's range computed in Summands::Wide.
// \param sizes of the terms in `tables`
template <Scalar R>
auto parts_beyond_range(const Summands& sum, const Vec3<R>& point, int order, int exponent,
                        std::vector<CoordinateTable<Summands::Wide>>& tables, TermSizes& sizes) {
  return [&sum, order, &tables, &sizes, in_range = sum.parts_in_range(point, order, exponent),
          beyond = sum.parts_in_range(convert<Summands::Wide>(point), order, exponent)](
             std::size_t e, std::size_t b, bool finite_part, Result<Summands::Wide>& part) {
    Result<R> rounded;
    in_range(e, b, finite_part, rounded);
    bool finite = true;
    for (int o = 0; o <= order; ++o) finite = finite && are_finite<R>(rounded.of(o));
    if (!finite) beyond(e, b, finite_part, part);
    for (int o = 0; finite && o <= order; ++o) part.of(o).assign(rounded.of(o).begin(), rounded.of(o).end());
    BatchOutput<Summands::Wide> here = sum.output_for(b, 0, tables[b]);
    here.slots = sum.elements->shares_of(e, sum.blocks[b].owner);
    sizes.add(b, order, part, here);
  };
}

// Next to an edge or a vertex derivatives of elements' integrals leave R's range, where those of the coordinates need
// not: the elements' infinities have opposite signs. Their terms are summed in Summands::Wide's range and digits. Rows
// stay as they are where an evaluation does not have these.
template <Scalar R>
void sum_beyond_range(const Summands& sum, const Vec3<R>& point, std::size_t p, int order,
                      std::span<CoordinateTable<R>> tables) {
  if (!sum.goes_beyond_range()) return;
  const int exponent = sum.has_area_elements ? -sum.size_exponent : 0;
  auto wide = zero_tables<Summands::Wide>(sum.blocks, sum.elements->dimension(), 1, order);
  TermSizes sizes(wide);
  const auto part_of = parts_beyond_range(sum, point, order, exponent, wide, sizes);
  Result<Summands::Wide> part;
  for (std::size_t e = 0; e < sum.elements->count(); ++e)
    for (std::size_t b = 0; b < sum.blocks.size(); ++b) {
      part_of(e, b, false, part);
      BatchOutput<Summands::Wide> here = sum.output_for(b, 0, wide[b]);
      here.slots = sum.elements->shares_of(e, sum.blocks[b].owner);
      for (int o = 0; o <= order; ++o) here.put(0, o, part.of(o));
    }
  if (sum.normalised) {
    const auto whole = static_cast<long double>(
        std::accumulate(wide[0].tensors[0].begin(), wide[0].tensors[0].end(), Summands::Wide(0)));
    sum.template finish_sums<Summands::Wide>(0, order, wide, exponent);
    sizes.normalise(order, sum.elements->dimension(), std::abs(whole),
                    leading(wide[0].tensors[0].data(), wide[0].tensors[0].size()));
    sizes.drop_roundings(wide);
  } else {
    sizes.drop_roundings(wide);
    sum.template finish_sums<Summands::Wide>(0, order, wide, exponent);
  }
  if (sum.has_area_elements) sum.template to_own_unit<Summands::Wide>(0, order, wide, exponent);
  put_rounded<R>(wide, p, order, tables);
}

}  // namespace cageproof
