// SPDX-License-Identifier: MIT
#include "potentials.h"

#include "conversions.h"

#include "cageproof/core/cage/embedded_cages.h"
#include "cageproof/core/catalogue/named_parameters.h"
#include "cageproof/core/coordinates/whole_evaluation.h"
#include "cageproof/core/geometry/box_tree.h"
#include "cageproof/core/geometry/orientation.h"
#include "cageproof/core/geometry/quad_geometry.h"
#include "cageproof/core/parallel.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace cageproof::library {
namespace {

constexpr std::string_view kBatched = "batched";

// A cage of elements of a formula's kind.
const cageproof::Cage& cage_like(const Formula& formula) {
  static const cageproof::Cage space = cageproof::embedded_cage("icosphere"),
                               plane = cageproof::embedded_cage("square");
  return formula.dim() == 3 ? space : plane;
}

// \throws InputError, with the formula's evaluations, where there is none
std::optional<BatchedFormula> batched_of(const std::string& name, const std::string& evaluation) {
  if (evaluation != kBatched) return std::nullopt;
  const Formula& formula = formula_named(name);
  for (const CoordinateKind& kind : coordinate_kinds())
    for (std::size_t b = 0; kind.is_sum() && !kind.normalised && !kind.keeps_quads && b < kind.blocks.size(); ++b)
      // Kelvin's sums leave out what cancels on closed surfaces.
      if (kind.blocks[b].kernel == formula.kernel() && formula.corners() < 4 && formula.shape.entries() == 1 &&
          find_whole_evaluation(kBatched, kind, cage_like(formula)) != nullptr)
        return BatchedFormula{&kind, b};
  throw InputError(fmt::format("{} has no batched evaluation: only single, double and biharmonic layers have", name));
}

Evaluation evaluation_of(const std::string& formula, const std::string& name) {
  const Formula& row = formula_named(formula);
  if (!name.empty() && name != kBatched) return evaluation_named(formula, name);
  const auto recommended = EvaluationRegister::instance().with_role(row.name, Role::Recommended);
  if (!recommended) throw InputError(fmt::format("{} has no recommended evaluation; name one", formula));
  return *recommended;
}

std::vector<Vec3<double>> finite_vectors(std::span<const double> numbers, int dimension, std::string_view what) {
  for (std::size_t i = 0; i < numbers.size(); ++i)
    if (!std::isfinite(numbers[i]))
      throw InputError(fmt::format("{}: number {} is not finite (counted from 0)", what, i));
  return vectors_of(numbers, dimension, what);
}

// The corners of elements, one after another.
std::vector<Vec3<double>> checked_elements(const Formula& formula, std::span<const double> numbers) {
  std::vector<Vec3<double>> all = finite_vectors(numbers, formula.dim(), "elements");
  const auto corners = static_cast<std::size_t>(formula.corners());
  check_multiple(numbers.size(), corners * static_cast<std::size_t>(formula.dim()), "elements");
  const ElementType& type = type_of(formula.element);
  for (std::size_t first = 0; first < all.size(); first += corners) {
    const Vec3<double>* const c = &all[first];
    const std::size_t e = first / corners;
    if (corners == 4) {
      if (const auto reason = invalid_because(Quad<double>{c[0], c[1], c[2], c[3]}))
        throw InputError(fmt::format("elements: element {}: {} (elements and corners counted from 0)", e, *reason));
    } else if (corners == 3 ? on_a_line(Triangle<double>{c[0], c[1], c[2]}) : c[0] == c[1]) {
      throw InputError(fmt::format("elements: element {}: {} (counted from 0)", e, type.degenerate_text));
    }
  }
  return all;
}

// Values on an element's inside as those of the side that is asked for; derivatives there have no other limits known.
void take_side(const ElementRequest& request, std::span<const Vec3<double>> corners, const Vec3<double>& point,
               const std::array<double*, 3>& at) {
  const Formula& formula = request.of.formula();
  const ContactPoint place = type_of(formula.element).contact(corners, point);
  if (place.contact == Contact::Off) return;
  const FaceJump jump = formula.behaviour(request.of.parameters()).face_jump;
  const double nan = std::numeric_limits<double>::quiet_NaN(), share = request.side == Side::Mean ? 0.5 : 1;
  const double size = jump.number + jump.pi_multiple * std::numbers::pi;
  const int entries = formula.shape.entries();
  if (place.contact == Contact::Border || jump.diverges) std::fill_n(at[0], formula.components(), nan);
  else if (size != 0)
    for (int k = 0; k < formula.tensors(); ++k)
      for (int i = 0; i < entries; ++i)
        if (entries == 1 || i % (formula.shape.columns + 1) == 0)
          at[0][k * entries + i] -= share * size * (formula.shape.per_corner ? place.basis[k] : 1);
  for (int o = 1; o <= request.order; ++o)
    std::fill_n(at[o], static_cast<std::size_t>(formula.components()) * derivative_count(formula.dim(), o), nan);
}

void check_request(const ElementRequest& request, const TensorSpans& results, std::size_t numbers) {
  if (request.order < 0 || request.order > request.of.evaluation().max_order())
    throw InputError(fmt::format("{} of {} gives derivatives up to order {}, not {}", request.of.evaluation().name(),
                                 request.of.formula().name, request.of.evaluation().max_order(), request.order));
  if (request.of.batched() != nullptr && request.order > 0)
    throw InputError("batched gives values only: ask without it for derivatives");
  constexpr std::array names{"values", "gradients", "hessians"};
  for (int o = 0; o < 3; ++o)
    check_size(results[o].size(), o <= request.order ? numbers * derivative_count(request.of.formula().dim(), o) : 0,
               names[o]);
}

// One element at a block of points: [point][component] from `to`, `stride` components from point to point.
void evaluate_block(const ElementRequest& request, std::span<const Vec3<double>> corners,
                    std::span<const Vec3<double>> points, const std::array<double*, 3>& to, std::size_t stride) {
  const Formula& formula = request.of.formula();
  BatchOutput<double> output{
      .tensors = to, .entries = static_cast<std::size_t>(formula.shape.entries()), .dim = formula.dim()};
  for (int o = 0; o < 3; ++o) output.stride[o] = stride * derivative_count(formula.dim(), o);
  request.of.evaluation()(Batch<double>{corners, points, request.order, request.of.parameters()}, output);
  if (request.side == Side::Inside) return;
  for (std::size_t p = 0; p < points.size(); ++p) {
    std::array<double*, 3> at{};
    for (int o = 0; o <= request.order; ++o) at[o] = to[o] + p * output.stride[o];
    take_side(request, corners, points[p], at);
  }
}

// Elements that share nothing, each with vertices of its own: their coordinates are the formula's tensors, in its
// order.
CageCoordinates batched_coordinates(const ElementRequest& request, std::vector<Vec3<double>> corners) {
  const Formula& formula = request.of.formula();
  std::vector<Face> faces(corners.size() / static_cast<std::size_t>(formula.corners()));
  int next = 0;
  for (Face& face : faces)
    for (int k = 0; k < formula.corners(); ++k) face.vertices[k] = next++;
  const auto parameters = request.of.parameters();
  return {std::make_shared<const CageElements>(formula.dim(), std::move(corners), std::move(faces)),
          *request.of.batched()->kind,
          CoordinateOptions{.evaluation = std::string(kBatched), .parameters = {parameters.begin(), parameters.end()}},
          cage_like(formula)};
}

// Finds points on elements, where coordinates have limits of a closed surface, which a list of elements has not.
class PointsOn {
 public:
  explicit PointsOn(const CageElements& elements) : elements_(elements), boxes_(boxes_around(elements)) {}

  /// Asks them again, element by element.
  void ask_again(std::span<const Vec3<double>> points, std::size_t first, std::size_t block,
                 const std::function<void(std::size_t, std::size_t)>& one_by_one) const {
    for (std::size_t p = first; p < first + block; ++p) {
      bool in_a_box = false;
      boxes_.for_each_meeting({points[p], points[p]}, [&](int) {
        in_a_box = true;
        return false;
      });
      if (in_a_box && !elements_.touching(points[p]).empty()) one_by_one(p, 1);
    }
  }

 private:
  static std::vector<Box> boxes_around(const CageElements& elements) {
    std::vector<Box> boxes;
    boxes.reserve(elements.count());
    for (std::size_t e = 0; e < elements.count(); ++e) boxes.push_back(box_of(elements.corners(e)));
    return boxes;
  }

  const CageElements& elements_;
  BoxTree boxes_;
};

}  // namespace

ElementFormula::ElementFormula(const std::string& formula, const std::string& evaluation,
                               const std::vector<std::pair<std::string, std::string>>& parameters)
    : batched_(batched_of(formula, evaluation)),
      evaluation_(evaluation_of(formula, evaluation)),
      parameters_(parameter_values(parameter_texts(parameters), parameters_of(evaluation_.formula()), {formula})) {
  if (!evaluation_.supports<double>())
    throw InputError(fmt::format("{} of {} does not exist in double", evaluation_.name(), formula));
}

void evaluate_pairs(const ElementRequest& request, std::span<const double> elements, std::span<const double> points,
                    const TensorSpans& results) {
  const Formula& formula = request.of.formula();
  if (request.of.batched() != nullptr)
    throw InputError("batched computes all pairs of elements and points, not one per element");
  const std::vector<Vec3<double>> corners = checked_elements(formula, elements),
                                  at = finite_vectors(points, formula.dim(), "points");
  const auto each = static_cast<std::size_t>(formula.corners()), width = static_cast<std::size_t>(formula.components());
  const std::size_t count = corners.size() / each, pairs = std::max(count, at.size());
  if (count != at.size() && count != 1 && at.size() != 1)
    throw InputError(fmt::format("{} elements and {} points make no pairs: give as many of both, or one of either",
                                 count, at.size()));
  if (count == 0 || at.size() == 0) throw InputError("no pair of an element and a point");
  check_request(request, results, pairs * width);
  for_blocks(pairs, request.threads, [&](std::size_t first, std::size_t block) {
    const auto from = [&](std::size_t pair) {
      std::array<double*, 3> to{};
      for (int o = 0; o <= request.order; ++o)
        to[o] = results[o].data() + pair * width * derivative_count(formula.dim(), o);
      return to;
    };
    if (count == 1) return evaluate_block(request, corners, std::span(at).subspan(first, block), from(first), width);
    for (std::size_t pair = first; pair < first + block; ++pair)
      evaluate_block(request, std::span(corners).subspan(pair * each, each),
                     std::span(at).subspan(at.size() == 1 ? 0 : pair, 1), from(pair), width);
  });
}

void evaluate_all(const ElementRequest& request, std::span<const double> elements, std::span<const double> points,
                  const TensorSpans& results) {
  const Formula& formula = request.of.formula();
  const std::vector<Vec3<double>> corners = checked_elements(formula, elements),
                                  at = finite_vectors(points, formula.dim(), "points");
  const auto each = static_cast<std::size_t>(formula.corners()), width = static_cast<std::size_t>(formula.components());
  const std::size_t count = corners.size() / each, row = count * width;
  check_request(request, results, at.size() * row);
  const auto one_by_one = [&](std::size_t first, std::size_t block) {
    for (std::size_t e = 0; e < count; ++e) {
      std::array<double*, 3> to{};
      for (int o = 0; o <= request.order; ++o)
        to[o] = results[o].data() + (first * row + e * width) * derivative_count(formula.dim(), o);
      evaluate_block(request, std::span(corners).subspan(e * each, each), std::span(at).subspan(first, block), to, row);
    }
  };
  const BatchedFormula* const batched = request.of.batched();
  if (batched == nullptr || count == 0) return for_blocks(at.size(), request.threads, one_by_one);
  const CageCoordinates all = batched_coordinates(request, corners);
  const PointsOn on(all.elements());
  for_blocks(at.size(), request.threads, [&](std::size_t first, std::size_t block) {
    const auto tables = all.at<double>(std::span(at).subspan(first, block), 0);
    std::ranges::copy(tables[batched->block].tensors[0], results[0].begin() + static_cast<std::ptrdiff_t>(first * row));
    on.ask_again(at, first, block, one_by_one);
  });
}

void apply_all(const ElementRequest& request, std::span<const double> elements, std::span<const double> densities,
               int sets, std::span<const double> points, const TensorSpans& results) {
  const Formula& formula = request.of.formula();
  const std::vector<Vec3<double>> corners = checked_elements(formula, elements),
                                  at = finite_vectors(points, formula.dim(), "points");
  const auto each = static_cast<std::size_t>(formula.corners()), width = static_cast<std::size_t>(formula.components()),
             rows = static_cast<std::size_t>(formula.shape.rows),
             columns = static_cast<std::size_t>(formula.shape.columns),
             tensors = static_cast<std::size_t>(formula.tensors());
  if (sets < 1) throw InputError(fmt::format("{} sets of densities, not 1 or more", sets));
  const auto wide = static_cast<std::size_t>(sets);
  const std::size_t count = corners.size() / each, of_element = tensors * columns * wide;
  check_size(densities.size(), count * of_element, "densities");
  check_request(request, results, at.size() * rows * wide);
  for (int o = 0; o <= request.order; ++o) std::ranges::fill(results[o], 0.0);
  const auto one_by_one = [&](std::size_t first, std::size_t block) {
    std::array<std::vector<double>, 3> found;
    std::array<double*, 3> to{};
    for (int o = 0; o <= request.order; ++o) {
      found[o].resize(block * width * derivative_count(formula.dim(), o));
      to[o] = found[o].data();
    }
    for (std::size_t e = 0; e < count; ++e) {
      evaluate_block(request, std::span(corners).subspan(e * each, each), std::span(at).subspan(first, block), to,
                     width);
      const double* const density = densities.data() + e * of_element;
      for (int o = 0; o <= request.order; ++o) {
        const std::size_t axes = derivative_count(formula.dim(), o);
        for (std::size_t p = 0; p < block; ++p)
          for (std::size_t k = 0; k < tensors; ++k)
            for (std::size_t r = 0; r < rows; ++r)
              for (std::size_t c = 0; c < columns; ++c) {
                const double* const entry = to[o] + (p * width + (k * rows + r) * columns + c) * axes;
                double* const sum = results[o].data() + ((first + p) * rows + r) * wide * axes;
                for (std::size_t s = 0; s < wide; ++s) {
                  const double factor = density[(k * columns + c) * wide + s];
                  // A density of zero leaves out what is infinite or NaN: elements that a caller switches off.
                  if (factor == 0) continue;
                  for (std::size_t axis = 0; axis < axes; ++axis) sum[s * axes + axis] += factor * entry[axis];
                }
              }
      }
    }
  };
  const BatchedFormula* const batched = request.of.batched();
  if (batched == nullptr || count == 0) return for_blocks(at.size(), request.threads, one_by_one);
  const CageCoordinates all = batched_coordinates(request, corners);
  const PointsOn on(all.elements());
  CageData data{.sets = sets, .blocks = {}};
  for (const CoordinateBlock& b : all.blocks()) data.blocks.emplace_back(static_cast<std::size_t>(b.size) * wide, 0.0);
  data.blocks[batched->block].assign(densities.begin(), densities.end());
  for_blocks(at.size(), request.threads, [&](std::size_t first, std::size_t block) {
    const AppliedTable table = all.apply(std::span(at).subspan(first, block), 0, data);
    const auto to = results[0].subspan(first * wide, block * wide);
    std::ranges::copy(table.tensors[0], to.begin());
    on.ask_again(at, first, block, [&](std::size_t p, std::size_t count_of) {
      std::ranges::fill(results[0].subspan(p * wide, wide), 0.0);
      one_by_one(p, count_of);
    });
  });
}

}  // namespace cageproof::library
