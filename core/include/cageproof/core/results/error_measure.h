// SPDX-License-Identifier: MIT
// The error vocabulary: log-binned histograms, and the worst inputs kept exactly. All of it merges without regard to
// order.
#pragma once

#include "cageproof/core/numbers/vector.h"

#include <array>
#include <cstdint>
#include <string>
#include <utility>
#include <vector>

namespace cageproof {

/// Counts of errors, ten bins per decade from 1e-6 to 1e24, with the exact maximum. Errors are >= 0, or infinite for a
/// result that is not finite where the truth is. Merging is associative and commutative, so any schedule gives the same
/// histogram.
class ErrorHistogram {
 public:
  static constexpr int bins_per_decade = 10;
  static constexpr int lowest_decade = -6;
  static constexpr int highest_decade = 24;
  static constexpr int bin_count = (highest_decade - lowest_decade) * bins_per_decade;

  /// \pre error >= 0 or infinite; a NaN counts as infinite
  void add(double error);
  void merge(const ErrorHistogram& other);
  std::uint64_t count() const { return count_; }
  /// How many errors were infinite.
  std::uint64_t nonfinite() const { return nonfinite_; }
  /// The exact largest error; 0 when empty.
  double max() const { return max_; }
  /// The upper edge of the bin that holds the q-quantile (0 < q <= 1), at most max(); 0 when empty.
  double quantile(double q) const;
  double median() const { return quantile(0.5); }
  double p999() const { return quantile(0.999); }
  /// The counts that are not zero, by place in counts(), rising: a row's errors fall into a few bins, and a run has
  /// tens of thousands of rows.
  const std::vector<std::pair<std::size_t, std::uint64_t>>& filled() const { return filled_; }
  /// counts()[0]: below 1e-6; [1 .. bin_count]: the bins; [bin_count + 1]: above 1e24 and infinite.
  std::array<std::uint64_t, bin_count + 2> counts() const;
  /// The histogram that had these counts(), nonfinite() and max().
  /// \throws std::invalid_argument when there is none
  static ErrorHistogram restored(const std::array<std::uint64_t, bin_count + 2>& counts, std::uint64_t nonfinite,
                                 double max);

 private:
  void add_to(std::size_t place, std::uint64_t count);
  std::vector<std::pair<std::size_t, std::uint64_t>> filled_;
  std::uint64_t count_ = 0;
  std::uint64_t nonfinite_ = 0;
  double max_ = 0;
};

/// The tensor entry furthest from the truth.
struct FurthestEntry {
  int index = -1;     ///< in the order of Result; negative where no tensor was compared
  double found = 0;   ///< what the evaluation gave
  std::string truth;  ///< to twenty digits
};

/// Where a cage stands: every vertex v at unit (v + shift), the sum rounded, then the product.
struct CageFrame {
  Vec3<double> shift = Vec3<double>::Zero();
  double unit = 1;
  bool is_own() const { return unit == 1 && shift.isZero(0); }
};

/// An input, exactly, and how wrong the result was.
struct WorstCase {
  double error = 0;      ///< in the row's unit; infinite for a non-finite result
  double parameter = 0;  ///< the regime's parameter (distance, aspect, unit ...); 0 where there is none
  std::uint64_t sample = 0;
  std::vector<Vec3<double>> corners = {};  ///< the element; empty for a cage check
  Vec3<double> point = Vec3<double>::Zero();
  std::vector<double> parameters = {};  ///< in the order of Formula::parameters
  int asked = 2;                        ///< highest derivative of the query: forms may differ by it
  double relative = 0;                  ///< the plain relative error, norm-wise; 0 where none was measured
  FurthestEntry furthest = {};
  CageFrame frame = {};  ///< of a cage: where it stood
};

/// Every number of a case's input, bit for bit: the sign of zero counts. Its error and its regime's parameter are not
/// input.
std::vector<std::uint64_t> input_bits(const WorstCase& worst_case);

/// The k worst cases, by falling error, then by rising sample number, then by the bits of the input: independent of the
/// order of insertion.
class WorstCases {
 public:
  explicit WorstCases(std::size_t capacity = 5) : capacity_(capacity) {}
  /// False when a case of that error would not be kept: ask before building an expensive case.
  bool wants(double error, std::uint64_t sample) const;
  void add(WorstCase worst_case);
  void merge(const WorstCases& other);
  const std::vector<WorstCase>& cases() const { return cases_; }

 private:
  std::size_t capacity_;
  std::vector<WorstCase> cases_;
};

}  // namespace cageproof
