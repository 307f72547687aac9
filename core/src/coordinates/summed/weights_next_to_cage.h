// SPDX-License-Identifier: MIT
// Weights of normalised kinds next to the cage, in as many digits as their quotient takes.
#pragma once

#include "moved_off.h"
#include "next_to_cage.h"
#include "summands.h"
#include "term_sizes.h"

#include "cageproof/core/coordinates/coordinate_tables.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <memory>

namespace cageproof {

class WeightsNextToCage {
 public:
  // Returns null where the evaluations show what they lose, or take their time. \param sum outlives the result
  static std::unique_ptr<const WeightsNextToCage> make(const Summands& sum);

  NextToCage::Found at(const Vec3<double>& point, int order) const { return next_to_.at(point, order); }

  // Puts the orders that `tables` lack, which hold sums in R: elements that the point is next to are computed in as
  // many digits as that takes, and the quotient is. \param next_to at the point, whose order is at most `order`
  template <Scalar R>
  void put(const Vec3<double>& seen, const NextToCage::Found& next_to, std::size_t p, int order,
           std::span<CoordinateTable<R>> tables) const {
    unsigned left = 0;  // orders that are to be put, a bit each
    for (int o = 0; o <= order; ++o)
      if (o == 0 || o >= next_to.order || !is_finite(p, o, tables)) left |= 1u << o;
    const auto put = [&](int o, std::span<const double> numbers) {
      std::ranges::transform(numbers, row_of(tables[0], p, o).begin(), [](double x) { return static_cast<R>(x); });
    };
    left &= ~put_in_digits<Mp50>(seen, {convert<Mp50>(seen)}, next_to.elements, order, left, put);
    if (left != 0) left &= ~put_in_digits<Mp100>(seen, {convert<Mp100>(seen)}, next_to.elements, order, left, put);
    if (left != 0) left &= ~put_in_digits<Mp200>(seen, {convert<Mp200>(seen)}, next_to.elements, order, left, put);
    if (left != 0 && !sum_.has_quads()) {
      const MovedOff moved = moved_off(corners_of_some(next_to.elements), convert<Mp200>(seen));
      left &= ~put_in_digits<Mp200>(seen, {moved.point, moved.further}, next_to.elements, order, left, put);
    }
    // Nobody knows the rest.
    for (int o = 1; o <= order; ++o)
      if ((left >> o & 1u) != 0) std::ranges::fill(row_of(tables[0], p, o), std::numeric_limits<R>::quiet_NaN());
  }

 private:
  explicit WeightsNextToCage(const Summands& sum) : sum_(sum), next_to_(*sum.elements, sum.size_exponent) {}

  bool find_evaluations();

  std::vector<std::vector<Vec3<Mp200>>> corners_of_some(const std::vector<char>& which) const {
    std::vector<std::vector<Vec3<Mp200>>> found;
    std::array<Vec3<Mp200>, 4> storage;
    for (std::size_t e = 0; e < which.size(); ++e) {
      if (which[e] == 0) continue;
      const auto corners = sum_.corners_of(e, storage);
      found.emplace_back(corners.begin(), corners.end());
    }
    return found;
  }

  // Where elements that a point is next to see it, and how many times the Hessians there those of the point are.
  template <Scalar W>
  struct SeenAt {
    Vec3<W> point;
    W further = 1;
  };

  // Calls put(order, numbers) of coordinates whose weights of some elements are computed in W, of others in double.
  // \param asked orders, a bit each \return those of them that these digits are enough for, which are put
  template <Scalar W, class Put>
  unsigned put_in_digits(const Vec3<double>& point, const SeenAt<W>& at, const std::vector<char>& beside, int order,
                         unsigned asked, const Put& put) const {
    const int exponent = std::abs(sum_.size_exponent) <= Summands::kComfortable<double> ? 0 : -sum_.size_exponent;
    auto wide = zero_tables<W>(sum_.blocks, sum_.elements->dimension(), 1, order);
    TermSizes sizes(wide);
    const std::vector<W> parameters(sum_.parameters.begin(), sum_.parameters.end());
    const auto in_double = sum_.parts_in_range(point, order, exponent);
    std::array<Vec3<W>, 4> storage;
    Result<double> rounded;
    Result<W> part;
    for (std::size_t e = 0; e < sum_.elements->count(); ++e) {
      if (beside[e] != 0) {
        more_digits_[static_cast<std::size_t>(sum_.elements->type(e).kind)](
            Query<W>{sum_.corners_of(e, storage, exponent), in_unit(at.point, exponent), order, parameters}, part);
      } else {
        in_double(e, 0, false, rounded);
        for (int o = 0; o <= order; ++o) part.of(o).assign(rounded.of(o).begin(), rounded.of(o).end());
      }
      BatchOutput<W> here = sum_.output_for(0, 0, wide[0]);
      here.slots = sum_.elements->shares_of(e, sum_.blocks[0].owner);
      for (int o = 0; o <= order; ++o) here.put(0, o, part.of(o));
      sizes.add(0, order, part, here);
    }
    std::vector<W>& values = wide[0].tensors[0];
    const W sum = std::accumulate(values.begin(), values.end(), W(0));
    std::array<W*, 3> weights{};
    for (int o = 0; o <= order; ++o) weights[o] = wide[0].tensors[o].data();
    normalise(weights, values.size(), sum_.elements->dimension(), order);
    sizes.normalise(order, sum_.elements->dimension(), std::abs(static_cast<long double>(sum)),
                    leading(values.data(), values.size()));
    unsigned found = 0;
    for (int o = 0; o <= order; ++o) {
      const W times = o == 2 ? at.further : W(1);
      if ((asked >> o & 1u) == 0) continue;
      if (!sizes.leave_digits(wide[0], o,
                              std::ldexp(1.0L, -o * (sum_.size_exponent + exponent)) / static_cast<long double>(times)))
        continue;
      using std::ldexp;
      std::vector<double> numbers;
      for (const W& x : wide[0].tensors[o]) numbers.push_back(static_cast<double>(W(times * ldexp(x, o * exponent))));
      put(o, numbers);
      found |= 1u << o;
    }
    return found;
  }

  const Summands& sum_;
  NextToCage next_to_;
  std::array<Evaluation, element_kinds.size()> more_digits_;
};

}  // namespace cageproof
