// SPDX-License-Identifier: MIT
#include "cageproof/validation/cage_campaign.h"

#include "cages/cage_questions.h"

#include "cageproof/core/coordinates/whole_evaluation.h"
#include "cageproof/core/input_error.h"
#include "cageproof/core/lazy.h"
#include "cageproof/core/catalogue/name_pattern.h"
#include "promises/verdicts.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <optional>
#include <set>

namespace cageproof::validation {
namespace {

// Kinds that the cage's quads rule out are left out; verify says so.
std::vector<const CoordinateKind*> kinds_matching(const CageCampaignOptions& options, const Cage& cage) {
  std::vector<const CoordinateKind*> found;
  for (const CoordinateKind& kind : coordinate_kinds())
    if (matches(options.kinds, kind.name) && is_affordable(kind, cage, options) && accepts(kind, cage))
      found.push_back(&kind);
  if (found.empty())
    throw InputError(fmt::format("no kind of coordinates matches '{}' and accepts {}", options.kinds, cage.name()));
  return found;
}

// Every n-th of each place, and of those that lie on the cage to the last bit, so that about so many are left, and one
// of each.
void keep_evenly(std::vector<CagePoint>& points, const CageElements& elements, int most) {
  std::vector<std::pair<Place, bool>> groups;
  groups.reserve(points.size());
  std::map<std::pair<Place, bool>, std::size_t> counts, seen;
  for (const CagePoint& p : points) ++counts[groups.emplace_back(p.place, !elements.touching(p.point).empty())];
  const std::size_t share = std::max<std::size_t>(1, most / counts.size());
  std::size_t kept = 0;
  for (std::size_t i = 0; i < points.size(); ++i)
    if (seen[groups[i]]++ % ((counts[groups[i]] + share - 1) / share) == 0) points[kept++] = points[i];
  points.resize(kept);
}

void keep_first_of_each_place(std::vector<CagePoint>& points) {
  std::set<Place> seen;
  std::erase_if(points, [&](const CagePoint& p) { return !seen.insert(p.place).second; });
}

// The relations of one kind of coordinates, by one evaluation, on a cage.
class CageMeasurement final : public Measurement {
 public:
  CageMeasurement(std::shared_ptr<const Cage> cage, const CoordinateKind& kind, const CageCampaignOptions& options)
      : cage_(std::move(cage)), kind_(kind), options_(options), setup_([this] { return set_up(); }) {}

  std::string name() const override {
    const std::string& evaluation = options_.evaluation;
    return fmt::format("{}, {}{}{}", cage_->name(), kind_.name, evaluation.empty() ? "" : ", ", evaluation);
  }

  int blocks() const override {
    std::size_t on = options_.properties_alone ? 0 : cage_->vertices().size() + 3 * cage_->faces().size();
    if (options_.on_points > 0) on = std::min<std::size_t>(on, options_.on_points);
    return block_count(options_.points + on / 4, 10);
  }

  std::vector<RowKey> rows() const override {
    std::vector<RowKey> rows;
    for (const auto& [place, questions] : setup_.get().questions) {
      const bool off = place == Place::Inside || place == Place::Outside;
      if (place == Place::Outside && kind_.inside_alone) continue;
      for (const CageQuestion& question : questions)
        if (off ? asks(question.cost) : question.once || !options_.properties_alone) add_rows_of(question, rows);
    }
    return rows;
  }

  PartialResult measure(int block) const override {
    const Setup& setup = setup_.get();
    PartialResult gathered;
    // By turns, so that each block has its share of the points that cost most.
    for (std::size_t i = block; i < setup.off.size(); i += blocks()) {
      const CagePoint& p = setup.off[i];
      if (p.place == Place::TooClose) continue;
      const CageAt at(*setup.subject, p.point, p.index, name_of(p.place), setup.order);
      for (const CageQuestion& question : setup.questions.at(p.place))
        if (takes(setup, question.cost, i)) record(question, at, gathered.rows);
    }
    if (block == 0)
      for (const CageQuestion& question : setup.questions.at(Place::OnFace))
        if (question.once)
          record(question, {*setup.subject, cage_->vertices().front(), 0, question.key.place, 0, true}, gathered.rows);
    for (std::size_t i = block; i < setup.on.size(); i += blocks()) {
      const CagePoint& p = setup.on[i];
      const CageAt at(*setup.subject, p.point, p.index, name_of(p.place), 0, p.exact);
      for (const CageQuestion& question : setup.questions.at(p.place))
        if (!question.once) record(question, at, gathered.rows);
    }
    return gathered;
  }

 private:
  struct Setup {
    std::shared_ptr<const CageSubject> subject;
    std::vector<CagePoint> off, on;
    int order = 0;
    std::size_t stride = 1;
    std::vector<std::size_t> compared;  // points off the cage that meet the truth
    std::vector<std::size_t> routed;    // and that second routes are asked at
    std::map<Place, std::vector<CageQuestion>> questions;
  };

  Setup set_up() const {
    const CageCampaignOptions& o = options_;
    Setup setup;
    setup.subject = std::make_shared<const CageSubject>(cage_, kind_, o.evaluation, o.triangulation);
    const CageCoordinates& coordinates = setup.subject->coordinates();
    setup.off = points_off(*cage_, setup.subject->locator(), o.seed, o.points);
    if (o.one_per_place) keep_first_of_each_place(setup.off);
    if (kind_.inside_alone) std::erase_if(setup.off, [](const CagePoint& p) { return p.place == Place::Outside; });
    if (!o.properties_alone) {
      setup.on = points_on(coordinates, *cage_);
      if (o.on_points > 0) keep_evenly(setup.on, coordinates.elements(), o.on_points);
      setup.order = coordinates.max_order();
    }
    // Every n-th point meets the truth, so that both ways of drawing points are seen.
    // Matrices of nine numbers in multiprecision cost as much as a quarter of the points does for single ones.
    const int truth_points = coordinates.blocks()[0].entries() == 1 ? o.truth_points : (o.truth_points + 3) / 4;
    setup.stride = std::max<std::size_t>(1, setup.off.size() / std::max(1, truth_points)) | 1;
    for (std::size_t i = 0; i < setup.off.size(); i += setup.stride) setup.compared.push_back(i);
    // Cages are used inside, where a thin one has few points.
    const auto is_inside = [&](std::size_t i) { return setup.off[i].place == Place::Inside; };
    if (std::ranges::none_of(setup.compared, is_inside))
      if (const auto first = std::ranges::find(setup.off, Place::Inside, &CagePoint::place); first != setup.off.end())
        setup.compared.push_back(first - setup.off.begin());
    // Second routes are the same code everywhere: one point per place says whether they agree, and on larger cages only
    // one inside.
    constexpr std::size_t many_faces = 20;
    for (const Place place : {Place::Inside, Place::Outside}) {
      if (place == Place::Outside && cage_->faces().size() > many_faces) continue;
      const auto first = std::ranges::find(setup.off, place, &CagePoint::place);
      if (first != setup.off.end()) setup.routed.push_back(first - setup.off.begin());
    }
    for (const Place place : {Place::Inside, Place::Outside, Place::OnFace, Place::OnEdge, Place::OnVertex}) {
      std::vector<CageQuestion>& questions = setup.questions[place];
      questions = cage_questions(*setup.subject, name_of(place), order_at(name_of(place), coordinates, setup.order));
    }
    return setup;
  }

  // Whether questions of that cost are asked off the cage.
  bool asks(CageQuestion::Cost cost) const {
    if (cost == CageQuestion::Cost::Sign) return options_.signs;
    if (options_.properties_alone) return cost == CageQuestion::Cost::Relation;
    return cost != CageQuestion::Cost::Differences || options_.differences;
  }

  // And at which points.
  bool takes(const Setup& setup, CageQuestion::Cost cost, std::size_t i) const {
    if (!asks(cost)) return false;
    if (cost == CageQuestion::Cost::SecondRoute) return std::ranges::find(setup.routed, i) != setup.routed.end();
    if (cost == CageQuestion::Cost::Truth) return std::ranges::find(setup.compared, i) != setup.compared.end();
    // Differences take three sums in 100 digits, so only a quarter of these points are asked.
    return cost != CageQuestion::Cost::Differences || i % (4 * setup.stride) == 0;
  }

  std::shared_ptr<const Cage> cage_;
  const CoordinateKind& kind_;
  CageCampaignOptions options_;
  Lazy<Setup> setup_;
};

// Vertices and faces, which fields on the mesh share.
class MeshShape final : public Measurement {
 public:
  explicit MeshShape(std::shared_ptr<const Mesh> mesh) : mesh_(std::move(mesh)) {}
  std::string name() const override { return "the mesh itself"; }
  int blocks() const override { return 1; }
  PartialResult measure(int) const override {
    PartialResult gathered;
    gathered.meshes[mesh_measured] = {mesh_measured, mesh_->vertices, mesh_->faces, {}};
    return gathered;
  }

 private:
  std::shared_ptr<const Mesh> mesh_;
};

// Partition of unity and linear reproduction at a mesh's points, kept by point; as users of meshes compute them.
class MeshMeasurement final : public Measurement {
 public:
  MeshMeasurement(std::shared_ptr<const Cage> cage, const CoordinateKind& kind, std::shared_ptr<const Mesh> mesh,
                  const std::string& mesh_name, int place, const CageCampaignOptions& options)
      : cage_(std::move(cage)), kind_(kind), mesh_(std::move(mesh)), place_(place), options_(options), subject_([this] {
          return std::make_shared<const CageSubject>(
              cage_, kind_, options_.evaluation.empty() ? std::string(quickest) : options_.evaluation,
              options_.triangulation);
        }) {
    if (options.mesh_points > 0)
      stride_ = std::max<std::size_t>(1, (mesh_->vertices.size() + options.mesh_points - 1) / options.mesh_points);
    empty_.title = fmt::format("{} in {}, {} coordinates: linear reproduction", mesh_name, cage_->name(), kind.name);
    empty_.shown = fmt::format("{}: linear reproduction", kind.name);
    empty_.mesh = mesh_measured;
    empty_.samples = mesh_->vertices.size();
    empty_.image.name = fmt::format("mesh.{}", kind.name);
    empty_.image.arrays = {{fmt::format("{}: partition of unity", kind.name), "1", 1, {}},
                           {empty_.shown, "cage sizes", 1, {}}};
  }

  std::string name() const override { return fmt::format("mesh in {}, {}", cage_->name(), kind_.name); }
  int blocks() const override { return block_count(mesh_->vertices.size(), 500); }

  std::vector<RowKey> rows() const override {
    std::vector<RowKey> rows;
    for (const CageQuestion& question : cage_questions(*subject_.get(), mesh_place, 0)) add_rows_of(question, rows);
    return rows;
  }

  PartialResult measure(int block) const override {
    const CageSubject& subject = *subject_.get();
    const std::vector<CageQuestion> questions = cage_questions(subject, mesh_place, 0);
    PartialResult gathered;
    FieldPart part = empty_;
    part.first = block_begin(part.samples, block, blocks());
    for (std::size_t i = part.first; i < block_begin(part.samples, block + 1, blocks()); ++i) {
      if (i % stride_ != 0) {
        for (auto& array : part.image.arrays) array.values.push_back(NAN);
        continue;
      }
      const CageAt at(subject, mesh_->vertices[i], i, mesh_place, 0);
      for (const CageQuestion& question : questions) record(question, at, gathered.rows);
      part.image.arrays[0].values.push_back(at.errors().partition[0].relative);
      part.image.arrays[1].values.push_back(at.errors().reproduction[0].relative);
    }
    gathered.fields.emplace(std::pair(place_, part.first), std::move(part));
    return gathered;
  }

 private:
  std::shared_ptr<const Cage> cage_;
  const CoordinateKind& kind_;
  std::shared_ptr<const Mesh> mesh_;
  int place_;
  CageCampaignOptions options_;
  FieldPart empty_;
  std::size_t stride_ = 1;  // takes every n-th point, so that what is measured is spread evenly
  Lazy<std::shared_ptr<const CageSubject>> subject_;
};

}  // namespace

bool is_affordable(const CoordinateKind& kind, const Cage& cage, const CageCampaignOptions& options) {
  // Kinds that meet a polygon's data refuse by themselves what is too large.
  if (!kind.solves_on_samples || (kind.meets_boundary_data && cage.dimension() == 2)) return true;
  return static_cast<int>(cage.parts(false, options.triangulation).elements.size()) <= options.solved_elements;
}

Measurements cage_measurements(const std::shared_ptr<const Cage>& cage, const CageCampaignOptions& options) {
  Measurements measurements;
  for (const CoordinateKind* kind : kinds_matching(options, *cage))
    measurements.push_back(std::make_unique<CageMeasurement>(cage, *kind, options));
  return measurements;
}

std::unique_ptr<const Measurement> mesh_shape(std::shared_ptr<const Mesh> mesh) {
  return std::make_unique<MeshShape>(std::move(mesh));
}

std::unique_ptr<const Measurement> mesh_measurement(std::shared_ptr<const Cage> cage, const CoordinateKind& kind,
                                                    std::shared_ptr<const Mesh> mesh, const std::string& mesh_name,
                                                    int place, const CageCampaignOptions& options) {
  return std::make_unique<MeshMeasurement>(std::move(cage), kind, std::move(mesh), mesh_name, place, options);
}

std::vector<ResultRow> run_cage_campaign(const Cage& cage, const CageCampaignOptions& options) {
  return judged(measure_all(cage_measurements(std::make_shared<const Cage>(cage), options), options.jobs).rows).rows;
}

}  // namespace cageproof::validation
