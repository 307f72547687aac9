// SPDX-License-Identifier: MIT
// Integrals to as many digits as asked, at most kMostDigits: computed twice, by rules that must agree.
#pragma once

#include "beyond_range.h"
#include "finish.h"

#include <functional>
#include <tuple>

namespace cageproof::quadrature_ref {

/// Digits that the arithmetic of 50, 100 and 200 digits leaves after the rounding of a cell's sums and geometry.
inline constexpr double kDigitsIn50 = 46, kDigitsIn100 = 95, kDigitsIn200 = 190;
/// log10 of a mass or a norm that is zero. A mass is the largest of a few samples of the integrand times a cell's
/// extent.
inline constexpr double kNoMass = -std::numeric_limits<double>::infinity();
/// The most digits that a result is asked for: of 190, two rules that must agree, the second better, leave so many.
inline constexpr double kMostDigits = 160;
/// The fewest digits with which a multiprecision evaluation states that it converged.
inline constexpr double kDigitsPromised = 30;

/// An integral that is computed to as many digits as asked, as far as its design allows.
class ConvergingSum {
 public:
  virtual ~ConvergingSum() = default;
  /// The tensors to about `digits` digits each order (Hessians: entries i <= j), in the local unit of length.
  virtual Result<Mp200> at(double digits) = 0;
  /// log10 of each order's norm. \pre `at` was called
  const std::array<double, 3>& log10_norms() const { return log10_norms_; }
  /// Takes over the norms of a similar sum, so that they need not be found.
  void take_log10_norms(const std::array<double, 3>& norms) {
    log10_norms_ = norms;
    norms_are_known_ = true;
  }
  /// Kernel evaluations so far.
  std::size_t nodes() const { return nodes_; }
  /// Whether an order's tensor is not computed, because it would take too much work or cancels beyond 200 digits.
  bool declines(int order) const { return log10_norms_[order] == kDeclined; }

 protected:
  /// The sum with an absolute error of about 10^log10_error[order].
  using SumWithError = std::function<Result<Mp200>(const std::array<double, 3>& log10_error)>;

  ConvergingSum(const Integrand& integrand, const Query<Mp200>& query)
      : integrand_(integrand),
        order_(query.order),
        parameters_(convert_all<Mp50>(query.parameters), convert_all<Mp100>(query.parameters),
                    convert_all<Mp200>(query.parameters)) {}

  template <Scalar W>
  static std::vector<W> convert_all(std::span<const Mp200> values) {
    std::vector<W> converted;
    for (const Mp200& value : values) converted.push_back(static_cast<W>(value));
    return converted;
  }
  template <Scalar W>
  KernelTask<W> task() const {
    // Orders that are declined, the highest first, need not be computed.
    int highest = order_;
    while (highest > 0 && declines(highest)) --highest;
    return integrand_.task<W>(std::get<std::vector<W>>(parameters_), highest);
  }
  /// Tensors of zeros.
  template <Scalar W = Mp200>
  Result<W> empty() const {
    Result<W> sums;
    integrand_.reset(sums, order_);
    return sums;
  }
  /// Adds sums of a narrower scalar.
  template <Scalar W>
  void add(const Result<W>& part, Result<Mp200>& total) {
    for (int o = 0; o <= order_; ++o)
      for (std::size_t i = 0; i < part.of(o).size(); ++i) total.of(o)[i] += Mp200(part.of(o)[i]);
    nodes_ += part.nodes;
  }

  /// Whether sums over that many more nodes are too much work for a query. If so, declines the highest order that is
  /// left: sums then leave it out, and its error_of is infinite.
  bool too_much(double nodes);
  /// Finds the norms if they are not known, however much of the integrand's mass cancels. \param log10_mass by order
  void find_log10_norms(const std::array<double, 3>& log10_mass, const SumWithError& with_error);
  /// log10 of the absolute errors that leave each order so many digits.
  std::array<double, 3> error_of(double digits) const {
    return {log10_norms_[0] - digits, log10_norms_[1] - digits, log10_norms_[2] - digits};
  }

  const Integrand& integrand_;
  int order_;

 private:
  static constexpr double kDeclined = std::numeric_limits<double>::infinity();

  std::tuple<std::vector<Mp50>, std::vector<Mp100>, std::vector<Mp200>> parameters_;
  std::size_t nodes_ = 0;
  std::array<double, 3> log10_norms_{};  ///< by order
  bool norms_are_known_ = false;
};

/// Sums for a point off the element, or moved off it.
struct Answer {
  Result<Mp200> sums;
  std::array<double, 3> digits{};  ///< by order: the digits on which two rules agree
  double aim = 0;                  ///< the digits that the better rule was asked for
};

/// Digits on which two tensors agree; `most` for equal ones.
double agreement(const std::vector<Mp200>& a, const std::vector<Mp200>& b, double most);

/// Computes a sum by two rules, the second 6 digits better by design, until they agree to `digits` or after four
/// attempts.
Answer converge(ConvergingSum& sum, double digits, int order);

/// The data of a point on the element for the limit from inside.
struct Inside {
  /// The sum after the point was moved inside by a distance, in the local unit of length.
  std::function<std::unique_ptr<ConvergingSum>(const Mp200& inward)> moved;
  Mp200 clearance;                        ///< smallest distance above zero to a corner or an edge's line (OnTriangle)
  bool border = false;                    ///< whether the point is on the border
  std::array<double, 3> log10_natural{};  ///< by order: the size that the unit of length gives a tensor
};

/// The limit from inside, extrapolated from distances far below the clearance: on the element's interior tensors are
/// power series of the distance h, on its border there are also terms h^p log h. An order has a limit if the
/// extrapolations without and with the last terms agree, or are both negligible (the limit is zero); otherwise its
/// tensor and digits are NaN.
Answer limit_from_inside(const Inside& inside, double digits, int order);

/// The digits to ask for, kMostDigits at most, so that the entries within R's range keep `wanted` digits beside larger
/// entries beyond that range.
template <Scalar R>
double digits_for(double wanted, const Answer& answer, const Result<R>& result, int order) {
  double needed = wanted;
  for (int o = 0; o <= order; ++o)
    needed = std::max(needed, entry_spread(answer.sums.of(o), result.of(o)).digits_for(wanted));
  return std::min(needed, kMostDigits);
}

/// Sets a multiprecision evaluation's result: tensors scaled back from units of 2^exponent, and what it states.
/// \param integral gives the Answer to a number of digits; called again while entries within R's range need more
template <Scalar R, class Integral>
void set_answer(const Integrand& integrand, int exponent, double digits, int order, Integral integral,
                Result<R>& result) {
  Answer answer = integral(digits);
  finish(integrand, exponent, answer.sums, result);
  // In a loop, because entries that were noise are smaller in the next answer, and may need more digits.
  for (double asked = digits, needed; asked < (needed = digits_for(digits, answer, result, order)); asked = needed) {
    const std::size_t nodes = answer.sums.nodes;
    answer = integral(needed);
    answer.sums.nodes += nodes;
    finish(integrand, exponent, answer.sums, result);
  }
  result.nodes = answer.sums.nodes;
  for (int o = 0; o <= order; ++o) {
    const EntrySpread spread = entry_spread(answer.sums.of(o), result.of(o));
    result.stated_digits = std::fmin(result.stated_digits, spread.digits_left(answer.digits[o]));  // ignores NaN
  }
  if (result.stated_digits < 0) result.stated_digits = 0;
  result.converged = result.stated_digits >= kDigitsPromised;
}

/// The digits that multiprecision evaluations aim at.
template <Scalar R>
double digits_wanted() {
  return std::same_as<R, Mp100> || std::same_as<R, Mp200> ? 60 : kDigitsPromised;
}

}  // namespace cageproof::quadrature_ref
