// SPDX-License-Identifier: MIT
#include "run/run_plan.h"

#include "run/asked_names.h"
#include "run/fingerprint.h"
#include "run/regimes_nowhere.h"
#include "checks/hull_continuity.h"
#include "run/run_report.h"

#include "cageproof/core/cage/embedded_cages.h"
#include "cageproof/core/cage/winding_numbers.h"
#include "cageproof/core/geometry/box.h"
#include "cageproof/core/input_error.h"
#include "cageproof/core/parallel.h"
#include "cageproof/core/coordinates/whole_evaluation.h"
#include "cageproof/reports/worst_file.h"
#include "cages/block_campaign.h"
#include "cages/cage_symmetries.h"
#include "cageproof/validation/cage_campaign.h"
#include "campaign.h"
#include "cageproof/validation/compared_fields.h"
#include "deformers/deformer_campaign.h"
#include "promises/errata.h"
#include "cageproof/validation/error_fields.h"
#include "cageproof/validation/hunt.h"
#include "cages/one_ring.h"
#include "cageproof/validation/paper_figures.h"
#include "cageproof/validation/promise.h"
#include "cageproof/validation/stored_cases.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <map>

namespace cageproof::validation {
namespace {

// A quad's integral in multiprecision costs as much as that many triangles'.
constexpr double quad_cost = 30;

// Number of a cage's points at which relations are asked of a kind's other evaluations: integrals take long.
int affordable_points(const Evaluation& evaluation, int points) {
  switch (evaluation.cost()) {
    case CostClass::Multiprecision: return std::min(points, 4);
    case CostClass::Adaptive: return std::min(points, 20);
    case CostClass::Nodes: return evaluation.role() == Role::Rule ? std::min(points, 40) : points;
    case CostClass::Direct: break;
  }
  // The closed form is the recommended one's algebra, with more digits: slower, and judged one element at a time.
  return evaluation.role() == Role::ClosedForm ? std::min(points, 20) : points;
}

// Every standard evaluation of a formula except the recommended one, and except those that only checks ask for.
std::vector<Evaluation> other_evaluations(const Formula& formula) {
  std::vector<Evaluation> found;
  for (const EvaluationFamily* family : EvaluationRegister::instance().families(formula.name)) {
    if (family->role == Role::Recommended) continue;
    if (family->standard.empty()) found.push_back(family->example());
    for (const std::string& name : family->standard) found.push_back(evaluation_named(formula.name, name));
  }
  return found;
}

// A kind's first formula on those of the cage's faces that a triangulation would cut. \pre the cage has such faces
const Formula& formula_of_kept_faces(const CoordinateKind& kind, const Cage& cage) {
  const auto face = std::ranges::find_if(cage.faces(), [](const Face& f) { return !type_of(f.kind()).splits.empty(); });
  return *find_formula(face->kind(), kind.blocks.front().kernel);
}

// Whether all of a kind's formulas on the faces that it keeps have an evaluation of that name.
bool is_evaluation_of(const std::string& name, const CoordinateKind& kind, const Cage& cage) {
  const ElementKind element = formula_of_kept_faces(kind, cage).element;
  return std::ranges::all_of(kind.blocks, [&](const SummedBlock& block) {
    return EvaluationRegister::instance().find(find_formula(element, block.kernel)->name, name).has_value();
  });
}

// Whether a pattern names evaluations of whole coordinates, and none of a formula.
bool names_whole_evaluations_alone(const std::string& pattern) {
  const bool whole = std::ranges::any_of(
      whole_evaluations(), [&](const WholeEvaluation& evaluation) { return matches(pattern, evaluation.name); });
  if (!whole) return false;
  for (const Formula& formula : catalogue())
    for (const std::string& name : EvaluationRegister::instance().standard(formula.name))
      if (matches_evaluation(pattern, evaluation_named(formula.name, name))) return false;
  return true;
}

// Whether a pattern names every formula of some element, as `*` and `quad.*` do.
bool names_a_whole_element(const std::string& pattern) {
  return std::ranges::any_of(element_kinds, [&](ElementKind element) {
    return std::ranges::all_of(catalogue(), [&](const Formula& formula) {
      return formula.element != element || matches(pattern, formula.name);
    });
  });
}

// The first of the embedded cages that satisfy `is_suitable` with the fewest faces; empty where none does.
template <class F>
std::string smallest_embedded_cage(F&& is_suitable) {
  static const std::vector<Cage> cages = [] {
    std::vector<Cage> all;
    for (const auto name : embedded_cage_names()) all.push_back(embedded_cage(name));
    return all;
  }();
  const Cage* smallest = nullptr;
  for (const Cage& cage : cages)
    if ((smallest == nullptr || cage.faces().size() < smallest->faces().size()) && is_suitable(cage)) smallest = &cage;
  return smallest == nullptr ? std::string() : std::string(smallest->name());
}

// Names that a cage refuses, by reason.
using NamesByReason = std::map<std::string, std::vector<std::string_view>>;

class Planner {
 public:
  explicit Planner(const VerifyOptions& options)
      : options_(options), one_cage_each_(!options.cage && !names_a_whole_element(options.formulas)) {}

  RunPlan plan() {
    require_known_names(options_);
    doing("planning");
    if (options_.cage && options_.mesh) tell_points_outside(*options_.cage, options_.mesh->vertices);
    if (names_whole_evaluations_alone(options_.evaluations)) return plan_of_whole_evaluations();
    const std::size_t stored_cases = options_.only_cage ? 0 : add_elements();
    if (!options_.only_cage) tell_regimes_nowhere();
    if (options_.cage) {
      const auto cage = std::make_shared<const Cage>(*options_.cage);
      if (auto warning = folding_warning(*cage)) plan_.header.notes.push_back(std::move(*warning));
      if (auto warning = crossing_warning(*cage)) plan_.header.notes.push_back(std::move(*warning));
      add_cage(cage);
      if (options_.mesh) add_mesh(cage);
      add_deformers(cage);
    } else {
      for (const auto name : embedded_cage_names()) add_cage(std::make_shared<const Cage>(embedded_cage(name)));
      add_figure_three();
      for (const auto name : extreme_cage_names())
        add_recommended(std::make_shared<const Cage>(embedded_cage(name)), extreme_cage_options());
      add_extreme_batched();
      for (const auto name : deformer_cage_names()) add_deformers(std::make_shared<const Cage>(embedded_cage(name)));
      if (!options_.suite.has_time_limit)
        for (const auto name : small_face_cage_names())
          add_deformers(std::make_shared<const Cage>(embedded_cage(name)));
    }
    // Figures show whole kinds of coordinates, on cages of their own.
    if (!options_.cage && options_.formulas == "*" && options_.evaluations == "*" && options_.regimes == "*")
      add(figure_measurements(!options_.suite.has_time_limit));
    if (!options_.only_cage) add(errata_measurement({.formulas = options_.formulas, .seed = options_.seed}));
    for (std::string& note : notes_on_truth(options_.formulas)) plan_.header.notes.push_back(std::move(note));
    if (one_cage_each_)
      plan_.header.notes.emplace_back(
          "each kind of coordinates is asked on the smallest embedded cage on which it sums a formula asked for; a run "
          "that asks for all formulas of an element asks all cages");
    plan_.units = units_of(plan_.measurements);
    set_header(stored_cases);
    doing("");
    return std::move(plan_);
  }

 private:
  void doing(const std::string& what) const {
    if (options_.doing) options_.doing(what);
  }
  void add(std::unique_ptr<const Measurement> measurement) { plan_.measurements.push_back(std::move(measurement)); }
  void add(Measurements measurements) {
    for (auto& measurement : measurements) add(std::move(measurement));
  }

  // Formulas one element at a time, in regimes of the catalogue's own. Returns the number of stored cases.
  std::size_t add_elements() {
    if (std::ranges::any_of(regimes(), [&](const Regime& one) { return matches(options_.regimes, one.name); }))
      add(element_measurements(campaign_options()));
    auto stored = stored_measurement(stored_worst_cases(), stored_cases_file, options_.formulas, options_.evaluations);
    if (stored.measurement) add(std::move(stored.measurement));
    if (matches(options_.formulas, hull_formula) && matches(options_.regimes, hull_regime))
      add(hull_measurements(options_.evaluations, options_.seed));
    return stored.cases;
  }

  void tell_regimes_nowhere() {
    regimes_nowhere_ = regimes_nowhere(options_.formulas, options_.regimes);
    if (!regimes_nowhere_.empty()) plan_.warnings.push_back(regimes_nowhere_);
  }

  // Deformers use whole kinds of coordinates, so they are asked only when all formulas are.
  void add_deformers(const std::shared_ptr<const Cage>& cage) {
    if (options_.formulas != "*") return;
    RefusedMethods refused;
    DeformerCampaignOptions campaign{.triangulation = options_.triangulation, .seed = options_.seed};
    campaign.doing = options_.doing;
    campaign.proves_methods = !is_awaited();
    if (options_.cage) campaign.solved_elements = cage_options().solved_elements;
    Measurements found = deformer_measurements(cage, campaign, options_.cage ? &refused : nullptr);
    doing("planning");
    if (found.empty() && interior_points(*cage, options_.triangulation, options_.seed, 1).empty())
      plan_.header.notes.push_back(fmt::format(
          "{}: deformers are not judged, no point is found 2e-2 of its size and more inside", cage->name()));
    add(std::move(found));
    for (const auto& [reason, names] : refused) {
      plan_.warnings.push_back(fmt::format("{}: no deformer {}, {}", cage->name(), fmt::join(names, ", "), reason));
      plan_.header.notes.push_back(plan_.warnings.back());
    }
  }

  // Whether coordinates of the kind may be asked on a cage.
  bool is_shown_by(const Cage& cage, const CoordinateKind& kind) const {
    if (!exists_on(kind, cage) || !is_affordable(kind, cage, cage_options())) return false;
    // On cages without quads, layers that keep quads equal those that triangulate, so they are skipped.
    return !kind.is_sum() || !kind.keeps_quads || kind.normalised || cage.has_quads();
  }

  // Whether the kind exists on such a cage and sums a formula that is asked for. Kinds that are not sums are asked only
  // when all formulas are.
  bool is_asked(const CoordinateKind& kind, const Cage& cage) const {
    if (!is_shown_by(cage, kind)) return false;
    if (!kind.is_sum()) return options_.formulas == "*";
    return std::ranges::any_of(formulas_of(kind, cage), [&](const Formula* formula) {
      return matches(options_.formulas, formula->name) &&
             (!one_cage_each_ || cage.name() == smallest_cage_of(kind, *formula));
    });
  }

  // The embedded cage on which a kind's sums show a formula.
  const std::string& smallest_cage_of(const CoordinateKind& kind, const Formula& formula) const {
    const auto [known, is_new] = smallest_cages_.try_emplace({kind.name, formula.name});
    if (is_new)
      known->second = smallest_embedded_cage([&](const Cage& cage) {
        return is_shown_by(cage, kind) && accepts(kind, cage) &&
               std::ranges::count(formulas_of(kind, cage), &formula) > 0;
      });
    return known->second;
  }

  bool asks_one_ring_of(const Cage& cage) const {
    if (!one_ring_exists_on(cage) || !matches(options_.formulas, one_ring_formula)) return false;
    return !one_cage_each_ || cage.name() == smallest_embedded_cage(one_ring_exists_on);
  }

  // Why there are no coordinates of the kind, empty where there are. Kinds that solve may find out when they do, so
  // they are tried: all on a user's cage, and on embedded cages those in space, which thin walls may stop.
  std::string refusal_of(const CoordinateKind& kind, const Cage& cage) {
    if (!accepts(kind, cage)) return why_refused(kind, cage);
    // Extreme cages are not asked for kinds that solve.
    const bool may_refuse =
        kind.solves_on_samples && cage.dimension() == 3 && std::ranges::count(embedded_cage_names(), cage.name()) > 0;
    if (kind.is_sum() || (!options_.cage && !may_refuse)) return "";
    const auto [known, is_new] = refusals_.try_emplace({std::string(cage.name()), kind.name});
    if (!is_new) return known->second;
    doing(fmt::format("{}, solving for {} coordinates", cage.name(), kind.name));
    try {
      const auto [low, high] = box_of(cage.vertices());
      const CageCoordinates coordinates(cage, kind, CoordinateOptions{.triangulation = options_.triangulation});
      if (!options_.cage) return known->second;
      coordinates.at<double>(Vec3<double>((low + high) / 2), 0);
      // Where digits just suffice for the cage, they may not for the scaled or turned one, which checks ask for.
      const CageSymmetries symmetries(cage, kind, coordinates.evaluation(), options_.triangulation);
    } catch (const InputError& error) {
      known->second = error.what();
      // The note says this before the reason.
      const std::string said = fmt::format("{}: no {} coordinates: ", cage.name(), kind.name);
      if (known->second.starts_with(said)) known->second.erase(0, said.size());
    }
    doing("planning");
    return known->second;
  }

  CampaignOptions campaign_options() const {
    CampaignOptions campaign;
    campaign.formulas = options_.formulas;
    campaign.evaluations = options_.evaluations;
    campaign.regimes = options_.regimes;
    campaign.seed = options_.seed;
    campaign.samples = options_.suite.samples;
    campaign.swept_samples = options_.suite.swept_samples;
    campaign.integral_samples = options_.suite.integral_samples;
    campaign.integral_entries = options_.suite.integral_entries;
    campaign.enclosures = options_.suite.enclosures;
    return campaign;
  }

  CageCampaignOptions cage_options() const {
    CageCampaignOptions campaign;
    campaign.triangulation = options_.triangulation;
    campaign.seed = options_.seed;
    campaign.points = options_.suite.cage_points;
    campaign.truth_points = options_.suite.truth_points;
    // A user wants to know of every vertex, edge and face.
    campaign.on_points = options_.cage ? 0 : options_.suite.on_points;
    campaign.mesh_points = options_.suite.mesh_points;
    // Signs are checked only in a user's own cage.
    campaign.signs = options_.cage.has_value();
    // Suites with time solve on larger cages.
    if (!options_.suite.has_time_limit) campaign.solved_elements = 50;
    return campaign;
  }

  // There are many of them, each for one thing: twelve points have one at each distance, and as many anywhere.
  CageCampaignOptions extreme_cage_options() const {
    CageCampaignOptions campaign = cage_options();
    campaign.points = std::max(12, campaign.points / 16);
    campaign.truth_points = std::min(campaign.truth_points, 1);
    campaign.on_points = 8;
    campaign.differences = false;
    // Densities are nearly undetermined between walls that nearly coincide.
    campaign.solved_elements = 0;
    // Elements as thin as these need hundreds of digits for their derivatives: suites with time ask for them.
    campaign.properties_alone = options_.suite.truth_points < 4;
    return campaign;
  }

  // Every kind's recommended coordinates.
  void add_recommended(const std::shared_ptr<const Cage>& cage, CageCampaignOptions campaign) {
    for (const CoordinateKind& kind : coordinate_kinds()) {
      if (!is_asked(kind, *cage) || !refusal_of(kind, *cage).empty() || !is_affordable(kind, *cage, campaign)) continue;
      campaign.kinds = kind.name;
      add(cage_measurements(cage, campaign));
    }
  }

  // Adds the checks of whole coordinates: block errors, and the cage's properties.
  void add_batched(const std::shared_ptr<const Cage>& cage, const BlockCampaignOptions& block,
                   CageCampaignOptions campaign) {
    for (const WholeEvaluation& evaluation : whole_evaluations())
      for (const CoordinateKind& kind : coordinate_kinds()) {
        if (evaluation.role != Role::Batched || !matches(options_.evaluations, evaluation.name)) continue;
        if (!kind.is_sum() || !is_asked(kind, *cage) || !accepts(kind, *cage) || !evaluation.exists(kind, *cage))
          continue;
        BlockCampaignOptions options = block;
        options.evaluation = evaluation.name;
        add(block_measurement(cage, kind, options));
        campaign.evaluation = evaluation.name;
        campaign.kinds = kind.name;
        // In multiprecision it is the sum of formulas, whose derivatives are asked for already.
        campaign.differences = false;
        add(cage_measurements(cage, campaign));
      }
  }

  // Somebody waits for the verdict on one cage, and other runs prove what is no matter of the cage.
  bool is_awaited() const { return options_.only_cage && options_.suite.has_time_limit; }

  int block_points_of_run() const {
    const Suite& suite = options_.suite;
    return is_awaited() ? 2 * suite.block_points / 3 : suite.block_points;
  }

  BlockCampaignOptions block_options() const {
    return {.evaluation = {},
            .triangulation = options_.triangulation,
            .seed = options_.seed,
            .points = block_points_of_run(),
            .milliseconds = options_.suite.block_milliseconds};
  }

  // The plan of a run that asks only for whole evaluations.
  RunPlan plan_of_whole_evaluations() {
    if (options_.cage) {
      add_batched(std::make_shared<const Cage>(*options_.cage), block_options(), cage_options());
    } else {
      for (const auto name : embedded_cage_names())
        add_batched(std::make_shared<const Cage>(embedded_cage(name)), block_options(), cage_options());
      add_extreme_batched();
    }
    plan_.units = units_of(plan_.measurements);
    set_header(0);
    doing("");
    return std::move(plan_);
  }

  void add_extreme_batched() {
    // Walls as thin as a rounding take hundreds of digits per element: suites with time ask for block errors there.
    if (options_.suite.has_time_limit) return;
    BlockCampaignOptions block = block_options();
    block.points = block.milliseconds = 0;  // the least
    for (const auto name : extreme_cage_names())
      add_batched(std::make_shared<const Cage>(embedded_cage(name)), block, extreme_cage_options());
  }

  void add_cage(const std::shared_ptr<const Cage>& cage) {
    const auto exists = [&](const CoordinateKind& kind) {
      return is_asked(kind, *cage) && refusal_of(kind, *cage).empty();
    };
    add_recommended(cage, cage_options());
    add_batched(cage, block_options(), cage_options());
    // Whatever a quad's weights are computed with, they must keep the cage's own relations.
    for (const CoordinateKind& kind : coordinate_kinds()) {
      if (!kind.is_sum() || !kind.keeps_quads || !cage->has_quads() || !exists(kind)) continue;
      for (const Evaluation& evaluation : other_evaluations(formula_of_kept_faces(kind, *cage))) {
        if (!is_evaluation_of(evaluation.name(), kind, *cage)) continue;
        // Integrals of layers take several times as long as those of weights: suites with time ask for them.
        const bool costly = evaluation.cost() >= CostClass::Adaptive && !kind.normalised;
        if (costly && options_.suite.has_time_limit) continue;
        CageCampaignOptions campaign = cage_options();
        campaign.evaluation = evaluation.name();
        campaign.kinds = kind.name;
        campaign.points = affordable_points(evaluation, campaign.points);
        campaign.one_per_place = evaluation.cost() >= CostClass::Adaptive && options_.suite.has_time_limit;
        campaign.properties_alone = true;
        add(cage_measurements(cage, campaign));
      }
    }
    // Other ways to prepare a kind that is no sum, against the recommended one, which promise nothing: a user's cage is
    // asked, and embedded ones by suites with time.
    for (const CoordinateKind& kind : coordinate_kinds())
      for (const std::string_view evaluation : kind.other_evaluations) {
        if (!exists(kind) || (!options_.cage && options_.suite.has_time_limit)) continue;
        CageCampaignOptions campaign = cage_options();
        campaign.evaluation = evaluation;
        campaign.kinds = kind.name;
        campaign.points = std::min(campaign.points, 40);
        campaign.differences = false;
        add(cage_measurements(cage, campaign));
      }
    if (asks_one_ring_of(*cage))
      for (const std::string& evaluation : {std::string(), OneRingOptions{}.evaluation})
        add(one_ring_measurement(
            cage, {.evaluation = evaluation, .triangulation = options_.triangulation, .seed = options_.seed}));
    if (is_shown(*cage)) add(outline_measurement(cage));
    bool left_out = false, quads_left_out = false;
    NamesByReason refused;
    for (const CoordinateKind& kind : coordinate_kinds()) {
      if (options_.cage && exists_on(kind, *cage) && !is_affordable(kind, *cage, cage_options()))
        plan_.header.notes.push_back(fmt::format(
            "{}: {} and its deformer, if it has one, are not judged, because solving takes its time on more "
            "than {} elements",
            cage->name(), kind.name, cage_options().solved_elements));
      if (!is_asked(kind, *cage)) continue;
      std::string reason = refusal_of(kind, *cage);
      if (reason.empty()) {
        if (is_shown(*cage)) add_fields(cage, kind);
        else left_out = true;
        quads_left_out = quads_left_out || (is_shown(*cage) && !shows_truth(kind, *cage));
      } else {
        plan_.header.notes.push_back(fmt::format("{}: no {} coordinates, {}", cage->name(), kind.name, reason));
        if (options_.cage) refused[std::move(reason)].push_back(kind.name);
      }
    }
    for (const auto& [reason, names] : refused)
      plan_.warnings.push_back(fmt::format("{}: no {} coordinates, {}", cage->name(), fmt::join(names, ", "), reason));
    if (left_out)
      plan_.header.notes.push_back(fmt::format("{}: its error fields are drawn by longer suites", cage->name()));
    if (quads_left_out)
      plan_.header.notes.push_back(
          fmt::format("{}: error fields of coordinates that keep its quads are drawn by longer suites", cage->name()));
  }

  // Whether a field shows a kind against its truth. Truths of quads take so long that suites in a hurry had six
  // points per side.
  bool shows_truth(const CoordinateKind& kind, const Cage& cage) const {
    return !options_.suite.has_time_limit || !kind.is_sum() || !kind.keeps_quads || !cage.has_quads();
  }

  // Fields show where errors sit, and promise nothing: those of larger embedded cages are for suites with time.
  bool is_shown(const Cage& cage) const {
    const std::size_t most = options_.suite.shown_elements;
    return options_.cage || most == 0 || cage.parts(false, options_.triangulation).elements.size() <= most;
  }

  void add_fields(const std::shared_ptr<const Cage>& cage, const CoordinateKind& kind) {
    const Triangulation rule = options_.triangulation;
    const int resolution = options_.suite.slice;
    const auto title = fmt::format("{}, {} coordinates", cage->name(), kind.name);
    FieldPart common;
    common.cage = outline_name(*cage);
    add(field_measurement(reproduction_field(cage, kind, "", rule, resolution), fields_++,
                          title + ": linear reproduction", "linear reproduction", common));
    if (!kind.is_sum()) return;  // no truth to compare with
    if (add_scene(cage, kind)) return;
    const auto elements = cage->parts(false, rule).elements.size();
    const double pairs = static_cast<double>(elements * kind.blocks.size()) * (kind.keeps_quads ? quad_cost : 1);
    const int side = std::clamp(static_cast<int>(std::sqrt(options_.suite.pairs / pairs)), 6, resolution);
    if (shows_truth(kind, *cage))
      add(field_measurement(coordinate_error_field(cage, kind, "", rule, side), fields_++,
                            title + ": closed form against truth", "relative error", common));
    if (!kind.keeps_quads || !cage->has_quads()) return;
    const auto scheme = EvaluationRegister::instance().with_role(formula_of_kept_faces(kind, *cage).name, Role::Scheme);
    if (!scheme || !is_evaluation_of(scheme->name(), kind, *cage)) return;
    add(field_measurement(coordinate_difference_field(cage, kind, scheme->name(), "", rule, resolution), fields_++,
                          fmt::format("{}: error of {}", title, scheme->name()), "difference", common));
  }

  // A verdict on one cage does not wait for a picture that promises nothing.
  int scene_pairs() const { return is_awaited() ? options_.suite.scene_pairs / 3 : options_.suite.scene_pairs; }

  // One scene a run, of the first kind that papers print and of the suite's cage, or the user's; all of them
  // in suites with time. It takes the place of a slice of the recommended evaluation's rounding noise.
  bool add_scene(const std::shared_ptr<const Cage>& cage, const CoordinateKind& kind) {
    const Suite& suite = options_.suite;
    const Comparison comparison{cage, &kind, telling_evaluations(kind, *cage), options_.triangulation};
    if (kind.keeps_quads || comparison.evaluations.size() < 3) return false;
    const bool all = suite.scene_cage.empty();
    if (!all && (scenes_ > 0 || !(options_.cage || cage->name() == suite.scene_cage))) return false;
    ++scenes_;
    const auto mesh = options_.mesh ? std::make_shared<const Mesh>(*options_.mesh) : nullptr;
    const auto elements = static_cast<double>(cage->parts(false, options_.triangulation).elements.size());
    const auto points = static_cast<std::size_t>(scene_pairs() / (elements * static_cast<double>(kind.blocks.size())));
    add(scene_measurements(comparison, affordable_side(comparison, scene_pairs(), suite.scene_side), mesh,
                           std::max<std::size_t>(100, points), fields_));
    fields_ += mesh ? 2 : 1;
    return true;
  }

  // [W12] Figure 3: the coordinates of a vertex and an edge themselves, for kinds from mean value to biharmonic.
  void add_figure_three() {
    struct Shown {
      std::string_view kind, label;
    };
    static constexpr std::array shown{Shown{"mean_value", "lambda"},         Shown{"harmonic", "lambda"},
                                      Shown{"biharmonic_boundary", "alpha"}, Shown{"biharmonic_goursat", "alpha"},
                                      Shown{"biharmonic_boundary", "beta"},  Shown{"biharmonic_goursat", "beta"}};
    constexpr int index = 3;  // the reentrant corner, and the edge from it
    const int side = std::max(options_.suite.slice, 48);
    const auto cage = std::make_shared<const Cage>(embedded_cage("l-shape"));
    FieldPart common;
    common.cage = outline_name(*cage);
    for (const Shown& one : shown) {
      const CoordinateKind* kind = find_coordinate_kind(one.kind);
      if (kind == nullptr || !is_asked(*kind, *cage)) continue;
      add(field_measurement(
          coordinate_field(cage, *kind, std::string(one.label), index, side), fields_++,
          fmt::format("{}, {} coordinates: {}_{} itself ([W12] Figure 3)", cage->name(), kind->name, one.label, index),
          fmt::format("{}_{}", one.label, index), common));
    }
  }

  // Promises hold for points outside as for others, so no row tells that they are there.
  void tell_points_outside(const Cage& cage, const std::vector<Vec3<double>>& points) {
    const WindingNumbers windings(CageElements(cage, false, options_.triangulation));
    std::vector<char> outside(points.size());
    for_each_parallel(points.size(), options_.jobs,
                      [&](std::size_t i) { outside[i] = windings.around(points[i]).value_or(1) == 0; });
    plan_.points_outside = static_cast<std::size_t>(std::ranges::count(outside, 1));
    if (plan_.points_outside == 0) return;
    plan_.warnings.push_back(fmt::format(
        "{} of {} points of {} are outside {}, the first of them number {} (from 0): promises are judged there by what "
        "coordinates are outside, where green, biharmonic and others that are not normalised sum to zero, and what is "
        "deformed with them collapses",
        plan_.points_outside, points.size(), options_.mesh_name, cage.name(),
        std::ranges::find(outside, 1) - outside.begin()));
    plan_.header.notes.push_back(plan_.warnings.back());
  }

  void add_mesh(const std::shared_ptr<const Cage>& cage) {
    const auto mesh = std::make_shared<const Mesh>(*options_.mesh);
    plan_.measurements.push_back(mesh_shape(mesh));
    for (const CoordinateKind& kind : coordinate_kinds())
      if (is_asked(kind, *cage) && refusal_of(kind, *cage).empty())
        add(mesh_measurement(cage, kind, mesh, options_.mesh_name, fields_++, cage_options()));
  }

  // Options are named as on the command line, where they have a name there.
  void set_header(std::size_t stored_cases) {
    const Suite& suite = options_.suite;
    const auto text = [](const auto& x) { return fmt::format("{}", x); };
    auto& header = plan_.header;
    header.version = CAGEPROOF_VERSION;
    header.options = {
        {"formulas", options_.formulas},
        {"evaluations", options_.evaluations},
        {"regimes", options_.regimes},
        {"suite", std::string(suite.name)},
        {"samples", text(suite.samples)},
        {"samples of a sweep", text(suite.swept_samples)},
        {"enclosures", text(suite.enclosures)},
        {"seed", text(options_.seed)},
        {"triangulate", std::string(name_of(options_.triangulation))},
        {"integral samples", text(suite.integral_samples)},
        {"points of a cage", text(suite.cage_points)},
        {"truths of a cage", text(suite.truth_points)},
        {"points on an embedded cage", text(suite.on_points)},
        {"block errors of a cage",
         fmt::format("{} points, {} ms a kind", block_points_of_run(), suite.block_milliseconds)},
        {"points of a mesh", text(suite.mesh_points)},
        {"fields",
         fmt::format("{} samples a side, {} truths, {} side by side{}", suite.slice, suite.pairs, scene_pairs(),
                     suite.shown_elements > 0
                         ? fmt::format(", of embedded cages with at most {} elements", suite.shown_elements)
                         : "")},
        {"cage", options_.cage ? options_.cage->name() : ""},
        {"points", options_.mesh ? options_.mesh_name : ""}};
    if (options_.cage) header.options[reports::cage_content_setting] = fingerprint_of(*options_.cage);
    if (options_.mesh) header.options["the points' content"] = fingerprint_of(*options_.mesh);
    // Another program may plan other work from the same options, even with the same version number.
    Fingerprint work;
    for (const Unit& unit : plan_.units)
      work.add(fmt::format("{} {}", plan_.measurements[unit.measurement]->name(), unit.block));
    work.add(stored_worst_cases());
    header.options[work_option] = fmt::format("{} units, {}", plan_.units.size(), work.text());
    header.settings = {
        {"triangulation", std::string(name_of(options_.triangulation))},
        {"samples", text(suite.samples)},
        {"samples of a sweep", text(suite.swept_samples)},
        {"integral samples", text(suite.integral_samples)},
        {"enclosures", text(suite.enclosures)},
        {"formulas", options_.formulas},
        {"evaluations", options_.evaluations},
        {"regimes", options_.regimes},
        {"stored worst cases", fmt::format("{}, replayed in the rows of the regime 'hunted'", stored_cases)}};
    if (options_.cage) header.settings["cage"] = options_.cage->name();
    if (options_.mesh) header.settings["points"] = options_.mesh_name;
    if (plan_.points_outside > 0)
      header.settings[reports::points_outside_setting] =
          fmt::format("{} of {}", plan_.points_outside, options_.mesh->vertices.size());
    if (!regimes_nowhere_.empty()) header.settings[reports::regimes_nowhere_setting] = regimes_nowhere_;
    if (options_.only_cage) {
      header.options["scope"] = "cage";
      header.settings["scope"] = "the cage only; `--formulas '*'` asks for formulas on single elements too";
      header.settings.erase("stored worst cases");
    }
    header.units = plan_.units.size();
    header.shard = options_.shard;
    header.shards = options_.shards;
  }

  const VerifyOptions& options_;
  // After one edit of a formula somebody waits for its verdict. Its own regimes judge it; a cage shows that sums use
  // it.
  const bool one_cage_each_;
  RunPlan plan_;
  mutable std::map<std::pair<std::string_view, std::string_view>, std::string> smallest_cages_;  // by kind and formula
  int fields_ = 0;
  // Reasons by cage and kind; empty where there is none.
  std::map<std::pair<std::string, std::string_view>, std::string> refusals_;
  int scenes_ = 0;
  std::string regimes_nowhere_;
};

}  // namespace

RunPlan plan_run(const VerifyOptions& options) { return Planner(options).plan(); }

}  // namespace cageproof::validation
