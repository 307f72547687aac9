// SPDX-License-Identifier: MIT
// The rows of a campaign. A row key identifies the question, a tally holds the findings. Tallies merge in any order
// with the same result.
#pragma once

#include "cageproof/core/results/error_measure.h"

#include <array>
#include <compare>
#include <functional>
#include <string>
#include <string_view>
#include <vector>

namespace cageproof {

/// The key of a row of results: one check of one evaluation in one regime (or on one cage) at one derivative
/// order.
struct RowKey {
  enum class Section { Element, Cage, Deformer } section = Section::Element;
  std::string subject;     ///< formula, kind of cage coordinates, or deformer
  std::string evaluation;  ///< closed_form, gauss-8 ...; for a deformer its variant: stretch=rms ...
  std::string scalar;      ///< float, double, mp50 ...
  std::string setting;     ///< what files call "regime": near-edge ...; for a cage or deformer the cage's name
  std::string check;       ///< truth, scaling ...; partition_of_unity ...
  /// For a cage: inside, outside, on-face, on-edge, on-vertex, mesh, off; for a deformer the pose; else empty.
  std::string place;
  int order = 0;  ///< 0 value, 1 gradient, 2 Hessian

  auto operator<=>(const RowKey&) const = default;
};

/// All sections, in report order.
inline constexpr std::array sections{RowKey::Section::Element, RowKey::Section::Cage, RowKey::Section::Deformer};

/// "element", "cage", "deformer".
std::string_view name_of(RowKey::Section section);

/// The figures of a tally, which its row of results repeats.
struct RowFigures {
  std::string unit;                 ///< of the errors: "conditioned", "relative" ...
  std::string role;                 ///< of the evaluation: "recommended", "rule" ...; empty where it has none
  std::uint64_t asked = 0;          ///< samples that were put to the row: measured, or one of the following
  std::uint64_t without_truth = 0;  ///< samples where no truth exists: the limit diverges, or the input is none
  std::uint64_t unreached = 0;      ///< samples where a limit exists, and no truth or figure was reached
  std::uint64_t declined = 0;       ///< samples where an evaluation with a tolerance said that it could not meet it
  double max_relative = 0;          ///< largest plain relative error, norm-wise
  /// The largest error, of all samples, that a result without one right digit would have had; negative where it is not
  /// known. A bound above it says nothing but that results are finite.
  double total_loss = -1;
};

/// The findings of one row. Memory is bounded, whatever the number of samples.
struct Tally : RowFigures {
  ErrorHistogram errors;
  WorstCases worst;
  /// Largest relative error, in roundings of the scalar, by index of the regime's parameter; negative where nothing was
  /// measured. Empty: no curve is drawn.
  std::vector<double> by_parameter;

  /// Counts a measured error, of which no input is kept; a NaN counts as infinite.
  void add(double error, double relative) {
    errors.add(error);
    max_relative = std::max(max_relative, relative);
  }
  /// Counts a measured error, and keeps the input where it is among the worst. \param sample its number
  /// \param make_case called with the error for the input, when it is among the worst
  template <class MakeCase>
  void add(double error, double relative, std::uint64_t sample, MakeCase make_case) {
    if (std::isnan(error)) error = std::numeric_limits<double>::infinity();
    add(error, relative);
    if (worst.wants(error, sample)) worst.add(make_case(error));
  }
  /// Notes an error for a regime's curve. \param index of the parameter, below `count`
  void add_to_curve(std::size_t index, std::size_t count, double error);
  bool empty() const { return asked + errors.count() + without_truth + unreached + declined == 0; }
  /// \throws std::invalid_argument when both have units and they differ
  void merge(const Tally& other);
};

}  // namespace cageproof

template <>
struct std::hash<cageproof::RowKey> {
  std::size_t operator()(const cageproof::RowKey& key) const noexcept;
};
