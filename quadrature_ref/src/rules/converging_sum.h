// SPDX-License-Identifier: MIT
// Integrals at any number of digits: what the multiprecision evaluation asks for twice.
#pragma once

#include "beyond_range.h"
#include "finish.h"

#include <functional>
#include <tuple>

namespace cageproof::quadrature_ref {

/// Digits that the arithmetic of 50, 100 and 200 digits leaves after the rounding of a cell's sums and geometry.
inline constexpr double kDigitsIn50 = 46, kDigitsIn100 = 95, kDigitsIn200 = 190;
/// log10 of nothing: of a mass or a norm that is zero.
inline constexpr double kNoMass = -std::numeric_limits<double>::infinity();
/// The most digits that a result is asked for: what two rules that must agree, the second better, leave of 190.
inline constexpr double kMostDigits = 160;
/// The digits that multiprecision evaluations converge to; otherwise they state that they did not converge.
inline constexpr double kDigitsPromised = 30;

/// An integral that can be had to as many digits as asked, as far as its design goes.
class ConvergingSum {
 public:
  virtual ~ConvergingSum() = default;
  /// The tensors to about `digits` digits each order (Hessians: entries i <= j), in the local unit of length.
  virtual Result<Mp200> at(double digits) = 0;
  /// log10 of each order's norm, once `at` was called.
  const std::array<double, 3>& norm() const { return norm_; }
  /// Takes the norms, as far as digits go, from a sum that differs little: they need not be found.
  void take_norm(const std::array<double, 3>& norm) {
    norm_ = norm;
    norm_is_known_ = true;
  }
  /// Kernel evaluations so far.
  std::size_t nodes() const { return nodes_; }
  /// Whether an order's tensor is not computed, because it would take too much work or cancels beyond 200 digits.
  bool declines(int order) const { return norm_[order] == kDeclined; }

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

  /// Whether sums over as many nodes more are more work than a query is worth; declines the highest order of those that
  /// are left if so. Sums then leave it out: error_of is infinite.
  bool too_much(double nodes);
  /// Finds the norms, however much of the integrand's mass (log10, an order) cancels, if they are not known.
  void find_norm(const std::array<double, 3>& mass, const SumWithError& with_error);
  /// The absolute errors, log10, of that many digits.
  std::array<double, 3> error_of(double digits) const {
    return {norm_[0] - digits, norm_[1] - digits, norm_[2] - digits};
  }

  const Integrand& integrand_;
  int order_;

 private:
  static constexpr double kDeclined = std::numeric_limits<double>::infinity();

  std::tuple<std::vector<Mp50>, std::vector<Mp100>, std::vector<Mp200>> parameters_;
  std::size_t nodes_ = 0;
  std::array<double, 3> norm_{};  ///< log10, an order
  bool norm_is_known_ = false;
};

/// Sums of a query off the element, or moved off it.
struct Answer {
  Result<Mp200> sums;
  std::array<double, 3> digits{};  ///< on which two rules agree, an order
  double aim = 0;                  ///< the digits that the better rule was asked for
};

/// Digits on which two tensors agree; `most` for equal ones.
double agreement(const std::vector<Mp200>& a, const std::vector<Mp200>& b, double most);

/// Two rules, the second 6 digits better by design, until they agree to `digits` or four attempts are spent.
Answer converge(ConvergingSum& sum, double digits, int order);

/// The data of a point on the element for the limit from inside.
struct Inside {
  /// The sum after the point was moved inside by a distance, in the local unit of length.
  std::function<std::unique_ptr<ConvergingSum>(const Mp200& inward)> moved;
  Mp200 clearance;                        ///< distance to the nearest part of the border that the point is not on
  bool border = false;                    ///< whether the point is on the border
  std::array<double, 3> log10_natural{};  ///< of an order's tensor: the size that its unit of length gives it
};

/// The limit from inside, extrapolated from distances far below the clearance: on the element's interior tensors are
/// power series of the distance h, on its border there are terms h^p log h besides. An order has a limit if the
/// extrapolations without and with the last terms agree, or are both next to nothing (the limit is zero); otherwise its
/// tensor and digits are NaN.
Answer limit_from_inside(const Inside& inside, double digits, int order);

/// Digits, of all orders' tensors, that leave those wanted in entries within R's range where others leave it, as far as
/// 200 digits can.
template <Scalar R>
double digits_for(double wanted, const Answer& answer, const Result<R>& result, int order) {
  double needed = wanted;
  for (int o = 0; o <= order; ++o)
    needed = std::max(needed, entry_spread(answer.sums.of(o), result.of(o)).digits_for(wanted));
  return std::min(needed, kMostDigits);
}

/// Sets a multiprecision evaluation's result: tensors scaled back from units of 2^exponent, and what it states.
/// \param integral the Answer to that many digits; asked again where these do not tell the entries within R's range
template <Scalar R, class Integral>
void set_answer(const Integrand& integrand, int exponent, double digits, int order, Integral integral,
                Result<R>& result) {
  Answer answer = integral(digits);
  finish(integrand, exponent, answer.sums, result);
  // A second time, because entries that were noise are smaller then.
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

/// Digits that the multiprecision evaluations aim at.
template <Scalar R>
double digits_wanted() {
  return std::same_as<R, Mp100> || std::same_as<R, Mp200> ? 60 : kDigitsPromised;
}

}  // namespace cageproof::quadrature_ref
