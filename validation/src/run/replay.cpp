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
#include <variant>

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

// The names that decide what a row's cases need.
std::string names_of(const RowKey& row, std::string_view evaluation, Triangulation rule, const StoredFacts& stored) {
  std::vector<std::string> folders;
  folders.reserve(stored.folders.size());
  for (const auto& folder : stored.folders) folders.push_back(folder.string());
  return fmt::format("{}\n{}\n{}\n{}\n{}\n{}", row.subject, evaluation, row.setting, static_cast<int>(rule),
                     stored.cage_content, fmt::join(folders, "\n"));
}

}  // namespace

// The last case's cage and what was made of it, by the names that decide it.
struct Replayer::Prepared {
  using Subjects =
      std::variant<std::monostate, std::unique_ptr<OneRing>, std::unique_ptr<BlockErrors>, std::unique_ptr<CageSubject>,
                   std::unique_ptr<ConstrainedChecks>, std::unique_ptr<DeformerChecks>>;
  std::string names;
  std::shared_ptr<const Cage> cage;
  Subjects kept;

  // The subject of those names, made of their cage unless it is there. \param make unique_ptr<Subject>(cage)
  template <class Make>
  auto& subject_of(std::string wanted, const RowKey& row, const StoredFacts& stored, const Make& make) {
    using Subject = decltype(make(cage));
    if (wanted != names || !std::holds_alternative<Subject>(kept)) {
      names.clear();
      kept = std::monostate();
      cage = std::make_shared<const Cage>(stored_cage(row.setting, stored));
      kept = make(cage);
      names = std::move(wanted);
    }
    return *std::get<Subject>(kept);
  }

  Finding replay_cage(const RowKey& row, const WorstCase& worst, Triangulation rule, const StoredFacts& stored);
  Finding replay_deformer(const RowKey& row, const WorstCase& worst, Triangulation rule, const StoredFacts& stored);
};

Finding Replayer::Prepared::replay_cage(const RowKey& row, const WorstCase& worst, Triangulation rule,
                                        const StoredFacts& stored) {
  if (row.subject == one_ring_formula) {
    const auto& ring = subject_of(names_of(row, row.evaluation, rule, stored), row, stored, [&](const auto& of) {
      return std::make_unique<OneRing>(of, OneRingOptions{.evaluation = row.evaluation, .triangulation = rule});
    });
    return answer(ring.questions(), row, stored, ring.at(worst.point, worst.sample));
  }
  const CoordinateKind& kind = coordinate_kind_named(row.subject);
  std::vector<std::string_view> places = cage_places();
  places.push_back(mesh_place);
  require_place(row.place, places);
  if (row.check == block_error_check) {
    const auto& errors = subject_of(names_of(row, row.evaluation, rule, stored), row, stored, [&](const auto& of) {
      return std::make_unique<BlockErrors>(*of, kind, row.evaluation, rule);
    });
    return answer(std::vector{errors.question(row.place)}, row, stored, BlockAt{block_sample(worst)});
  }
  // At meshes kinds that are made of sums take the quickest ones, and keep their name.
  const std::string evaluation = row.place == mesh_place && kind.made_of_sums ? std::string(quickest) : row.evaluation;
  const auto& subject = subject_of(names_of(row, evaluation, rule, stored), row, stored, [&](const auto& of) {
    return std::make_unique<CageSubject>(of, kind, evaluation, rule);
  });
  const int order = order_at(row.place, subject.coordinates(), worst.asked);
  return answer(cage_questions(subject, row.place, order), row, stored,
                CageAt(subject, worst.point, worst.sample, row.place, order));
}

Finding Replayer::Prepared::replay_deformer(const RowKey& row, const WorstCase& worst, Triangulation rule,
                                            const StoredFacts& stored) {
  const PointAt at{worst.point, worst.sample};
  const std::string wanted = names_of(row, row.evaluation, rule, stored);
  if (const auto* method = deformation::find_constraint_method(row.subject)) {
    const auto& checks = subject_of(wanted, row, stored, [&](const auto& of) {
      return std::make_unique<ConstrainedChecks>(of, variant_named(*method, row.evaluation), rule);
    });
    return answer(checks.questions(), row, stored, at);
  }
  const auto& checks = subject_of(wanted, row, stored, [&](const auto& of) {
    return std::make_unique<DeformerChecks>(
        of, variant_named(deformation::deform_method_named(row.subject), row.evaluation), rule);
  });
  return answer(checks.questions(), row, stored, at);
}

Replayer::Replayer() : prepared_(std::make_unique<Prepared>()) {}
Replayer::~Replayer() = default;

Finding Replayer::replay(const RowKey& row, const WorstCase& worst, Triangulation rule, const StoredFacts& stored) {
  if (row.order < 0 || row.order > 2) throw InputError(fmt::format("unknown order {}", row.order));
  if (row.section == RowKey::Section::Element) return replay_element(row, worst, stored);
  if (!worst.point.allFinite()) throw InputError("the point is not finite");
  if (row.section == RowKey::Section::Deformer) return prepared_->replay_deformer(row, worst, rule, stored);
  return prepared_->replay_cage(row, worst, rule, stored);
}

Finding replay(const RowKey& row, const WorstCase& worst, Triangulation rule, const StoredFacts& stored) {
  return Replayer().replay(row, worst, rule, stored);
}

void require_replayable(const RowKey& row, const WorstCase& worst) { question_of(row, worst); }

}  // namespace cageproof::validation
