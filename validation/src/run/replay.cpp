// SPDX-License-Identifier: MIT
#include "cageproof/validation/replay.h"

#include "cages/cage_questions.h"
#include "checks/element_questions.h"
#include "run/stored_cage.h"

#include "cageproof/core/input_error.h"
#include "cageproof/core/coordinates/whole_evaluation.h"
#include "cages/block_campaign.h"
#include "cages/cage_regimes.h"
#include "deformers/constrained_checks.h"
#include "cageproof/validation/hunt.h"
#include "cages/one_ring.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

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
  if (!row.place.empty())
    throw InputError(fmt::format("unknown place '{}': a single element has none, \"\"", row.place));
  ElementQuestion question = element_question(row, worst.asked);
  require_input_of(question.evaluation.formula(), worst);
  return question;
}

void require_unit(const std::string& unit, const RowKey& row, const StoredFacts& stored) {
  if (!stored.unit.empty() && stored.unit != unit)
    throw InputError(
        fmt::format("unknown unit '{}': errors of the check '{}' are in '{}'", stored.unit, row.check, unit));
}

Finding replay_element(const RowKey& row, const WorstCase& worst, const StoredFacts& stored) {
  const ElementQuestion question = question_of(row, worst);
  require_unit(question.unit, row, stored);
  const TruthSource source = truth_source(question.evaluation.formula());
  // A campaign's truths have all orders, a hunt's those that it asks for.
  const int order = row.setting == hunted_regime ? worst.asked : 2;
  return question.ask(
      {source, {worst.corners, worst.point, worst.parameters, worst.parameter, worst.sample}, order})[row.order];
}

Cage cage_of(const RowKey& row, const WorstCase& worst, const StoredFacts& stored) {
  if (!worst.point.allFinite()) throw InputError("the point is not finite");
  return stored_cage(row.setting, stored);
}

void require_place(const std::string& place, const std::vector<std::string_view>& known) {
  if (std::ranges::find(known, place) == known.end())
    throw InputError(fmt::format("unknown place '{}'; known: {}", place, fmt::join(known, ", ")));
}

template <class Q, class At>
Finding answer(const std::vector<Q>& questions, const RowKey& row, const StoredFacts& stored, const At& at) {
  const Q* question = find_question(questions, row);
  if (question) require_unit(question->unit, row, stored);
  const Finding finding = question ? question->ask(at)[row.order] : Finding{};
  if (finding.status != Finding::Status::Unasked) return finding;
  throw InputError(fmt::format("the check '{}' is not asked of {} by {} on {}, place '{}', order {}", row.check,
                               row.subject, row.evaluation, row.setting, row.place, row.order));
}

Finding replay_cage(const RowKey& row, const WorstCase& worst, Triangulation rule, const StoredFacts& stored) {
  const auto cage = std::make_shared<const Cage>(cage_of(row, worst, stored));
  if (row.subject == one_ring_formula) {
    const OneRing ring(cage, {.evaluation = row.evaluation, .triangulation = rule});
    return answer(ring.questions(), row, stored, ring.at(worst.point, worst.sample));
  }
  const CoordinateKind& kind = coordinate_kind_named(row.subject);
  std::vector<std::string_view> places = cage_places();
  places.push_back(mesh_place);
  require_place(row.place, places);
  if (row.check == block_error_check) {
    const BlockErrors errors(*cage, kind, row.evaluation, rule);
    return answer(std::vector{errors.question(row.place)}, row, stored, BlockAt{block_sample(worst)});
  }
  // At meshes kinds that are made of sums take the quickest ones, and keep their name.
  const bool made_of_quickest = row.place == mesh_place && kind.made_of_sums;
  const CageSubject subject(cage, kind, made_of_quickest ? std::string(quickest) : row.evaluation, rule);
  const int order = order_at(row.place, subject.coordinates(), worst.asked);
  return answer(cage_questions(subject, row.place, order), row, stored,
                CageAt(subject, worst.point, worst.sample, row.place, order));
}

Finding replay_deformer(const RowKey& row, const WorstCase& worst, Triangulation rule, const StoredFacts& stored) {
  const auto cage = std::make_shared<const Cage>(cage_of(row, worst, stored));
  const PointAt at{worst.point, worst.sample};
  if (const auto* method = deformation::find_constraint_method(row.subject))
    return answer(ConstrainedChecks(cage, variant_named(*method, row.evaluation), rule).questions(), row, stored, at);
  return answer(DeformerChecks(cage, variant_named(deformation::deform_method_named(row.subject), row.evaluation), rule)
                    .questions(),
                row, stored, at);
}

}  // namespace

Finding replay(const RowKey& row, const WorstCase& worst, Triangulation rule, const StoredFacts& stored) {
  if (row.order < 0 || row.order > 2) throw InputError(fmt::format("unknown order {}", row.order));
  if (row.section == RowKey::Section::Element) return replay_element(row, worst, stored);
  if (row.section == RowKey::Section::Deformer) return replay_deformer(row, worst, rule, stored);
  return replay_cage(row, worst, rule, stored);
}

void require_replayable(const RowKey& row, const WorstCase& worst) { question_of(row, worst); }

}  // namespace cageproof::validation
