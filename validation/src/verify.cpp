// SPDX-License-Identifier: MIT
#include "cageproof/validation/verify.h"

#include "hull_continuity.h"

#include "cageproof/core/embedded_cages.h"
#include "cageproof/reports/report_writer.h"
#include "cageproof/validation/cage_campaign.h"
#include "cageproof/validation/campaign.h"
#include "cageproof/validation/errata.h"
#include "cageproof/validation/error_fields.h"
#include "cageproof/validation/one_ring.h"
#include "cageproof/validation/promise.h"
#include "cageproof/validation/stored_cases.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>

namespace cageproof::validation {
namespace {

using reports::ColourScale;

// A quad's integral in multiprecision costs as much as that many triangles'.
constexpr double quad_cost = 30;

// At how many points of a cage a kind's other evaluations are asked for its relations: integrals take their time.
int affordable_points(std::string_view evaluation, int points) {
  const int most = evaluation == "multiprecision" ? 4 : evaluation == "adaptive" ? 20 : evaluation.starts_with("gauss-") ? 40 : points;
  return std::min(points, most);
}

// Every standard evaluation of a formula but the closed form.
std::vector<std::string> other_evaluations(std::string_view formula) {
  std::vector<std::string> names;
  for (const EvaluationFamily* family : EvaluationRegister::instance().families(formula)) {
    if (family->pattern == "closed_form") continue;
    if (family->standard.empty()) names.push_back(family->pattern);
    names.insert(names.end(), family->standard.begin(), family->standard.end());
  }
  return names;
}

class Run {
 public:
  explicit Run(const VerifyOptions& options) : options_(options), writer_(options.out) {
    result_.version = CAGEPROOF_VERSION;
    result_.suite = options.suite.name;
    result_.seed = options.seed;
    result_.command_line = options.command_line;
    result_.machine = machine_facts();
    result_.started = timestamp();
    result_.settings = {{"triangulation", std::string(name_of(options.triangulation))},
                        {"samples", fmt::format("{}", options.suite.samples)},
                        {"integral samples", fmt::format("{}", options.suite.integral_samples)},
                        {"enclosures", fmt::format("{}", options.suite.enclosures)},
                        {"formulas", options.formulas},
                        {"evaluations", options.evaluations},
                        {"regimes", options.regimes}};
    if (options.cage) result_.settings["cage"] = options.cage->name();
    if (options.mesh) result_.settings["points"] = options.mesh_name;
  }

  RunResult go() {
    const auto start = std::chrono::steady_clock::now();
    // First, since a stored case that can no longer be run ends the run.
    const std::vector<ResultRow> stored = stored_cases();
    if (options_.regimes != hull_regime) elements();
    result_.rows.insert(result_.rows.end(), stored.begin(), stored.end());
    if (matches(options_.formulas, "quad.mean_value") && matches(options_.regimes, hull_regime)) {
      const auto jumps = run_hull_continuity(options_.evaluations, options_.seed);
      result_.rows.insert(result_.rows.end(), jumps.begin(), jumps.end());
    }
    if (options_.cage) {
      cage(*options_.cage);
      if (options_.mesh) mesh(*options_.cage);
    } else {
      for (const auto name : embedded_cage_names()) cage(embedded_cage(name));
    }
    say("errata", 0, 1);
    result_.errata = measure_errata({.formulas = options_.formulas, .seed = options_.seed});
    say("report", 0, 1);
    result_.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    writer_.write(result_);
    writer_.commit();
    say("report", 1, 1);
    return result_;
  }

 private:
  void say(const std::string& stage, std::size_t done, std::size_t all) const {
    if (options_.progress) options_.progress(stage, done, all);
  }

  std::vector<ResultRow> stored_cases() {
    say("stored worst cases", 0, 1);
    auto rows = replay_stored(stored_worst_cases(), stored_cases_file, options_.formulas, options_.evaluations, options_.jobs);
    std::uint64_t cases = 0;
    for (const ResultRow& row : rows) cases += row.samples + row.without_truth;
    result_.settings["stored worst cases"] = fmt::format("{}, replayed in the rows of the regime 'hunted'", cases);
    say("stored worst cases", 1, 1);
    return rows;
  }

  void elements() {
    CampaignOptions campaign;
    campaign.formulas = options_.formulas;
    campaign.evaluations = options_.evaluations;
    campaign.regimes = options_.regimes;
    campaign.seed = options_.seed;
    campaign.samples = options_.suite.samples;
    campaign.integral_samples = options_.suite.integral_samples;
    campaign.enclosures = options_.suite.enclosures;
    campaign.jobs = options_.jobs;
    campaign.progress = [&](std::size_t done, std::size_t all) { say("elements", done, all); };
    CampaignResult found = run_campaign(campaign);
    result_.rows = std::move(found.rows);
    result_.curves = std::move(found.curves);
    result_.notes = std::move(found.notes);
  }

  CageCampaignOptions cage_options() const {
    CageCampaignOptions campaign;
    campaign.triangulation = options_.triangulation;
    campaign.seed = options_.seed;
    campaign.points = options_.suite.cage_points;
    campaign.truth_points = options_.suite.truth_points;
    campaign.jobs = options_.jobs;
    return campaign;
  }

  void cage(const Cage& cage) {
    say("cage " + cage.name(), 0, 1);
    auto rows = run_cage_campaign(cage, cage_options());
    result_.rows.insert(result_.rows.end(), rows.begin(), rows.end());
    // Whatever a quad's weights are computed with, they must keep the cage's own relations.
    for (const CoordinateKind& kind : coordinate_kinds()) {
      if (kind.direct || !kind.keeps_quads() || !cage.has_quads() || !accepts(kind, cage)) continue;
      for (const std::string& evaluation : other_evaluations(kind.blocks.front().quad_formula)) {
        CageCampaignOptions campaign = cage_options();
        campaign.evaluation = evaluation;
        campaign.kinds = kind.name;
        campaign.points = affordable_points(evaluation, campaign.points);
        campaign.properties_alone = true;
        rows = run_cage_campaign(cage, campaign);
        result_.rows.insert(result_.rows.end(), rows.begin(), rows.end());
      }
    }
    for (const char* evaluation : {"closed_form", "curl-form"}) {
      rows = run_one_ring_check(
          cage, {.evaluation = evaluation, .triangulation = options_.triangulation, .seed = options_.seed});
      result_.rows.insert(result_.rows.end(), rows.begin(), rows.end());
    }
    for (const CoordinateKind& kind : coordinate_kinds()) {
      if (!accepts(kind, cage)) {
        result_.notes.push_back(fmt::format("{}: no {} coordinates, {}", cage.name(), kind.name, invalid_quads(cage).front()));
        continue;
      }
      const auto title = fmt::format("{}, {} coordinates", cage.name(), kind.name);
      add(writer_.write_image(reproduction_field(cage, kind, "closed_form", options_.triangulation,
                                                 options_.suite.slice, options_.jobs),
                              title + ": linear reproduction", "linear reproduction", ColourScale::Log10));
      if (kind.direct) continue;  // no truth to compare with
      const auto triangles = cage.triangulate(options_.triangulation).triangles.size();
      const double pairs = static_cast<double>(triangles * kind.blocks.size()) * (kind.keeps_quads() ? quad_cost : 1);
      const int side = std::clamp(static_cast<int>(std::sqrt(options_.suite.pairs / pairs)), 12, options_.suite.slice);
      add(writer_.write_image(
          coordinate_error_field(cage, kind, "closed_form", options_.triangulation, side, options_.jobs),
          title + ": closed form against truth", "relative error", ColourScale::Log10));
      if (!kind.keeps_quads() || !cage.has_quads()) continue;
      add(writer_.write_image(
          coordinate_difference_field(cage, kind, "riemann-4", "closed_form", options_.triangulation, options_.suite.slice, options_.jobs),
          title + ": error of riemann-4", "difference", ColourScale::Log10));
    }
    say("cage " + cage.name(), 1, 1);
  }

  void mesh(const Cage& cage) {
    say("mesh " + options_.mesh_name, 0, 1);
    MeshErrors errors = run_mesh_campaign(cage, options_.mesh->vertices, cage_options());
    result_.rows.insert(result_.rows.end(), errors.rows.begin(), errors.rows.end());
    errors.field.name = "mesh";
    errors.field.faces = options_.mesh->faces;
    for (const CoordinateKind& kind : coordinate_kinds()) {
      if (!accepts(kind, cage)) continue;
      MeshField field = errors.field;
      field.name = fmt::format("mesh.{}", kind.name);
      std::erase_if(field.arrays, [&](const auto& a) { return !a.name.starts_with(fmt::format("{}:", kind.name)); });
      add(writer_.write_mesh(field, fmt::format("{} in {}, {} coordinates: linear reproduction", options_.mesh_name, cage.name(), kind.name),
                             fmt::format("{}: linear reproduction", kind.name), ColourScale::Log10));
    }
    say("mesh " + options_.mesh_name, 1, 1);
  }

  void add(FieldEntry entry) { result_.fields.push_back(std::move(entry)); }

  const VerifyOptions& options_;
  reports::ReportWriter writer_;
  RunResult result_;
};

}  // namespace

const std::vector<Suite>& suites() {
  static const std::vector<Suite> all{
      {"quick", 96, 2, 1, 60, 4, 40, 4000},
      {"standard", 400, 4, 3, 240, 8, 120, 40000},
      {"full", 100000, 32, 1000, 4000, 64, 240, 400000},
  };
  return all;
}

RunResult verify(const VerifyOptions& options) { return Run(options).go(); }

}  // namespace cageproof::validation
