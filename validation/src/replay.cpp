// SPDX-License-Identifier: MIT
#include "cageproof/validation/replay.h"

#include "element_questions.h"

#include "cageproof/core/embedded_cages.h"
#include "cageproof/core/input_error.h"
#include "cageproof/core/mesh_io.h"
#include "cageproof/core/unknown_name.h"
#include "cageproof/validation/block_campaign.h"
#include "cageproof/validation/cage_campaign.h"
#include "cageproof/validation/cage_symmetries.h"
#include "cageproof/validation/deformer_campaign.h"
#include "cageproof/validation/hunt.h"
#include "cageproof/validation/one_ring.h"
#include "cageproof/validation/scheme_errors.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace cageproof::validation {
namespace {

void require_input_of(const Formula& formula, const WorstCase& worst) {
  if (static_cast<int>(worst.corners.size()) != formula.corners() ||
      worst.parameters.size() != formula.parameters.size())
    throw InputError(fmt::format("not an input of {}", formula.name));
  for (const auto& v : worst.corners)
    if (!v.allFinite()) throw InputError("a corner is not finite");
  if (!worst.point.allFinite()) throw InputError("the point is not finite");
  for (int c = formula.dim(); c < 3; ++c)
    if (worst.point[c] != 0 || std::ranges::any_of(worst.corners, [&](const auto& v) { return v[c] != 0; }))
      throw InputError("not in the plane");
}

ElementQuestion question_of(const RowKey& row, const WorstCase& worst) {
  ElementQuestion question = element_question(row, worst.asked);
  require_input_of(question.evaluation.formula(), worst);
  return question;
}

Finding replay_element(const RowKey& row, const WorstCase& worst) {
  const ElementQuestion question = question_of(row, worst);
  const TruthSource source = truth_source(question.evaluation.formula());
  // A campaign's truths have all orders, a hunt's those that it asks for.
  const int order = row.regime == hunted_regime ? worst.asked : 2;
  return question.ask(
      {source, {worst.corners, worst.point, worst.parameters, worst.parameter, worst.sample}, order})[row.order];
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

void require_replayable(const RowKey& row, const WorstCase& worst) { question_of(row, worst); }

}  // namespace cageproof::validation
