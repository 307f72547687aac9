// SPDX-License-Identifier: MIT
#include "cageproof/validation/error_fields.h"

#include "cageproof/core/geometry/box.h"
#include "cageproof/core/input_error.h"
#include "cageproof/validation/cage_campaign.h"
#include "cageproof/core/lazy.h"
#include "cageproof/core/parallel.h"
#include "cageproof/validation/cage_errors.h"
#include "cageproof/validation/scheme_errors.h"
#include "cageproof/validation/truth.h"
#include "element/element_sampling.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace cageproof::validation {
namespace {

constexpr double masked = std::numeric_limits<double>::quiet_NaN();

ImageField empty_field(const SlicePlan& slice, std::string name) {
  ImageField field;
  field.name = std::move(name);
  field.points = slice.points;
  field.origin = slice.origin;
  field.spacing = slice.spacing;
  return field;
}

std::size_t count_of(const SlicePlan& slice) {
  return static_cast<std::size_t>(slice.points[0]) * slice.points[1] * slice.points[2];
}

Vec3<double> point_of(const SlicePlan& slice, std::size_t i) {
  const std::size_t nx = slice.points[0], ny = slice.points[1];
  const std::size_t layer = i / (nx * ny);
  const Vec3<double> steps(static_cast<double>(i % nx), static_cast<double>(i / nx % ny), static_cast<double>(layer));
  return slice.origin + slice.spacing.cwiseProduct(steps);
}

// A file name from a cage's name, which may be a path.
std::string file_name(const Cage& cage) {
  std::string name = cage.name().substr(cage.name().find_last_of('/') + 1);
  for (char& c : name)
    if (!std::isalnum(static_cast<unsigned char>(c))) c = '-';
  return name;
}

std::string name_of_field(const Cage& cage, const CageCoordinates& coordinates, const char* what) {
  return fmt::format("{}.{}.{}.{}", file_name(cage), coordinates.kind().name, coordinates.evaluation(), what);
}

FieldFacts facts_of(const Cage& cage, const CageCoordinates& coordinates, Triangulation rule) {
  return {{"cage", cage.name()},
          {"kind", std::string(coordinates.kind().name)},
          {"evaluation", coordinates.evaluation()},
          {"triangulation", std::string(name_of(rule))},
          {"unit of length", "that of the cage"}};
}

SlicePlan grid_of(const ImageField& field) { return {field.origin, field.spacing, field.points}; }

// Arrays with room for so many values each.
void make_room(std::vector<ImageField::Array>& arrays, std::size_t count) {
  for (ImageField::Array& array : arrays) array.values.resize(count);
}

// Sample i of the grid into entry `at` of each array.
void sample_into(std::vector<ImageField::Array>& arrays, std::size_t at, const FieldPlan::Sampler& sampler,
                 const Vec3<double>& point) {
  std::vector<double> values(arrays.size());
  sampler(point, values);
  for (std::size_t a = 0; a < arrays.size(); ++a) arrays[a].values[at] = values[a];
}

class FieldMeasurement final : public Measurement {
 public:
  FieldMeasurement(FieldPlan plan, int place, const std::string& title, const std::string& shown, FieldPart common)
      : place_(place), grid_(grid_of(plan.field)), empty_(std::move(common)), sampler_(std::move(plan.prepare)) {
    empty_.title = title;
    empty_.shown = shown;
    empty_.samples = count_of(grid_);
    empty_.image = std::move(plan.field);
  }

  std::string name() const override { return "field " + empty_.image.name; }
  int blocks() const override { return block_count(empty_.samples, 200); }

  PartialResult measure(int block) const override {
    const FieldPlan::Sampler& sampler = sampler_.get();
    FieldPart part = empty_;
    part.first = block_begin(part.samples, block, blocks());
    const std::size_t count = block_begin(part.samples, block + 1, blocks()) - part.first;
    make_room(part.image.arrays, count);
    for (std::size_t i = 0; i < count; ++i) sample_into(part.image.arrays, i, sampler, point_of(grid_, part.first + i));
    PartialResult gathered;
    gathered.fields.emplace(std::pair(place_, part.first), std::move(part));
    return gathered;
  }

 private:
  int place_;
  SlicePlan grid_;
  FieldPart empty_;
  Lazy<FieldPlan::Sampler> sampler_;
};

}  // namespace

SlicePlan slice_through(const Cage& cage, int resolution) {
  const auto [low, high] = box_of(cage.vertices());
  const Vec3<double> size = high - low;
  int across = 2;
  for (int c = 0; c < 3; ++c)
    if (size[c] < size[across]) across = c;
  SlicePlan slice{low - 0.05 * size, Vec3<double>::Ones(), {resolution, resolution, resolution}};
  // Off the middle, where symmetric cages have edges.
  slice.origin[across] = low[across] + 0.47 * size[across];
  slice.points[across] = 1;
  for (int c = 0; c < 3; ++c)
    if (c != across) slice.spacing[c] = 1.1 * size[c] / (resolution - 1);
  return slice;
}

ImageField sampled(const FieldPlan& plan, int jobs) {
  ImageField field = plan.field;
  const SlicePlan grid = grid_of(field);
  const FieldPlan::Sampler sampler = plan.prepare();
  make_room(field.arrays, count_of(grid));
  for_each_parallel(count_of(grid), jobs,
                    [&](std::size_t i) { sample_into(field.arrays, i, sampler, point_of(grid, i)); });
  return field;
}

std::unique_ptr<const Measurement> field_measurement(FieldPlan plan, int place, const std::string& title,
                                                     const std::string& shown, FieldPart common) {
  return std::make_unique<FieldMeasurement>(std::move(plan), place, title, shown, std::move(common));
}

FieldPlan reproduction_field(const std::shared_ptr<const Cage>& cage, const CoordinateKind& kind,
                             const std::string& evaluation, Triangulation rule, int resolution,
                             const std::vector<double>& parameters) {
  // Prepared once: some kinds solve large systems.
  const auto coordinates =
      std::make_shared<const CageCoordinates>(*cage, kind, CoordinateOptions{evaluation, rule, parameters});
  FieldPlan plan;
  plan.field = empty_field(slice_through(*cage, resolution), name_of_field(*cage, *coordinates, "reproduction"));
  plan.field.facts = facts_of(*cage, *coordinates, rule);
  plan.field.arrays = {{"partition of unity", "1", 1, {}}, {"linear reproduction", "cage sizes", 1, {}}};
  plan.prepare = [=, &kind]() -> FieldPlan::Sampler {
    const auto locator = std::make_shared<const CageLocator>(*cage, rule, kind.keeps_quads);
    return [=, &kind](const Vec3<double>& p, std::span<double> values) {
      const Place place = locator->place(p);
      const CageErrors errors = errors_at(*coordinates, *cage, p, expected_sum(kind, *locator, p), 0);
      const bool shown = place != Place::TooClose;
      values[0] = shown ? errors.partition[0].relative : masked;
      values[1] = shown ? errors.reproduction[0].relative : masked;
    };
  };
  return plan;
}

FieldPlan coordinate_error_field(const std::shared_ptr<const Cage>& cage, const CoordinateKind& kind,
                                 const std::string& evaluation, Triangulation rule, int resolution) {
  const auto coordinates = std::make_shared<const CageCoordinates>(*cage, kind, evaluation, rule);
  FieldPlan plan;
  plan.field = empty_field(slice_through(*cage, resolution), name_of_field(*cage, *coordinates, "error"));
  plan.field.facts = facts_of(*cage, *coordinates, rule);
  plan.field.arrays = {{"relative error", "1", 1, {}}};
  plan.prepare = [=, &kind]() -> FieldPlan::Sampler {
    const auto reference =
        std::make_shared<const CageCoordinates>(*cage, kind, CoordinateOptions{.triangulation = rule});
    return [=](const Vec3<double>& p, std::span<double> values) {
      values[0] = truth_errors_at(*coordinates, *reference, p, 0)[0].relative;
    };
  };
  return plan;
}

FieldPlan coordinate_difference_field(const std::shared_ptr<const Cage>& cage, const CoordinateKind& kind,
                                      const std::string& evaluation, const std::string& other, Triangulation rule,
                                      int resolution) {
  const auto first = std::make_shared<const CageCoordinates>(*cage, kind, evaluation, rule);
  FieldPlan plan;
  plan.field = empty_field(slice_through(*cage, resolution), name_of_field(*cage, *first, "difference"));
  plan.field.facts = facts_of(*cage, *first, rule);
  plan.field.facts["compared with"] = other.empty() ? "recommended" : other;
  plan.field.arrays = {{"difference", "1", 1, {}}};
  plan.prepare = [=, &kind]() -> FieldPlan::Sampler {
    const auto second = std::make_shared<const CageCoordinates>(*cage, kind, other, rule);
    return [=](const Vec3<double>& p, std::span<double> values) {
      const auto a = first->at<double>(p, 0), b = second->at<double>(p, 0);
      double worst = 0;
      for (std::size_t block = 0; block < a.size(); ++block)
        for (std::size_t k = 0; k < a[block].value.size(); ++k) {
          const double d = std::abs(a[block].value[k] - b[block].value[k]);
          worst = std::isnan(d) ? std::numeric_limits<double>::infinity() : std::max(worst, d);
        }
      values[0] = worst;
    };
  };
  return plan;
}

FieldPlan scheme_error_field(const std::shared_ptr<const Cage>& cage, const CoordinateKind& kind, Triangulation rule,
                             int resolution, const std::vector<double>& parameters) {
  if (kind.approximates.empty())
    throw InputError(fmt::format("{} coordinates approximate no others that are known better", kind.name));
  const CoordinateKind& approximated = coordinate_kind_named(kind.approximates);
  if (!exists_on(approximated, *cage))
    throw InputError(fmt::format("{}: {} exists for polygons only", cage->name(), kind.approximates));
  if (const std::string reason = why_refused(approximated, *cage); !reason.empty())
    throw InputError(fmt::format("{}: {}", cage->name(), reason));
  auto found = approximated_by(*cage, kind, rule);
  if (!found)
    throw InputError(fmt::format("{}: {} meets its data on the cage worse than to {}, so that it is no truth",
                                 cage->name(), kind.approximates, worst_truth));
  const auto truth = std::make_shared<const CageCoordinates>(std::move(*found));
  const auto coordinates =
      std::make_shared<const CageCoordinates>(*cage, kind, CoordinateOptions{"", rule, parameters});
  FieldPlan plan;
  plan.field = empty_field(slice_through(*cage, resolution), name_of_field(*cage, *coordinates, "scheme-error"));
  plan.field.facts = facts_of(*cage, *coordinates, rule);
  plan.field.facts["compared with"] = kind.approximates;
  plan.field.arrays = {{"scheme error", "cage sizes", 1, {}}};
  plan.prepare = [=]() -> FieldPlan::Sampler {
    const auto locator = std::make_shared<const CageLocator>(*cage, rule, false);
    return [=](const Vec3<double>& p, std::span<double> values) {
      const bool inside = locator->place(p) == Place::Inside;
      values[0] = inside ? scheme_errors_at(*coordinates, *truth, *cage, p, 0)[0] : masked;
    };
  };
  return plan;
}

FieldPlan coordinate_field(const std::shared_ptr<const Cage>& cage, const CoordinateKind& kind,
                           const std::string& label, int index, int resolution) {
  const auto rule = Triangulation::Shortest;
  const auto coordinates = std::make_shared<const CageCoordinates>(*cage, kind, "", rule);
  FieldPlan plan;
  const std::string name = fmt::format("{}_{}", label, index);
  plan.field =
      empty_field(slice_through(*cage, resolution), fmt::format("{}.{}.{}", file_name(*cage), kind.name, name));
  plan.field.facts = facts_of(*cage, *coordinates, rule);
  plan.field.arrays = {{name, "", 1, {}, true}};
  plan.prepare = [=, &kind]() -> FieldPlan::Sampler {
    const auto& blocks = coordinates->blocks();
    const auto block = std::ranges::find(blocks, label, &CoordinateBlock::label);
    if (block == blocks.end()) throw InputError(fmt::format("{} coordinates have no block {}", kind.name, label));
    if (index < 0 || index >= block->size)
      throw InputError(fmt::format("{} of {} coordinates in {} has indices 0 to {}, not {}", label, kind.name,
                                   cage->name(), block->size - 1, index));
    const auto place = static_cast<std::size_t>(std::distance(blocks.begin(), block));
    const std::size_t entry = static_cast<std::size_t>(index) * block->entries();
    const auto locator = std::make_shared<const CageLocator>(*cage, rule, kind.keeps_quads);
    return [=](const Vec3<double>& p, std::span<double> values) {
      const bool inside = locator->place(p) == Place::Inside;
      values[0] = inside ? coordinates->at<double>(p, 0)[place].value[entry] : masked;
    };
  };
  return plan;
}

ElementSlice slice_of(ElementKind kind, int resolution) {
  const FieldShape& shape = sampling_of(kind).field;
  ElementSlice found;
  for (int k = 0; k < corner_count(kind); ++k) found.corners.emplace_back(shape.corners[k].data());
  const int steps = resolution - 1;
  found.slice = {Vec3<double>(shape.origin.data()),
                 {shape.extent[0] / steps, shape.extent[1] / steps, 1},
                 {resolution, resolution, 1}};
  return found;
}

std::vector<std::vector<Vec3<double>>> elements_of(const Cage& cage, ElementKind kind, Triangulation rule) {
  for (const bool keep_quads : {false, true}) {
    const CageElements elements(cage, keep_quads, rule);
    std::vector<std::vector<Vec3<double>>> found;
    for (std::size_t e = 0; e < elements.count(); ++e)
      if (elements.type(e).kind == kind) found.push_back(elements.corners(e));
    if (!found.empty()) return found;
  }
  throw InputError(fmt::format("{} has no {}", cage.name(), name_of(kind)));
}

ImageField formula_error_field(const std::vector<std::vector<Vec3<double>>>& elements, const Formula& formula,
                               const Evaluation& evaluation, int order, const SlicePlan& slice, int jobs) {
  for (const auto& corners : elements)
    if (static_cast<int>(corners.size()) != formula.corners())
      throw InputError(
          fmt::format("{} lives on a {}, not on {} corners", formula.name, name_of(formula.element), corners.size()));
  const Evaluation reference = truth_source(formula).evaluation;
  ImageField field = empty_field(slice, fmt::format("{}.{}.{}", formula.name, evaluation.name(),
                                                    order == 0   ? "value"
                                                    : order == 1 ? "gradient"
                                                                 : "hessian"));
  field.facts = {{"formula", std::string(formula.name)},
                 {"evaluation", evaluation.name()},
                 {"order", fmt::format("{}", order)},
                 {"truth", fmt::format("{} in 50 digits", reference.name())}};
  const std::size_t count = count_of(slice);
  field.arrays = {{"value", "1", 1, std::vector<double>(count)},
                  {"relative error", "1", 1, std::vector<double>(count)}};
  std::vector<double> presets;
  presets.reserve(formula.parameters.size());
  for (const Parameter& p : formula.parameters) presets.push_back(p.preset);
  for_each_parallel(count, jobs, [&](std::size_t i) {
    Mp100 error = 0, size = 0;
    for (const auto& corners : elements) {
      const Sample sample{corners, point_of(slice, i), presets, 0, i};
      const Result<double> f = evaluate<double>(evaluation, sample, order);
      const Result<Mp50> truth = evaluate<Mp50>(reference, sample, order);
      for (std::size_t k = 0; k < f.of(order).size(); ++k) {
        const Mp100 exact(truth.of(order)[k]), d = Mp100(f.of(order)[k]) - exact;
        error += d * d;
        size += exact * exact;
      }
    }
    field.arrays[0].values[i] = static_cast<double>(Mp100(sqrt(size)));
    field.arrays[1].values[i] = !isfinite(size)    ? masked
                                : !isfinite(error) ? std::numeric_limits<double>::infinity()
                                : error == 0       ? 0
                                                   : static_cast<double>(Mp100(sqrt(error / size)));
  });
  return field;
}

}  // namespace cageproof::validation
