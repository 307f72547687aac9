// SPDX-License-Identifier: MIT
// How wrong a tensor is, entry by entry where norms say nothing: where the truth is infinite, has no limit, or leaves
// the range of the result's scalar.
#include "cageproof/validation/truth.h"

#include <limits>
#include <vector>

namespace cageproof::validation {
namespace {

constexpr double infinite = std::numeric_limits<double>::infinity();

// Range of a scalar, to compare entries with. Multiprecision holds every number that occurs.
template <Scalar R>
struct Range {
  static constexpr bool unbounded = is_multiprecision<R>;
  /// Next to the largest number rounding decides whether a result is infinite.
  static bool may_overflow(const Mp100& size) {
    if constexpr (unbounded) return false;
    else return size > Mp100(std::numeric_limits<R>::max()) * (1 - edge);
  }
  static bool must_overflow(const Mp100& size) {
    if constexpr (unbounded) return false;
    else return size > Mp100(std::numeric_limits<R>::max()) * (1 + edge);
  }
  /// The resolution of a result whose truth is this small.
  static Mp100 quantum(const Mp100& size) {
    if constexpr (unbounded) return 0;
    else return size < std::numeric_limits<R>::min() ? Mp100(std::numeric_limits<R>::denorm_min()) : Mp100(0);
  }
  static constexpr double edge = 1e-6;
};

// Squares of the norms of errors and truths, over the entries that are finite and within range.
struct Compared {
  Mp100 error = 0, truth = 0;
  bool entries_left_out = false;
  bool wrong = false;  // an entry is not what it must be
};

template <Scalar R>
Compared compared(const std::vector<R>& found, const std::vector<Mp100>& truth, bool forgiving = true) {
  Compared c;
  const std::vector<Mp100> wide(found.begin(), found.end());
  // Beside entries beyond the range, those below a rounding of the largest say nothing: the tensor as a whole is good
  // to a rounding.
  Mp100 largest = 0;
  for (const Mp100& t : truth)
    if (isfinite(t) && abs(t) > largest) largest = abs(t);
  const Mp100 unseen = Range<R>::must_overflow(largest) ? Mp100(largest * Mp100(unit_roundoff<R>())) : Mp100(0);
  for (std::size_t i = 0; i < found.size(); ++i) {
    const Mp100& x = wide[i];
    const Mp100& t = truth[i];
    const Mp100 size = abs(t);
    if (size < unseen && !isnan(x)) {
      c.entries_left_out = true;
      continue;
    }
    const bool as_infinite = isinf(x) && (x > 0) == (t > 0) && !isnan(t) && Range<R>::may_overflow(size);
    if (isnan(t) || isinf(t) || as_infinite || Range<R>::must_overflow(size)) {
      c.entries_left_out = true;
      const bool right = isnan(t) ? static_cast<bool>(isnan(x)) : isinf(x) && (x > 0) == (t > 0);
      c.wrong = c.wrong || !right;
      continue;
    }
    if (!isfinite(x)) {
      c.wrong = true;
      continue;
    }
    Mp100 error = abs(Mp100(x - t));
    const Mp100 quantum = forgiving ? Range<R>::quantum(size) : Mp100(0);
    error = error > quantum ? Mp100(error - quantum) : Mp100(0);
    c.error += error * error;
    c.truth += t * t;
  }
  return c;
}

double ratio(const Compared& c, const Mp100& denominator) {
  if (c.wrong) return infinite;
  if (c.error == 0) return 0;
  return denominator == 0 ? infinite : static_cast<double>(Mp100(sqrt(c.error) / denominator));
}

}  // namespace

template <Scalar R>
double conditioned_error(const Result<R>& f, const Truth& truth, int order, const Mp100& u) {
  const Compared c = compared(f.of(order), truth.tensors.of(order));
  Mp100 denominator = u * truth.conditioned[order];
  // Beside entries that are left out the others have a norm of their own, and the tensor's conditioning.
  if (c.entries_left_out && truth.norm[order] > 0) denominator *= sqrt(c.truth) / truth.norm[order];
  return ratio(c, denominator);
}

double score_of_total_loss(const Truth& truth, int order, const Mp100& u) {
  if (!truth.exists[order] || truth.norm[order] == 0) return infinite;
  return static_cast<double>(Mp100(truth.norm[order] / Mp100(u * truth.conditioned[order])));
}

template <Scalar R>
int furthest_entry(const Result<R>& f, const Truth& truth, int order) {
  const auto& found = f.of(order);
  const auto& wanted = truth.tensors.of(order);
  int furthest = 0;
  Mp100 largest = -1;
  const auto widened = [](const R& value) { return Mp100(value); };
  for (std::size_t i = 0; i < found.size(); ++i) {
    const Mp100 x = widened(found[i]);
    if (isfinite(x) != isfinite(wanted[i])) return static_cast<int>(i);
    if (!isfinite(x)) continue;
    const Mp100 distance = abs(Mp100(x - wanted[i]));
    if (distance > largest) largest = distance, furthest = static_cast<int>(i);
  }
  return furthest;
}

template <Scalar R>
double relative_error(const Result<R>& f, const Truth& truth, int order, const Mp100& floor) {
  const Compared c = compared(f.of(order), truth.tensors.of(order));
  const Mp100 size = sqrt(c.truth);
  return ratio(c, size < floor ? floor : size);
}

template <Scalar R>
double error_over_digits(const Result<R>& f, const Truth& truth, int order, double digits) {
  const Compared c = compared(f.of(order), truth.tensors.of(order), false);
  return ratio(c, Mp100(sqrt(c.truth) * pow(Mp100(10), Mp100(-digits))));
}

#define CAGEPROOF_INSTANTIATE(R)                                                           \
  template double conditioned_error<R>(const Result<R>&, const Truth&, int, const Mp100&); \
  template int furthest_entry<R>(const Result<R>&, const Truth&, int);                     \
  template double relative_error<R>(const Result<R>&, const Truth&, int, const Mp100&);    \
  template double error_over_digits<R>(const Result<R>&, const Truth&, int, double);
CAGEPROOF_INSTANTIATE(float)
CAGEPROOF_INSTANTIATE(double)
CAGEPROOF_INSTANTIATE(Mp50)
CAGEPROOF_INSTANTIATE(Mp100)
CAGEPROOF_INSTANTIATE(Mp200)
#undef CAGEPROOF_INSTANTIATE

}  // namespace cageproof::validation
