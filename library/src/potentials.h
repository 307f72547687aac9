// SPDX-License-Identifier: MIT
// Formulas on lists of elements, which need not make up a cage.
#pragma once

#include "cageproof/core/catalogue/evaluation.h"
#include "cageproof/core/coordinates/coordinates.h"

#include <array>
#include <optional>
#include <span>

namespace cageproof::library {

/// The coordinates that sum a formula on a vector of points at once, and their block that it is; nothing for most.
struct BatchedFormula {
  const CoordinateKind* kind;
  std::size_t block;
};

/// Which limit points on an element get.
enum class Side { Inside, Outside, Mean };

/// A formula by one evaluation, with its parameters.
class ElementFormula {
 public:
  /// \param evaluation empty for the recommended one, or "batched" for values of all pairs
  /// \param parameters names and texts of values
  /// \throws InputError for an unknown name, and for a parameter out of range
  ElementFormula(const std::string& formula, const std::string& evaluation,
                 const std::vector<std::pair<std::string, std::string>>& parameters);

  const Formula& formula() const { return evaluation_.formula(); }
  const Evaluation& evaluation() const { return evaluation_; }
  std::span<const double> parameters() const { return parameters_; }
  /// Null unless the evaluation is "batched"; evaluation() is then the recommended one.
  const BatchedFormula* batched() const { return batched_ ? &*batched_ : nullptr; }

 private:
  std::optional<BatchedFormula> batched_;
  Evaluation evaluation_;
  std::vector<double> parameters_;
};

/// A question about lists of elements and points.
struct ElementRequest {
  const ElementFormula& of;
  int order = 0;
  Side side = Side::Inside;
  int threads = 0;  ///< 0: all cores
};

/// Tensors of derivative orders 0, 1, 2.
using TensorSpans = std::array<std::span<double>, 3>;

/// A result per pair of an element and a point; one of either goes with all of the other.
/// \param elements [n][corner][axis] \param points [n][axis]
/// \throws InputError for spans of other sizes, numbers that are not finite, an element without length or area, a quad
/// that is not valid, and an order that does not exist
void evaluate_pairs(const ElementRequest& request, std::span<const double> elements, std::span<const double> points,
                    const TensorSpans& results);

/// All pairs: [point][element][component], derivatives behind. \throws InputError as above
void evaluate_all(const ElementRequest& request, std::span<const double> elements, std::span<const double> points,
                  const TensorSpans& results);

/// Sums over elements of tensors times densities [element][tensor][column][set]: [point][row][set], derivatives behind.
/// Added up in the order of elements, in double. \throws InputError as above
void apply_all(const ElementRequest& request, std::span<const double> elements, std::span<const double> densities,
               int sets, std::span<const double> points, const TensorSpans& results);

}  // namespace cageproof::library
