// SPDX-License-Identifier: MIT
#include "cageproof/validation/replay.h"

#include "cages/cage_questions.h"
#include "checks/element_questions.h"

#include "cageproof/core/embedded_cages.h"
#include "cageproof/core/input_error.h"
#include "cageproof/core/mesh_io.h"
#include "cageproof/core/whole_evaluation.h"
#include "cageproof/validation/block_campaign.h"
#include "cageproof/validation/constrained_checks.h"
#include "cageproof/validation/hunt.h"
#include "cageproof/validation/one_ring.h"

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
  const int order = row.setting == hunted_regime ? worst.asked : 2;
  return question.ask(
      {source, {worst.corners, worst.point, worst.parameters, worst.parameter, worst.sample}, order})[row.order];
}

Cage cage_of(const RowKey& row, const WorstCase& worst) {
  if (!worst.point.allFinite()) throw InputError("the point is not finite");
  return is_embedded_cage(row.setting) ? embedded_cage(row.setting) : read_cage(row.setting, {.flip_inward = true});
}

template <class Q, class At>
Finding answer(const std::vector<Q>& questions, const RowKey& row, const At& at) {
  const Q* question = find_question(questions, row);
  const Finding finding = question ? question->ask(at)[row.order] : Finding{};
  if (finding.status != Finding::Status::Unasked) return finding;
  throw InputError(fmt::format("the check '{}' is not asked of {} by {} on {}, place '{}', order {}", row.check,
                               row.subject, row.evaluation, row.setting, row.place, row.order));
}

Finding replay_cage(const RowKey& row, const WorstCase& worst, Triangulation rule) {
  const auto cage = std::make_shared<const Cage>(cage_of(row, worst));
  if (row.subject == one_ring_formula) {
    const OneRing ring(cage, {.evaluation = row.evaluation, .triangulation = rule});
    return answer(ring.questions(), row, ring.at(worst.point, worst.sample));
  }
  const CoordinateKind& kind = coordinate_kind_named(row.subject);
  if (row.check == block_error_check) {
    const BlockErrors errors(*cage, kind, row.evaluation, rule);
    return answer(std::vector{errors.question(row.place)}, row, BlockAt{block_sample(worst)});
  }
  // At meshes kinds that are made of sums take the quickest ones, and keep their name.
  const bool made_of_quickest = row.place == mesh_place && kind.made_of_sums;
  const CageSubject subject(cage, kind, made_of_quickest ? std::string(quickest) : row.evaluation, rule);
  const int order = order_at(row.place, subject.coordinates(), worst.asked);
  return answer(cage_questions(subject, row.place, order), row,
                CageAt(subject, worst.point, worst.sample, row.place, order));
}

Finding replay_deformer(const RowKey& row, const WorstCase& worst, Triangulation rule) {
  const auto cage = std::make_shared<const Cage>(cage_of(row, worst));
  const PointAt at{worst.point, worst.sample};
  if (const auto* method = deformation::find_constraint_method(row.subject))
    return answer(ConstrainedChecks(cage, variant_named(*method, row.evaluation), rule).questions(), row, at);
  return answer(DeformerChecks(cage, variant_named(deformation::deform_method_named(row.subject), row.evaluation), rule)
                    .questions(),
                row, at);
}

}  // namespace

Finding replay(const RowKey& row, const WorstCase& worst, Triangulation rule) {
  if (row.order < 0 || row.order > 2) throw InputError(fmt::format("unknown order {}", row.order));
  if (row.section == RowKey::Section::Element) return replay_element(row, worst);
  if (row.section == RowKey::Section::Deformer) return replay_deformer(row, worst, rule);
  return replay_cage(row, worst, rule);
}

void require_replayable(const RowKey& row, const WorstCase& worst) { question_of(row, worst); }

}  // namespace cageproof::validation
