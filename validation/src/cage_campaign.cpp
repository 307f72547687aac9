// SPDX-License-Identifier: MIT
#include "cageproof/validation/cage_campaign.h"

#include "cageproof/core/whole_evaluation.h"
#include "cageproof/core/input_error.h"
#include "cageproof/core/random_stream.h"
#include "cageproof/validation/cage_symmetries.h"
#include "cageproof/core/lazy.h"
#include "cageproof/validation/promise.h"
#include "cageproof/validation/scheme_errors.h"
#include "cageproof/validation/verdicts.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <optional>

namespace cageproof::validation {
namespace {

// The tallies of one kind and evaluation on one cage.
class CageRows {
 public:
  CageRows(const Cage& cage, const CageCoordinates& coordinates) {
    key_.section = RowKey::Section::Cage;
    key_.subject = coordinates.kind().name;
    key_.evaluation = coordinates.evaluation();
    key_.scalar = "double";
    key_.regime = cage.name();
  }

  /// A NaN is a sample without truth where that is excused, and else one whose figure was lost.
  /// \param asked the highest derivative that the coordinates were taken with
  void add(const std::string& check, std::string_view place, int order, const CageError& error, bool excused,
           const Vec3<double>& point, std::uint64_t index, int asked = 2) {
    add(check, "roundings", place, order, error.roundings, error.relative, excused, point, index, asked);
  }
  void add_relative(const std::string& check, std::string_view place, int order, double error, bool excused,
                    const Vec3<double>& point, std::uint64_t index, int asked = 2) {
    add(check, "relative", place, order, error, error, excused, point, index, asked);
  }

  Findings found;

 private:
  void add(const std::string& check, const std::string& unit, std::string_view place, int order, double error,
           double relative, bool excused, const Vec3<double>& point, std::uint64_t index, int asked) {
    key_.check = check;
    key_.place = place;
    key_.order = order;
    Tally& tally = found.rows[key_];
    tally.unit = unit;
    ++tally.asked;
    if (std::isnan(error)) ++(excused ? tally.without_truth : tally.unreached);
    else tally.add(error, relative, index, [&](double e) { return WorstCase{e, 0, index, {}, point, {}, asked}; });
  }

  RowKey key_;
};

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

// Errors at one point, of what was asked there: NaN where the point has no coordinates, which may be excused.
struct PointResult {
  CageErrors errors;
  std::optional<std::array<CageError, 3>> truth;
  std::optional<std::array<double, 3>> differences, scheme;
  std::map<std::string, CageError> symmetries;
  bool with_laplacian = false;
  bool excused = false;
};

// Whether the trace of any block's Hessian is known.
bool has_laplacian(const CageCoordinates& coordinates) {
  return std::ranges::any_of(coordinates.blocks(), [](const CoordinateBlock& block) {
    return block.trace.kind != CoordinateBlock::Trace::Kind::Unknown;
  });
}

void add_point(CageRows& rows, const CoordinateKind& kind, int order, const CagePoint& p, const PointResult& r) {
  const auto place = name_of(p.place);
  const bool outside = p.place == Place::Outside && !kind.normalised;
  for (int o = 0; o <= order; ++o) {
    rows.add(outside ? "zero_outside" : "partition_of_unity", place, o, r.errors.partition[o], r.excused, p.point,
             p.index, order);
    rows.add("linear_reproduction", place, o, r.errors.reproduction[o], r.excused, p.point, p.index, order);
    if (r.truth) rows.add("cage_truth", place, o, (*r.truth)[o], r.excused, p.point, p.index);
  }
  for (const auto& [check, error] : r.symmetries) rows.add(check, place, 0, error, r.excused, p.point, p.index);
  for (int o = 1; o < 3 && r.differences; ++o)
    rows.add_relative("cage_differences", place, o, (*r.differences)[o], r.excused, p.point, p.index);
  for (int o = 0; o <= order && r.scheme; ++o)
    rows.add_relative("scheme_error", place, o, (*r.scheme)[o], r.excused, p.point, p.index);
  if (r.with_laplacian) rows.add("cage_laplacian", place, 2, r.errors.laplacian, r.excused, p.point, p.index);
}

void add_on_cage(CageRows& rows, const Cage& cage, const CageCoordinates& coordinates, const CageLocator& locator,
                 const CageTerms& terms, const CagePoint& p) {
  const auto place = name_of(p.place);
  // Midpoints that rounding moved off the cage prove nothing about it; those that are exact lie on it.
  const bool on = !coordinates.elements().touching(p.point).empty();
  if (!coordinates.kind().normalised) {
    const CageTerms* known = coordinates.kind().is_sum() ? nullptr : &terms;
    rows.add("linear_reproduction", place, 0,
             on ? errors_at(coordinates, cage, p.point, 1, 0, known).reproduction[0] : CageError(), !p.exact, p.point,
             p.index);
  }
  if (coordinates.kind().meets_boundary_data)
    if (const auto missed = boundary_data_errors_at(coordinates, cage, p.point))
      for (int o = 0; o < 2; ++o)
        if ((*missed)[o]) rows.add_relative("boundary_data", place, o, *(*missed)[o], false, p.point, p.index);
  const int order = p.place == Place::OnFace && !coordinates.kind().normalised ? coordinates.max_order() : 0;
  const auto errors = inside_limit_errors_at(coordinates, cage, locator, p.point, order);
  for (int o = 0; o <= order; ++o)
    if (errors[o]) rows.add_relative("limit_from_inside", place, o, *errors[o], !p.exact, p.point, p.index);
}

void add_boundary(CageRows& rows, const Cage& cage, const CageCoordinates& coordinates) {
  const std::array<std::optional<double>, 2> residuals = boundary_residuals(coordinates);
  for (int o = 0; o < 2; ++o)
    if (residuals[o])
      rows.add_relative("boundary_residual", "on-face", o, *residuals[o], false, cage.vertices().front(), 0);
}

// Every n-th, so that at most so many are left.
void keep_evenly(std::vector<CagePoint>& points, int most) {
  const std::size_t step = std::max<std::size_t>(1, (points.size() + most - 1) / most);
  std::size_t kept = 0;
  for (std::size_t i = 0; i < points.size(); i += step) points[kept++] = points[i];
  points.resize(kept);
}

// The relations of one kind of coordinates, by one evaluation, on a cage.
class CageMeasurement final : public Measurement {
 public:
  CageMeasurement(std::shared_ptr<const Cage> cage, const CoordinateKind& kind, const CageCampaignOptions& options)
      : cage_(std::move(cage)), kind_(kind), options_(options), setup_([this] { return set_up(); }) {}

  std::string name() const override {
    return fmt::format("{}, {}, {}", cage_->name(), kind_.name, options_.evaluation);
  }

  int blocks() const override {
    std::size_t on = options_.properties_alone ? 0 : cage_->vertices().size() + 3 * cage_->faces().size();
    if (options_.on_points > 0) on = std::min<std::size_t>(on, options_.on_points);
    return block_count(options_.points + on / 4, 10);
  }

  Findings measure(int block) const override {
    const Setup& setup = setup_.get();
    CageRows rows(*cage_, setup.coordinates);
    // By turns, so that each block has its share of the points that cost most.
    for (std::size_t i = block; i < setup.off.size(); i += blocks()) {
      const CagePoint& p = setup.off[i];
      if (p.place != Place::TooClose) add_point(rows, kind_, setup.order, p, measured(setup, i));
    }
    if (block == 0) add_boundary(rows, *cage_, setup.coordinates);
    for (std::size_t i = block; i < setup.on.size(); i += blocks())
      add_on_cage(rows, *cage_, setup.coordinates, setup.locator, setup.terms, setup.on[i]);
    return std::move(rows.found);
  }

 private:
  struct Setup {
    CageLocator locator;
    CageCoordinates coordinates;
    CageTerms terms;
    std::vector<CagePoint> off, on;
    int order;
    std::size_t stride;
    std::optional<CageCoordinates> prior;  // of kinds that points may lack
    // Where more than properties is asked.
    std::optional<CageCoordinates> reference;
    std::optional<CageSymmetries> symmetries;
    std::optional<CageCoordinates> approximated;  // what the kind's scheme is to come near
  };

  Setup set_up() const {
    const CageCampaignOptions& o = options_;
    // Prepared once: some kinds solve large systems.
    const CageCoordinates recommended(*cage_, kind_, CoordinateOptions{.triangulation = o.triangulation});
    Setup setup{{*cage_, o.triangulation, kind_.keeps_quads},
                o.evaluation.empty() ? recommended : CageCoordinates(*cage_, kind_, o.evaluation, o.triangulation),
                {*cage_, recommended, o.evaluation},
                {},
                {},
                0,
                1,
                prior_of(*cage_, kind_, o.triangulation),
                {},
                {},
                {}};
    setup.off = points_off(*cage_, setup.locator, o.seed, o.points);
    if (kind_.inside_alone) std::erase_if(setup.off, [](const CagePoint& p) { return p.place == Place::Outside; });
    if (o.properties_alone) return setup;
    setup.on = points_on(setup.coordinates, *cage_);
    if (o.on_points > 0) keep_evenly(setup.on, o.on_points);
    setup.order = setup.coordinates.max_order();
    // Every n-th point meets the truth, so that both ways of drawing points are seen.
    // Matrices of nine numbers in multiprecision cost as much as a quarter of the points does for single ones.
    const int truth_points = setup.coordinates.blocks()[0].entries() == 1 ? o.truth_points : (o.truth_points + 3) / 4;
    setup.stride = std::max<std::size_t>(1, setup.off.size() / std::max(1, truth_points)) | 1;
    setup.reference.emplace(recommended);
    setup.symmetries.emplace(*cage_, o.evaluation, setup.coordinates, setup.terms);
    setup.approximated = approximated_by(*cage_, kind_, o.triangulation);
    return setup;
  }

  PointResult measured(const Setup& setup, std::size_t i) const {
    const CagePoint& p = setup.off[i];
    PointResult result;
    result.errors = errors_at(setup.coordinates, *cage_, p.point, expected_sum(kind_, setup.locator, p.point),
                              setup.order, &setup.terms);
    result.excused = may_be_missing(setup.prior, p.point);
    result.with_laplacian = setup.order == 2 && has_laplacian(setup.coordinates);
    if (setup.approximated && p.place == Place::Inside)
      result.scheme = scheme_errors_at(setup.coordinates, *setup.approximated, *cage_, p.point, setup.order);
    if (options_.properties_alone || i % setup.stride != 0) return result;
    // Coordinates that exist in double alone would meet themselves.
    if (setup.reference->is_exact_in(ScalarKind::Digits50) && setup.reference->is_prompt_in(ScalarKind::Digits50))
      result.truth = truth_errors_at(setup.coordinates, *setup.reference, p.point, setup.order, &setup.terms);
    result.symmetries = setup.symmetries->errors_at(p.point);
    // Seven sums in 100 digits: a quarter of these points.
    if (options_.differences && i / setup.stride % 4 == 0 && setup.order == 2 &&
        setup.coordinates.is_prompt_in(ScalarKind::Digits100))
      result.differences = setup.symmetries->differences_at(p.point);
    return result;
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
  Findings measure(int) const override {
    Findings findings;
    findings.meshes[mesh_measured] = {mesh_measured, mesh_->vertices, mesh_->faces, {}};
    return findings;
  }

 private:
  std::shared_ptr<const Mesh> mesh_;
};

// Partition of unity and linear reproduction at a mesh's points, kept by point; as users of meshes compute them.
class MeshMeasurement final : public Measurement {
 public:
  MeshMeasurement(std::shared_ptr<const Cage> cage, const CoordinateKind& kind, std::shared_ptr<const Mesh> mesh,
                  const std::string& mesh_name, int place, const CageCampaignOptions& options)
      : cage_(std::move(cage)), kind_(kind), mesh_(std::move(mesh)), place_(place), options_(options), setup_([this] {
          return Setup{{*cage_, options_.triangulation, kind_.keeps_quads},
                       {*cage_, kind_, options_.evaluation.empty() ? std::string(quickest) : options_.evaluation,
                        options_.triangulation},
                       prior_of(*cage_, kind_, options_.triangulation),
                       {*cage_, kind_, options_.triangulation}};
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

  Findings measure(int block) const override {
    const Setup& setup = setup_.get();
    CageRows rows(*cage_, setup.coordinates);
    FieldPart part = empty_;
    part.first = block_begin(part.samples, block, blocks());
    for (std::size_t i = part.first; i < block_begin(part.samples, block + 1, blocks()); ++i) {
      if (i % stride_ != 0) {
        for (auto& array : part.image.arrays) array.values.push_back(NAN);
        continue;
      }
      const Vec3<double>& point = mesh_->vertices[i];
      const Place place = setup.locator.place(point);
      const CageErrors errors = errors_at(setup.coordinates, *cage_, point, expected_sum(kind_, setup.locator, point),
                                          0, place == Place::TooClose ? nullptr : &setup.terms);
      // Points nearer than the promise reaches are shown in the field and counted, not judged.
      const bool missing = kind_.inside_alone && place == Place::Outside;
      const bool judged = place != Place::TooClose && !missing, excused = !judged || may_be_missing(setup.prior, point);
      rows.add("partition_of_unity", "mesh", 0, judged ? errors.partition[0] : CageError(), excused, point, i);
      rows.add("linear_reproduction", "mesh", 0, judged ? errors.reproduction[0] : CageError(), excused, point, i);
      part.image.arrays[0].values.push_back(errors.partition[0].relative);
      part.image.arrays[1].values.push_back(errors.reproduction[0].relative);
    }
    rows.found.fields.emplace(std::pair(place_, part.first), std::move(part));
    return std::move(rows.found);
  }

 private:
  struct Setup {
    CageLocator locator;
    CageCoordinates coordinates;
    std::optional<CageCoordinates> prior;
    CageTerms terms;
  };
  std::shared_ptr<const Cage> cage_;
  const CoordinateKind& kind_;
  std::shared_ptr<const Mesh> mesh_;
  int place_;
  CageCampaignOptions options_;
  FieldPart empty_;
  std::size_t stride_ = 1;  // takes every n-th point, so that what is measured is spread evenly
  Lazy<Setup> setup_;
};

}  // namespace

bool is_affordable(const CoordinateKind& kind, const Cage& cage, const CageCampaignOptions& options) {
  if (!kind.solves_on_samples) return true;
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
