// SPDX-License-Identifier: MIT
#include "summed.h"

#include "beyond_range.h"
#include "limits.h"
#include "on_cage.h"
#include "summands.h"
#include "weights_next_to_cage.h"

#include "cageproof/core/coordinates/coordinate_tables.h"

#include <algorithm>
#include <cmath>
#include <memory>

namespace cageproof {
namespace {

class SummedCoordinates final : public CoordinatesIn<SummedCoordinates>, public HasLimits, public HasTerms {
 public:
  SummedCoordinates(const CoordinateKind& kind, std::shared_ptr<const CageElements> elements,
                    const CoordinateOptions& options)
      : sum_(kind, std::move(elements), options) {
    if (sum_.normalised) next_to_ = WeightsNextToCage::make(sum_);
  }

  const std::vector<CoordinateBlock>& blocks() const override { return sum_.blocks; }
  int max_order() const override { return sum_.max_order; }
  std::string evaluation() const override {
    std::string name;
    for (const ElementEvaluations& of_kind : sum_.evaluations)
      if (!of_kind.empty()) name = of_kind.front().name();
    return name;
  }
  bool is_exact_in(ScalarKind scalar) const override {
    return std::ranges::all_of(sum_.evaluations, [&](const ElementEvaluations& of_kind) {
      return std::ranges::all_of(of_kind, [&](const Evaluation& e) { return e.supports(scalar); });
    });
  }

  template <Scalar R>
  void compute(std::span<const Vec3<R>> points, int order, std::span<CoordinateTable<R>> tables) const {
    std::vector<std::vector<Touching>> on(points.size());
    bool any_on = false;
    for (std::size_t p = 0; p < points.size(); ++p) {
      on[p] = touching(points[p]);
      any_on = any_on || !on[p].empty();
    }
    if (!any_on) return sum_off(points, 0, order, tables);
    for (std::size_t p = 0; p < points.size(); ++p) {
      if (on[p].empty()) sum_off<R>(points.subspan(p, 1), p, order, tables);
      else sum_on(sum_, points[p], p, order, on[p], tables);
    }
  }

  const HasLimits* limits() const override {
    const auto is_number = [](const CoordinateBlock& block) { return block.entries() == 1; };
    return sum_.normalised || !std::ranges::all_of(sum_.blocks, is_number) ? nullptr : this;
  }
  const HasTerms* terms() const override { return sum_.normalised ? nullptr : this; }
  void fill_limits(std::span<const Touching> places, int order,
                   std::span<CoordinateTable<double>> tables) const override {
    put_limits(sum_, places, order, tables);
  }
  void fill_limits(std::span<const Touching> places, int order,
                   std::span<CoordinateTable<Mp50>> tables) const override {
    put_limits(sum_, places, order, tables);
  }

  // There is one term per corner of each element. Numbers that are not finite, such as derivatives at points on the
  // cage, are left out.
  void fill_terms(std::span<const Vec3<double>> points, int order,
                  std::span<CoordinateTable<double>> tables) const override {
    std::array<Vec3<double>, 4> storage;
    Result<double> part;
    for (std::size_t e = 0; e < sum_.elements->count(); ++e) {
      for (std::size_t b = 0; b < sum_.blocks.size(); ++b)
        for (std::size_t p = 0; p < points.size(); ++p) {
          sum_.evaluations[static_cast<std::size_t>(sum_.elements->type(e).kind)][b](
              Query<double>{sum_.corners_of(e, storage), points[p], order, sum_.parameters}, part);
          BatchOutput<double> here = sum_.output_for(b, p, tables[b]);
          here.slots = sum_.elements->shares_of(e, sum_.blocks[b].owner);
          for (int o = 0; o <= order; ++o) {
            for (double& x : part.of(o)) x = std::isfinite(x) ? std::abs(x) : 0;
            here.put(0, o, part.of(o));
          }
        }
    }
    sum_.times_area_elements(points.size(), order, tables);
  }

 private:
  // Points that are no doubles are taken to lie off the cage: nobody can put them on it.
  template <Scalar R>
  std::vector<Touching> touching(const Vec3<R>& point) const {
    const Vec3<double> rounded = convert<double>(point);
    for (int c = 0; c < 3; ++c)
      if (R(rounded[c]) != point[c]) return {};
    return sum_.elements->touching(rounded);
  }

  // Points off the cage, which stand in the tables from point `first` on.
  template <Scalar R>
  void sum_off(std::span<const Vec3<R>> points, std::size_t first, int order,
               std::span<CoordinateTable<R>> tables) const {
    sum_in_range(points, first, order, tables);
    if constexpr (!is_multiprecision<R>)
      for (std::size_t p = 0; p < points.size(); ++p) {
        if (!points[p].allFinite() || sum_next_to_cage(points[p], first + p, order, tables)) continue;
        if (!is_finite(first + p, order, tables)) sum_beyond_range(sum_, points[p], first + p, order, tables);
      }
  }

  // Next to the cage the quotient of weights loses digits of derivatives. \return whether the point lies there, and its
  // derivatives were put again
  template <Scalar R>
  bool sum_next_to_cage(const Vec3<R>& point, std::size_t p, int order, std::span<CoordinateTable<R>> tables) const {
    if (!next_to_ || order == 0) return false;
    const Vec3<double> seen = convert<double>(point);
    const NextToCage::Found next_to = next_to_->at(seen, order);
    if (next_to.order > order) return false;
    if constexpr (std::same_as<R, float>) {
      // Double has the digits, or takes more.
      auto in_double = zero_tables<double>(sum_.blocks, sum_.elements->dimension(), 1, order);
      sum_off<double>(std::span(&seen, 1), 0, order, in_double);
      put_rounded<R>(in_double, p, order, tables);
    } else {
      next_to_->put<R>(seen, next_to, p, order, tables);
    }
    return true;
  }

  template <Scalar R>
  void sum_in_range(std::span<const Vec3<R>> points, std::size_t first, int order,
                    std::span<CoordinateTable<R>> tables) const {
    if (is_multiprecision<R> && !sum_.has_area_elements) return sum_in_unit(points, first, order, tables, 0);
    const bool comfortable = std::abs(sum_.size_exponent) <= Summands::kComfortable<R>;
    // Without its area element a quad's layer leaves the range that with it it does not.
    const bool in_own_unit = sum_.normalised ? !comfortable : sum_.has_area_elements;
    sum_in_unit(points, first, order, tables, in_own_unit ? -sum_.size_exponent : 0);
    if (sum_.has_area_elements) {
      for (std::size_t p = 0; p < points.size(); ++p) sum_.to_own_unit(first + p, order, tables, -sum_.size_exponent);
      return;
    }
    // Weights grow like 1/distance, and may leave double's range where coordinates, which have no unit, do not. Other
    // elements' parts have infinities of both signs in cages whose own unit is tiny.
    if (!sum_.normalised && (comfortable || sum_.size_exponent > 0 || !sum_.homogeneous)) return;
    for (std::size_t p = 0; p < points.size(); ++p)
      if (!is_finite(first + p, sum_.normalised ? 0 : order, tables)) {
        clear(first + p, order, tables);
        const int exponent = (sum_.normalised ? kSmallUnit<R> : 0) - sum_.size_exponent;
        sum_in_unit<R>(points.subspan(p, 1), first + p, order, tables, exponent);
        if (!sum_.normalised) sum_.to_own_unit(first + p, order, tables, exponent);
      }
  }

  template <Scalar R>
  void sum_in_unit(std::span<const Vec3<R>> given, std::size_t first, int order, std::span<CoordinateTable<R>> tables,
                   int exponent) const {
    std::vector<Vec3<R>> moved;
    for (std::size_t p = 0; exponent != 0 && p < given.size(); ++p) moved.push_back(in_unit(given[p], exponent));
    const std::span<const Vec3<R>> points = exponent == 0 ? given : moved;
    const std::vector<R> parameters(sum_.parameters.begin(), sum_.parameters.end());
    std::vector<BatchOutput<R>> outputs;
    for (std::size_t b = 0; b < sum_.blocks.size(); ++b) outputs.push_back(sum_.output_for(b, first, tables[b]));
    std::vector<const Evaluation*> members(sum_.blocks.size());
    std::array<Vec3<R>, 4> storage;
    for (std::size_t e = 0; e < sum_.elements->count(); ++e) {
      const ElementEvaluations& evaluations = sum_.evaluations[static_cast<std::size_t>(sum_.elements->type(e).kind)];
      for (std::size_t b = 0; b < sum_.blocks.size(); ++b) {
        members[b] = &evaluations[b];
        outputs[b].slots = sum_.elements->shares_of(e, sum_.blocks[b].owner);
      }
      Evaluation::together<R>(members, Batch<R>{sum_.corners_of(e, storage, exponent), points, order, parameters},
                              outputs);
    }
    for (std::size_t p = 0; p < points.size(); ++p) sum_.finish_sums(first + p, order, tables, exponent);
  }

  // The exponent of the size to which cages are scaled where weights would overflow: second derivatives at the least
  // distance then do not.
  template <Scalar R>
  static constexpr int kSmallUnit = std::same_as<R, float> ? 100 : 800;

  Summands sum_;
  std::unique_ptr<const WeightsNextToCage> next_to_;  // of normalised kinds that have more digits there
};

}  // namespace

std::shared_ptr<const PreparedCoordinates> prepare_sum(const CoordinateKind& kind,
                                                       std::shared_ptr<const CageElements> elements,
                                                       const CoordinateOptions& options) {
  return std::make_shared<SummedCoordinates>(kind, std::move(elements), options);
}

}  // namespace cageproof
