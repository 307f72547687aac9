// SPDX-License-Identifier: MIT
#include "cageproof/validation/compared_fields.h"

#include "cageproof/core/geometry/box.h"
#include "cageproof/core/input_error.h"
#include "cageproof/validation/cage_campaign.h"
#include "cageproof/validation/cage_points.h"
#include "cageproof/core/lazy.h"
#include "cageproof/core/parallel.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace cageproof::validation {
namespace {

// The middle member of the largest family of rules, which differ in their number of nodes.
std::string middle_rule(const std::string& formula) {
  std::string found;
  std::size_t most = 0;
  for (const EvaluationFamily* family : EvaluationRegister::instance().families(formula))
    if (family->role == Role::Rule && family->standard.size() > most) {
      most = family->standard.size();
      found = family->standard[most / 2];
    }
  return found;
}

// The worst block's relative error, norm-wise; NaN where no block has a finite truth. \param norms of each block's
// truth
double error_of(const std::vector<Result<double>>& found, const std::vector<Result<Mp50>>& truth,
                std::span<double> norms) {
  double worst = std::numeric_limits<double>::quiet_NaN();
  for (std::size_t b = 0; b < found.size(); ++b) {
    Mp50 error = 0, size = 0;
    for (std::size_t i = 0; i < found[b].value.size(); ++i) {
      const Mp50 d = Mp50(found[b].value[i]) - truth[b].value[i];
      error += d * d;
      size += truth[b].value[i] * truth[b].value[i];
    }
    norms[b] = isfinite(size) ? static_cast<double>(Mp50(sqrt(size))) : std::numeric_limits<double>::quiet_NaN();
    if (!isfinite(size)) continue;
    const double relative = !isfinite(error) ? std::numeric_limits<double>::infinity()
                            : error == 0     ? 0
                                             : static_cast<double>(Mp50(sqrt(Mp50(error / size))));
    worst = std::isnan(worst) ? relative : std::max(worst, relative);
  }
  return worst;
}

std::vector<ImageField::Array> arrays_of(const Comparison& comparison) {
  std::vector<ImageField::Array> arrays;
  arrays.reserve(comparison.evaluations.size());
  for (const std::string& evaluation : comparison.evaluations)
    arrays.push_back({evaluation + ": relative error", "", 1, {}});
  const CageCoordinates coordinates(*comparison.cage, *comparison.kind, "", comparison.rule);
  for (const CoordinateBlock& block : coordinates.blocks())
    arrays.push_back({"truth: norm of " + block.label, "", 1, {}, true});
  arrays.push_back({"inside", "", 1, {}, true});
  return arrays;
}

FieldFacts facts_of(const Comparison& comparison) {
  return {{"cage", comparison.cage->name()},
          {"kind", std::string(comparison.kind->name)},
          {"evaluations", fmt::format("{}", fmt::join(comparison.evaluations, ", "))},
          {"triangulation", std::string(name_of(comparison.rule))},
          {"truth", "the recommended evaluation in 50 digits"},
          {"unit of length", "that of the cage"},
          {"unit of errors", "1 (relative)"}};
}

std::string file_name_of(const Comparison& comparison) {
  std::string name = comparison.cage->name().substr(comparison.cage->name().find_last_of('/') + 1);
  for (char& c : name)
    if (!std::isalnum(static_cast<unsigned char>(c))) c = '-';
  return fmt::format("{}.{}.side-by-side", name, comparison.kind->name);
}

FieldPlan::Sampler sampler_of(const Comparison& comparison) {
  std::vector<std::shared_ptr<const CageCoordinates>> all;
  all.reserve(comparison.evaluations.size());
  for (const std::string& evaluation : comparison.evaluations)
    all.push_back(
        std::make_shared<const CageCoordinates>(*comparison.cage, *comparison.kind, evaluation, comparison.rule));
  const auto reference =
      std::make_shared<const CageCoordinates>(*comparison.cage, *comparison.kind, "", comparison.rule);
  const auto locator =
      std::make_shared<const CageLocator>(*comparison.cage, comparison.rule, comparison.kind->keeps_quads);
  return [=](const Vec3<double>& p, std::span<double> values) {
    const auto truth = reference->at<Mp50>(convert<Mp50>(p), 0);
    for (std::size_t e = 0; e < all.size(); ++e)
      values[e] = error_of(all[e]->at<double>(p, 0), truth, values.subspan(all.size(), truth.size()));
    values.back() = locator->inside(p) ? 1 : 0;
  };
}

SlicePlan box_around(const Cage& cage, int side) {
  if (cage.dimension() == 2) return slice_through(cage, side);
  const auto [low, high] = box_of(cage.vertices());
  const Vec3<double> size = high - low;
  // Off the middle by a little, where symmetric cages have edges.
  const Vec3<double> shift = size.cwiseProduct(Vec3<double>(0.0031, 0.0047, 0.0059));
  return {low - 0.05 * size + shift, 1.1 / (side - 1) * size, {side, side, side}};
}

// Parts of a mesh's field.
class SceneMesh final : public Measurement {
 public:
  SceneMesh(Comparison comparison, std::shared_ptr<const Mesh> mesh, std::size_t points, FieldPart empty, int place)
      : comparison_(std::move(comparison)),
        mesh_(std::move(mesh)),
        stride_(std::max<std::size_t>(1, mesh_->vertices.size() / std::max<std::size_t>(1, points))),
        empty_(std::move(empty)),
        place_(place),
        sampler_([this] { return sampler_of(comparison_); }) {}
  std::string name() const override { return "field " + empty_.image.name; }
  int blocks() const override { return block_count(mesh_->vertices.size(), 20 * stride_); }
  PartialResult measure(int block) const override {
    FieldPart part = empty_;
    part.first = block_begin(part.samples, block, blocks());
    std::vector<double> values(part.image.arrays.size());
    for (std::size_t i = part.first; i < block_begin(part.samples, block + 1, blocks()); ++i) {
      std::ranges::fill(values, std::numeric_limits<double>::quiet_NaN());
      if (i % stride_ == 0) sampler_.get()(mesh_->vertices[i], values);
      for (std::size_t a = 0; a < values.size(); ++a) part.image.arrays[a].values.push_back(values[a]);
    }
    PartialResult gathered;
    gathered.fields.emplace(std::pair(place_, part.first), std::move(part));
    return gathered;
  }

 private:
  Comparison comparison_;
  std::shared_ptr<const Mesh> mesh_;
  std::size_t stride_;
  FieldPart empty_;
  int place_;
  Lazy<FieldPlan::Sampler> sampler_;
};

class Outline final : public Measurement {
 public:
  explicit Outline(std::shared_ptr<const Cage> cage) : cage_(std::move(cage)) {}
  std::string name() const override { return "the outline of " + cage_->name(); }
  int blocks() const override { return 1; }
  PartialResult measure(int) const override {
    PartialResult gathered;
    gathered.meshes[outline_name(*cage_)] = outline_of(*cage_);
    return gathered;
  }

 private:
  std::shared_ptr<const Cage> cage_;
};

}  // namespace

std::vector<std::string> telling_evaluations(const CoordinateKind& kind, const Cage& cage) {
  const auto formulas = formulas_of(kind, cage);
  if (!kind.is_sum() || formulas.empty()) return {};
  const std::string first(formulas.front()->name);
  std::vector<std::string> found{middle_rule(first)};
  for (const Role role : {Role::Printed, Role::Recommended})
    if (const auto evaluation = EvaluationRegister::instance().with_role(first, role))
      found.push_back(evaluation->name());
  std::erase_if(found, [&](const std::string& name) {
    return name.empty() || std::ranges::any_of(formulas, [&](const Formula* formula) {
             return !EvaluationRegister::instance().find(formula->name, name);
           });
  });
  return found;
}

int affordable_side(const Comparison& comparison, double pairs, int most) {
  const auto elements = comparison.cage->parts(comparison.kind->keeps_quads, comparison.rule).elements.size();
  const double samples = pairs / static_cast<double>(elements * comparison.kind->blocks.size());
  const double side = comparison.cage->dimension() == 2 ? std::sqrt(samples) : std::cbrt(samples);
  return std::clamp(static_cast<int>(side), 6, std::max(6, most));
}

FieldPlan compared_field(const Comparison& comparison, int side) {
  const SlicePlan grid = box_around(*comparison.cage, side);
  FieldPlan plan;
  plan.field.name = file_name_of(comparison);
  plan.field.points = grid.points;
  plan.field.origin = grid.origin;
  plan.field.spacing = grid.spacing;
  plan.field.arrays = arrays_of(comparison);
  plan.field.facts = facts_of(comparison);
  plan.prepare = [=] { return sampler_of(comparison); };
  return plan;
}

MeshField compared_mesh(const Comparison& comparison, const Mesh& mesh, std::size_t points, int jobs) {
  MeshField field{file_name_of(comparison) + ".mesh", mesh.vertices, mesh.faces, arrays_of(comparison), {}};
  field.facts = facts_of(comparison);
  for (ImageField::Array& array : field.arrays)
    array.values.assign(mesh.vertices.size(), std::numeric_limits<double>::quiet_NaN());
  const std::size_t stride = std::max<std::size_t>(1, mesh.vertices.size() / std::max<std::size_t>(1, points));
  const auto sampler = sampler_of(comparison);
  for_each_parallel((mesh.vertices.size() + stride - 1) / stride, jobs, [&](std::size_t n) {
    std::vector<double> values(field.arrays.size());
    sampler(mesh.vertices[n * stride], values);
    for (std::size_t a = 0; a < values.size(); ++a) field.arrays[a].values[n * stride] = values[a];
  });
  return field;
}

Measurements scene_measurements(const Comparison& comparison, int side, const std::shared_ptr<const Mesh>& mesh,
                                std::size_t points, int place) {
  Measurements found;
  FieldPlan plan = compared_field(comparison, side);
  FieldPart common;
  common.cage = outline_name(*comparison.cage);
  common.scene = plan.field.name;
  for (const std::string& evaluation : comparison.evaluations)
    common.compared.push_back(evaluation + ": relative error");
  if (mesh) {
    FieldPart part = common;
    part.title = scene_title(comparison) + ", on the mesh";
    part.shown = common.compared.front();
    part.mesh = mesh_measured;
    part.samples = mesh->vertices.size();
    part.image.name = plan.field.name + ".mesh";
    part.image.arrays = plan.field.arrays;
    part.image.facts = plan.field.facts;
    found.push_back(std::make_unique<SceneMesh>(comparison, mesh, points, std::move(part), place + 1));
  }
  found.push_back(field_measurement(std::move(plan), place, scene_title(comparison), common.compared.front(), common));
  return found;
}

MeshField outline_of(const Cage& cage) {
  MeshField outline{outline_name(cage), cage.vertices(), {}, {}, {}};
  for (const Face& face : cage.faces())
    outline.faces.emplace_back(face.vertices.begin(), face.vertices.begin() + face.size());
  return outline;
}

std::string outline_name(const Cage& cage) { return "cage/" + cage.name(); }

std::unique_ptr<const Measurement> outline_measurement(std::shared_ptr<const Cage> cage) {
  return std::make_unique<Outline>(std::move(cage));
}

std::string scene_title(const Comparison& comparison) {
  return fmt::format("{}, {} coordinates: errors of {}", comparison.cage->name(), comparison.kind->name,
                     fmt::join(comparison.evaluations, ", "));
}

}  // namespace cageproof::validation
