// SPDX-License-Identifier: MIT
#include "cageproof/validation/replay.h"

#include "cageproof/core/embedded_cages.h"
#include "cageproof/core/input_error.h"
#include "cageproof/core/mesh_io.h"
#include "cageproof/core/unknown_name.h"
#include "cageproof/validation/block_campaign.h"
#include "cageproof/validation/cage_campaign.h"
#include "cageproof/validation/cage_symmetries.h"
#include "cageproof/validation/check.h"
#include "cageproof/validation/deformer_campaign.h"
#include "cageproof/validation/hunt.h"
#include "cageproof/validation/one_ring.h"
#include "cageproof/validation/scheme_errors.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace cageproof::validation {
namespace {

// An element's case with all that its names stand for.
struct ElementCase {
  const Formula* formula;
  Evaluation evaluation;
  ScalarKind scalar;
  const Check* check;
  int order;  // that the evaluation is asked for
};

std::vector<std::string_view> names_of_scalars() {
  std::vector<std::string_view> names;
  names.reserve(scalar_kinds.size());
  for (const ScalarKind kind : scalar_kinds) names.push_back(name_of(kind));
  return names;
}

std::vector<std::string_view> names_of_regimes() {
  std::vector<std::string_view> names{hull_regime, hunted_regime};
  for (const Regime& regime : regimes()) names.push_back(regime.name);
  return names;
}

ElementCase element_case(const RowKey& row, const WorstCase& worst) {
  const Formula& formula = formula_named(row.subject);
  const Evaluation evaluation = evaluation_named(row.subject, row.evaluation);
  const auto scalar = scalar_named(row.scalar);
  if (!scalar) throw unknown_name("scalar", row.scalar, names_of_scalars());
  const Check* check = find_check(row.check);
  if (!check) throw unknown_name("check", row.check, check_names());
  if (const auto known = names_of_regimes(); std::ranges::find(known, row.regime) == known.end())
    throw unknown_name("regime", row.regime, known);
  if (static_cast<int>(worst.corners.size()) != formula.corners() ||
      worst.parameters.size() != formula.parameters.size())
    throw InputError(fmt::format("not an input of {}", row.subject));
  for (const auto& v : worst.corners)
    if (!v.allFinite()) throw InputError("a corner is not finite");
  if (!worst.point.allFinite()) throw InputError("the point is not finite");
  for (int c = formula.dim(); c < 3; ++c)
    if (worst.point[c] != 0 || std::ranges::any_of(worst.corners, [&](const auto& v) { return v[c] != 0; }))
      throw InputError("not in the plane");
  if (!evaluation.supports(*scalar) || !check->applies(formula, evaluation, *scalar, row.regime))
    throw InputError(
        fmt::format("the check '{}' is not asked of {} in {}, {}", row.check, row.evaluation, row.scalar, row.regime));
  const int order = std::min(worst.asked, evaluation.max_order());
  if (row.order < 0 || row.order > order)
    throw InputError(fmt::format("{} was not asked for order {}", row.evaluation, row.order));
  return {&formula, evaluation, *scalar, check, order};
}

Finding replay_element(const RowKey& row, const WorstCase& worst) {
  const ElementCase c = element_case(row, worst);
  const Sample sample{worst.corners, worst.point, worst.parameters, worst.parameter, worst.sample};
  const Truth truth = truth_from(truth_source(*c.formula), sample, worst.asked);
  return c.check->measure({*c.formula, c.evaluation, c.scalar, sample, c.order, truth})[row.order];
}

// Of checks that promise relative errors.
CageError relative(double error) { return {error, error}; }

Cage cage_of(const RowKey& row, const WorstCase& worst) {
  if (!worst.point.allFinite()) throw InputError("the point is not finite");
  return is_embedded_cage(row.regime) ? embedded_cage(row.regime) : read_cage(row.regime, {.flip_inward = true});
}

Finding replay_block(const RowKey& row, const WorstCase& worst, Triangulation rule) {
  const BlockErrors errors(cage_of(row, worst), coordinate_kind_named(row.subject), row.evaluation, rule);
  const BlockFinding found = errors.at(block_sample(worst));
  const CageError& error = found.errors[row.order];
  if (found.is_input && !found.truth_reached) return {Finding::Status::Unreached};
  if (std::isnan(error.roundings)) return {Finding::Status::NoTruth};
  return {Finding::Status::Measured, error.roundings, error.relative};
}

CageError replay_cage(const RowKey& row, const WorstCase& worst, Triangulation rule) {
  const Cage cage = cage_of(row, worst);
  if (row.check == "own_derivative" || row.check == "one_ring_sum")
    return relative(one_ring_error_at(cage, {.evaluation = row.evaluation, .triangulation = rule}, row.check, row.order,
                                      worst.point));
  const CoordinateKind* kind = &coordinate_kind_named(row.subject);
  const CageCoordinates coordinates(cage, *kind, row.evaluation, rule);
  // The orders that the campaign asked for: how many digits an evaluation takes may depend on what else is asked of it.
  const int asked = std::min(worst.asked, coordinates.max_order());
  const CageTerms terms(cage, *kind, rule, row.evaluation);
  if (row.check == "cage_truth" && row.order <= asked)
    return truth_errors_at(coordinates, {cage, *kind, CoordinateOptions{.triangulation = rule}}, worst.point, asked,
                           &terms)[row.order];
  if (row.check.starts_with("cage_") && row.check != "cage_laplacian") {
    const CageSymmetries symmetries(cage, *kind, row.evaluation, rule);
    if (row.check == "cage_differences") return relative(symmetries.differences_at(worst.point)[row.order]);
    const auto errors = symmetries.errors_at(worst.point);
    if (const auto found = errors.find(row.check); found != errors.end()) return found->second;
  }
  if (row.check == "scheme_error") {
    const auto approximated = approximated_by(cage, *kind, rule);
    if (!approximated) throw InputError(fmt::format("{} does not accept {}", kind->approximates, cage.name()));
    return relative(scheme_errors_at(coordinates, *approximated, cage, worst.point, asked)[row.order]);
  }
  if (row.check == "boundary_data" && row.order < 2) {
    const auto missed = boundary_data_errors_at(coordinates, cage, worst.point);
    return relative(missed ? (*missed)[row.order].value_or(NAN) : NAN);
  }
  if (row.check == "boundary_residual" && row.order < 2)
    return relative(boundary_residuals(coordinates)[row.order].value_or(NAN));
  const bool on_cage = !coordinates.elements().touching(worst.point).empty();
  const CageLocator locator(cage, rule, kind->keeps_quads);
  if (row.check == "limit_from_inside")
    return relative(
        inside_limit_errors_at(coordinates, cage, locator, worst.point, row.order)[row.order].value_or(NAN));
  const double expected = on_cage ? 1 : expected_sum(*kind, locator, worst.point);
  const CageErrors errors = errors_at(coordinates, cage, worst.point, expected,
                                      on_cage || row.place == "mesh" ? 0 : asked, on_cage ? nullptr : &terms);
  if (row.check == "cage_laplacian") return errors.laplacian;
  if (row.check == "linear_reproduction") return errors.reproduction[row.order];
  if (row.check == "partition_of_unity" || row.check == "zero_outside") return errors.partition[row.order];
  throw unknown_name("check", row.check);
}

}  // namespace

Finding replay(const RowKey& row, const WorstCase& worst, Triangulation rule) {
  if (row.order < 0 || row.order > 2) throw InputError(fmt::format("unknown order {}", row.order));
  if (row.section == RowKey::Section::Element) return replay_element(row, worst);
  // On cages an error that is not asked, or has no truth, is none.
  const auto finding = [](double error, double relative) {
    return Finding{std::isnan(error) ? Finding::Status::NoTruth : Finding::Status::Measured, error, relative};
  };
  if (row.section == RowKey::Section::Deformer) {
    const DeformerError error = deformer_error_at(cage_of(row, worst), row, worst.point, rule);
    return finding(error.error, error.plain);
  }
  if (row.check == block_error_check) return replay_block(row, worst, rule);
  const CageError error = replay_cage(row, worst, rule);
  return finding(error.roundings, error.relative);
}

void require_replayable(const RowKey& row, const WorstCase& worst) { element_case(row, worst); }

}  // namespace cageproof::validation
