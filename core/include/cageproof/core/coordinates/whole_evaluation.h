// SPDX-License-Identifier: MIT
// Ways to compute all coordinates of a cage at once, instead of formula by formula and element by element.
#pragma once

#include "cageproof/core/coordinates/coordinates.h"

#include <list>

namespace cageproof {

/// A way to compute whole coordinates of kinds that are sums over elements. Its name stands where a formula's
/// evaluation does (CoordinateOptions::evaluation); ways that compute different kinds may share one.
struct WholeEvaluation {
  std::string_view name;
  std::string_view description;
  Role role = Role::Batched;
  /// Whether it computes the kind in that cage, which the kind accepts.
  bool (*exists)(const CoordinateKind& kind, const Cage& cage) = nullptr;
  /// \param options with all parameters \param summed the same kind by recommended evaluations, for scalars and points
  /// that this one leaves to them \pre exists(kind, cage)
  std::shared_ptr<const PreparedCoordinates> (*prepare)(const CoordinateKind& kind,
                                                        std::shared_ptr<const CageElements> elements,
                                                        const CoordinateOptions& options,
                                                        std::shared_ptr<const PreparedCoordinates> summed) = nullptr;
};

/// All of them, in the order in which they were added. They stay where they are.
const std::list<WholeEvaluation>& whole_evaluations();

/// Adds one at program start: `const RegisterWholeEvaluation r{...};` at namespace scope of a .cpp.
struct RegisterWholeEvaluation {
  explicit RegisterWholeEvaluation(WholeEvaluation evaluation);
};

/// The first one of that name, or null.
const WholeEvaluation* find_whole_evaluation(std::string_view name);

/// The whole evaluation of that name that computes the kind in the cage, and that the kind accepts, or null.
const WholeEvaluation* find_whole_evaluation(std::string_view name, const CoordinateKind& kind, const Cage& cage);

/// The names of the whole evaluations that compute the kind in the cage.
std::vector<std::string_view> whole_evaluation_names(const CoordinateKind& kind, const Cage& cage);

/// Refuses a name that is no whole evaluation of the kind in the cage, and that no formula of the kind has on any
/// element. \throws InputError in the kind's words
void require_evaluation(const CoordinateKind& kind, const Cage& cage, std::string_view name);

/// The highest derivative that the kind's coordinates can have in the cage by an evaluation, before anything is
/// prepared: that of the formulas that have the evaluation; 2 where none has.
int highest_order(const CoordinateKind& kind, const Cage& cage, std::string_view evaluation);

/// A name that lets the suite choose the evaluation of a sum over elements: the first of role batched that computes the
/// kind in the cage, or the formulas' recommended ones. Kinds that are made of such sums
/// (CoordinateKind::made_of_sums) ask for theirs by this name; other kinds ignore it.
inline constexpr std::string_view quickest = "quickest";

/// The evaluation that `quickest` stands for: a name, or empty for the recommended ones. \pre the kind is a sum
std::string quickest_evaluation(const CoordinateKind& kind, const Cage& cage);

}  // namespace cageproof
