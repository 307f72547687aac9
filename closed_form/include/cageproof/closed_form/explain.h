// SPDX-License-Identifier: MIT
// Errors that each operation of a closed form adds to one of its results: the closed form runs in numbers that count.
#pragma once

#include "cageproof/closed_form/arithmetic/counted_tape.h"
#include "cageproof/closed_form/joint.h"

#include <optional>
#include <span>
#include <string_view>

namespace cageproof::closed_form {

/// One entry of a closed form's tensor, operation by operation.
struct Explanation {
  std::string route;  ///< which form computed it
  /// Whether the operations are those that computed `value`. Else they are those of the form in double, whose result
  /// was given up for more digits, as `route` says.
  bool is_the_value = true;
  std::size_t entry = 0;
  double value = 0;            ///< the closed form's
  double counted = 0;          ///< the result of the operations
  Mp200 exact;                 ///< their result without roundings, along the same branches
  std::size_t operations = 0;  ///< all that were recorded, also those that the entry does not depend on
  /// In the entry's unit; see CountedLine. Empty where there was nothing to count.
  std::vector<CountedLine> lines;
};

/// Explains an entry of the tensor of derivative order query.order. \param values that tensor, as the closed form gives
/// it \param entry which; else the one in which the operations' errors are largest
using Explainer = Explanation (*)(const Query<double>& query, std::span<const double> values,
                                  std::optional<std::size_t> entry);

/// The Explainer of the form F on the Engine's kind of element: `explain<F, O>(query, values, entry)` of query.order.
template <class Engine, class F>
Explanation explain_on(const Query<double>& query, std::span<const double> values, std::optional<std::size_t> entry) {
  Explanation explanation;
  with_order(query.order, [&]<int O>() { explanation = Engine::template explain<F, O>(query, values, entry); });
  return explanation;
}

/// An evaluation of a formula at a point, explained. \param evaluation one of explained_evaluations() \param result
/// that evaluation's, up to query.order
/// \throws InputError where the evaluation is not run in counted numbers, or has no such entry
Explanation explain(const Formula& formula, std::string_view evaluation, const Query<double>& query,
                    std::optional<std::size_t> entry, Result<double>& result);

/// The evaluations of a formula that explain() knows, by name.
std::vector<std::string_view> explained_evaluations(std::string_view formula);
/// The formulas whose evaluation of this name explain() knows, by name.
std::vector<std::string_view> explained_formulas(std::string_view evaluation);

/// Fills what an explanation says of one entry. \param counted the tensor's entries in the unit that they were computed
/// in, which times 2^exponent is the caller's \param values the closed form's, in the caller's
void choose(Explanation& explanation, const CountedTape& tape, std::span<const Counted> counted, int exponent,
            std::span<const double> values, std::optional<std::size_t> entry);

/// Fills what an explanation says of an entry where nothing was computed in double. \param values, entry as above
void choose_none(Explanation& explanation, std::span<const double> values, std::optional<std::size_t> entry);

/// A member or a variable that lives as long as the program. \param formula and evaluation live as long
struct RegisterExplainer {
  RegisterExplainer(std::string_view formula, std::string_view evaluation, Explainer explainer);
};

}  // namespace cageproof::closed_form
