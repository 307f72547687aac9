// SPDX-License-Identifier: MIT
// Integrals at any number of digits: what the multiprecision evaluation asks for twice.
#pragma once

#include "gauss.h"
#include "polar_cells.h"

#include <functional>
#include <tuple>

namespace cageproof::quadrature_ref {

/// Digits that the arithmetic of 50, 100 and 200 digits leaves after the rounding of a cell's sums and geometry.
inline constexpr double kDigitsIn50 = 46, kDigitsIn100 = 95, kDigitsIn200 = 190;
/// What the multiprecision evaluations converge to or say that they did not.
inline constexpr double kDigitsPromised = 30;

/// An integral that can be had to as many digits as asked, as far as its design goes.
class ConvergingSum {
 public:
  virtual ~ConvergingSum() = default;
  /// The tensors to about `digits` digits each order (Hessians: entries i <= j), in the local unit of length.
  virtual Result<Mp200> at(double digits) = 0;
  /// Kernel evaluations so far.
  std::size_t nodes() const { return nodes_; }

 protected:
  /// The sum with an absolute error of about 10^log10_error[order].
  using SumWithError = std::function<Result<Mp200>(const std::array<double, 3>& log10_error)>;

  ConvergingSum(const Integrand& integrand, const Query<Mp200>& query)
      : integrand_(integrand),
        order_(query.order),
        components_(integrand.formula.components()),
        parameters_(convert_all<Mp50>(query.parameters), convert_all<Mp100>(query.parameters),
                    convert_all<Mp200>(query.parameters)) {}

  template <Scalar W>
  static std::vector<W> convert_all(std::span<const Mp200> values) {
    std::vector<W> converted;
    for (const Mp200& value : values) converted.push_back(static_cast<W>(value));
    return converted;
  }
  template <Scalar W>
  std::span<const W> parameters() const {
    return std::get<std::vector<W>>(parameters_);
  }
  Result<Mp200> empty() const {
    Result<Mp200> sums;
    sums.reset(components_, 3, order_);
    return sums;
  }
  /// Adds sums of a narrower scalar.
  template <Scalar W>
  void add(const Result<W>& part, Result<Mp200>& total) {
    for (int o = 0; o <= order_; ++o)
      for (std::size_t i = 0; i < part.of(o).size(); ++i) total.of(o)[i] += Mp200(part.of(o)[i]);
    nodes_ += part.nodes;
  }

  /// log10 of each order's norm, however much of the integrand's mass (log10, an order) cancels.
  std::array<double, 3> norms(const std::array<double, 3>& mass, const SumWithError& with_error) const;

  const Integrand& integrand_;
  int order_;
  int components_;

 private:
  std::tuple<std::vector<Mp50>, std::vector<Mp100>, std::vector<Mp200>> parameters_;
  std::size_t nodes_ = 0;
};

/// Sums of a query off the element, or moved off it.
struct Answer {
  Result<Mp200> sums;
  std::array<double, 3> digits{};  ///< on which two rules agree, an order
};

/// Digits on which two tensors agree; `most` for equal ones.
double agreement(const std::vector<Mp200>& a, const std::vector<Mp200>& b, double most);

/// Two rules, the second 6 digits better by design, until they agree to `digits` or four attempts are spent.
Answer converge(ConvergingSum& sum, double digits, int order);

/// Gauss-Legendre on the collapsed square, for points at least 1.5 longest edges away.
class FarSum final : public ConvergingSum {
 public:
  FarSum(const Integrand& integrand, const LocalTriangle<Mp200>& triangle, const Query<Mp200>& query);
  Result<Mp200> at(double digits) override;

 private:
  template <Scalar W>
  Result<Mp200> at_precision(int n);

  const LocalTriangle<Mp200>& triangle_;
  double log10_rate_;  ///< digits gained by one more point a side
};

/// Polar cells, each with the points and the precision that its share demands.
class PolarSum final : public ConvergingSum {
 public:
  PolarSum(const Integrand& integrand, PolarFrame<Mp200> frame, const Query<Mp200>& query);
  Result<Mp200> at(double digits) override;

 private:
  template <Scalar W>
  void add_cell(const PolarFrame<W>& frame, const PolarCell& cell, CellPoints points, Result<Mp200>& total);
  /// The sum with an absolute error of about 10^log10_error[order].
  Result<Mp200> with_error(const std::array<double, 3>& log10_error);
  /// Finds masses and norms.
  void scout();

  PolarFrame<Mp200> exact_frame_;
  PolarFrame<Mp50> frame50_;
  PolarFrame<Mp100> frame100_;
  std::vector<PolarCell> cells_;
  std::vector<std::array<double, 3>> mass_;  ///< log10, a cell and order
  std::array<double, 3> norm_{};             ///< log10, an order
  bool scouted_ = false;
  int more_directions_ = 0;  ///< on rings; alternates, so that comparing two sums tests the directions as well
};

}  // namespace cageproof::quadrature_ref
