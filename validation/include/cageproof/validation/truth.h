// SPDX-License-Identifier: MIT
// The truth at a sample, and the yardstick that errors are measured with.
#pragma once

#include "cageproof/validation/sample.h"

#include <array>

namespace cageproof::validation {

/// Evaluations that give a formula's truth. They are the closed form, or where it has none the recommended evaluation,
/// which a campaign proves against the integral; else the integral itself.
struct TruthSource {
  /// Digits that the truth is computed in, and those that confirm it.
  enum class Digits {
    Fifty,       ///< 50, of which the source keeps all, and 100
    Hundred,     ///< 100 and 200
    OfIntegral,  ///< the integral in 100 digits goes on to 60, in 50 digits it stops at 30
  };

  Evaluation evaluation;
  Evaluation values;        ///< gives the truth: the evaluation, or what stands in for it
  Evaluation confirmation;  ///< confirms it to 30 digits: the evaluation, or what stands in for it from other nodes
  /// Gives the differences that the yardstick is made of: right to all digits, or where it is rough to twelve.
  Evaluation yardstick;
  bool rough_yardstick = false;
  Digits digits = Digits::Hundred;

  /// Whether a truth costs as much as an integral in multiprecision, so that a campaign should take fewer samples.
  bool is_costly() const { return rough_yardstick; }
  bool is_integral() const { return digits == Digits::OfIntegral; }
};

/// The source of the formula's truth. \throws InputError where the formula has none
TruthSource truth_source(const Formula& formula);

/// Whether truth_source() has an answer.
bool has_truth_source(const Formula& formula);

/// Value, gradient and Hessian at a sample, in multiprecision, and per order the denominator of the conditioned error,
/// |truth| + sum_k |x_k| |d truth/d x_k| over the coordinates x_k of the element and the point.
struct Truth {
  Result<Mp100> tensors;
  /// False for an order where no limit exists (diverges on the element) or where two precisions do not agree to 30
  /// digits.
  std::array<bool, 3> exists{false, false, false};
  /// True for an order where a limit must exist, whatever an evaluation finds; see limit_must_exist().
  std::array<bool, 3> required{false, false, false};
  /// True for an order where two precisions agree that entries are infinite, with which sign, or have no limit, and to
  /// 30 digits on the finite ones.
  std::array<bool, 3> partial{false, false, false};
  /// Norm and conditioned yardstick by order, over the finite entries.
  std::array<Mp100, 3> norm{};
  std::array<Mp100, 3> conditioned{};
  /// True when the point lies exactly on the element. Then the yardstick counts only moves to its inner side, since the
  /// function may jump; for points on the border only moves that stay on it (a rough yardstick: none, only the norm).
  bool on_element = false;
};

/// The norm of a tensor is the square root of the sum of its entries' squares.
Mp100 norm(const std::vector<Mp100>& tensor);

Truth truth_from(const TruthSource& source, const Sample& sample, int order);

/// |f - truth| over the conditioned denominator, in units of `u`, norm-wise over the entries that are finite and within
/// R's range. Infinite where another entry is not what it must be: infinite with the truth's sign where that is
/// infinite or beyond R's range, NaN where no limit exists. An entry whose truth lies below R's normal numbers may be
/// wrong by one denormal. \pre truth.exists[order] or truth.partial[order]
template <Scalar R>
double conditioned_error(const Result<R>& f, const Truth& truth, int order, const Mp100& u);

/// The conditioned error, in units of `u`, of a result that has no digit of the truth right: |truth| over the
/// conditioned denominator. Infinite where zero is the truth, and where entries have no limit, since what is wrong
/// there is seen whatever the conditioning.
double score_of_total_loss(const Truth& truth, int order, const Mp100& u);

/// The entry of a tensor that is furthest from the truth, in the order of Result. Entries that are not finite where the
/// truth is, or the other way round, come before all others. \pre the tensor has entries
template <Scalar R>
int furthest_entry(const Result<R>& f, const Truth& truth, int order);

/// |f - truth| / max(|truth|, floor), norm-wise; as conditioned_error.
template <Scalar R>
double relative_error(const Result<R>& f, const Truth& truth, int order, const Mp100& floor = 0);

/// |f - truth| / |truth|, norm-wise, in units of what so many decimal digits leave; as conditioned_error, but that one
/// denormal counts as any other error.
template <Scalar R>
double error_over_digits(const Result<R>& f, const Truth& truth, int order, double digits);

/// Where a sample's point lies on its element, decided exactly.
Contact contact_of(ElementKind element, const Sample& sample);

}  // namespace cageproof::validation
