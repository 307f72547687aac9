// SPDX-License-Identifier: MIT
#include "cageproof/validation/replay.h"

#include "cageproof/core/embedded_cages.h"
#include "cageproof/core/input_error.h"
#include "cageproof/core/mesh_io.h"
#include "cageproof/validation/cage_campaign.h"
#include "cageproof/validation/cage_symmetries.h"
#include "cageproof/validation/check.h"
#include "cageproof/validation/one_ring.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace cageproof::validation {
namespace {

double replay_element(const ResultRow& row, const WorstCase& worst) {
  const Formula* formula = find_formula(row.subject);
  if (!formula) throw InputError(fmt::format("unknown formula '{}'", row.subject));
  const auto evaluation = EvaluationRegister::instance().find(row.subject, row.evaluation);
  if (!evaluation) throw InputError(fmt::format("{} has no evaluation '{}'", row.subject, row.evaluation));
  const auto scalar = scalar_named(row.scalar);
  if (!scalar) throw InputError(fmt::format("unknown scalar '{}'", row.scalar));
  const Check* check = find_check(row.check);
  if (!check) throw InputError(fmt::format("unknown check '{}'", row.check));
  if (static_cast<int>(worst.corners.size()) != formula->corners() ||
      worst.parameters.size() != formula->parameters.size())
    throw InputError(fmt::format("not an input of {}", row.subject));
  for (const auto& v : worst.corners)
    if (!v.allFinite()) throw InputError("a corner is not finite");
  if (!worst.point.allFinite()) throw InputError("the point is not finite");
  if (!evaluation->supports(*scalar) || !check->applies(*formula, *evaluation, *scalar, row.regime))
    throw InputError(fmt::format("the check '{}' is not asked of {} in {}, {}", row.check, row.evaluation, row.scalar, row.regime));
  const Sample sample{worst.corners, worst.point, worst.parameters, worst.parameter, worst.sample};
  const Evaluation reference = *EvaluationRegister::instance().find(row.subject, "closed_form");
  const Truth truth = truth_from(reference, sample, worst.asked);
  const int order = std::min(worst.asked, evaluation->max_order());
  if (row.order > order) throw InputError(fmt::format("{} was not asked for order {}", row.evaluation, row.order));
  const Finding finding = check->measure({*formula, *evaluation, *scalar, sample, order, truth})[row.order];
  return finding.status == Finding::Status::Measured ? finding.error : NAN;
}

double replay_cage(const ResultRow& row, const WorstCase& worst, Triangulation rule) {
  const auto names = embedded_cage_names();
  const Cage cage = std::ranges::find(names, row.regime) != names.end()
                        ? embedded_cage(row.regime)
                        : read_cage(row.regime, {.flip_inward = true});
  if (!worst.point.allFinite()) throw InputError("the point is not finite");
  if (row.check == "own_derivative" || row.check == "one_ring_sum")
    return one_ring_error_at(cage, {.evaluation = row.evaluation, .triangulation = rule}, row.check, row.order, worst.point);
  const CoordinateKind* kind = find_coordinate_kind(row.subject);
  if (!kind) throw InputError(fmt::format("unknown kind of coordinates '{}'", row.subject));
  const CageCoordinates coordinates(cage, *kind, row.evaluation, rule);
  // The orders that the campaign asked for: how many digits an evaluation takes may depend on what else is asked of it.
  const int asked = std::min(worst.asked, coordinates.max_order());
  if (row.check == "cage_truth" && row.order <= asked)
    return truth_errors_at(coordinates, {cage, *kind, "closed_form", rule}, worst.point, asked)[row.order];
  if (row.check.starts_with("cage_") && row.check != "cage_laplacian") {
    const CageSymmetries symmetries(cage, *kind, row.evaluation, rule);
    if (row.check == "cage_differences") return symmetries.differences_at(worst.point)[row.order];
    const auto errors = symmetries.errors_at(worst.point);
    if (const auto found = errors.find(row.check); found != errors.end()) return found->second;
  }
  const bool on_cage = !coordinates.touching(worst.point).empty();
  const CageLocator locator(cage, rule, kind->keeps_quads());
  if (row.check == "limit_from_inside") return inside_limit_error_at(coordinates, cage, locator, worst.point);
  const double expected =
      on_cage || kind->normalised || locator.inside(worst.point) ? 1 : 0;
  const CageErrors errors = errors_at(coordinates, cage, worst.point, expected, on_cage || row.place == "mesh" ? 0 : asked);
  if (row.check == "cage_laplacian") return errors.laplacian;
  if (row.check == "linear_reproduction") return errors.reproduction[row.order];
  if (row.check == "partition_of_unity" || row.check == "zero_outside") return errors.partition[row.order];
  throw InputError(fmt::format("unknown check '{}'", row.check));
}

}  // namespace

double replay(const ResultRow& row, const WorstCase& worst, Triangulation rule) {
  if (row.order < 0 || row.order > 2) throw InputError(fmt::format("unknown order {}", row.order));
  return row.section == ResultRow::Section::Cage ? replay_cage(row, worst, rule) : replay_element(row, worst);
}

}  // namespace cageproof::validation
