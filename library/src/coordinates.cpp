// SPDX-License-Identifier: MIT
#include "conversions.h"

#include "cageproof/core/coordinates/rest_derivative.h"
#include "cageproof/core/coordinates/whole_evaluation.h"
#include "cageproof/core/reused.h"

#include <fmt/format.h>

#include <algorithm>

namespace cageproof::library {
namespace {

std::string name_of(Reproduces what) {
  switch (what) {
    case Reproduces::Vertices: return "vertices";
    case Reproduces::TurnedVertices: return "turned vertices";
    case Reproduces::Normals: return "normals";
    case Reproduces::Nothing: break;
  }
  return "nothing";
}

CageCoordinates prepare(const cageproof::Cage& cage, const std::string& kind_name, const Options& options) {
  const CoordinateKind& kind = coordinate_kind_named(kind_name);
  return {
      cage, kind,
      CoordinateOptions{options.evaluation.empty() ? std::string(quickest) : options.evaluation,
                        triangulation_of(options), parameters_of(options, cageproof::parameters_of(kind), kind_name)}};
}

}  // namespace

struct Coordinates::Prepared {
  Prepared(const cageproof::Cage& cage, const std::string& kind, const Options& options)
      : coordinates(prepare(cage, kind, options)), threads(options.threads) {
    for (const CoordinateBlock& b : coordinates.blocks()) {
      blocks.push_back({b.label, std::string(cageproof::name_of(b.owner)), static_cast<std::size_t>(b.size),
                        b.shape.rows, b.shape.columns, row, name_of(b.reproduces), b.normal_factor});
      row += static_cast<std::size_t>(b.size) * b.entries();
      is_numbers = is_numbers && b.entries() == 1;
    }
    const std::vector<int> faces = cage.parts(coordinates.kind().keeps_quads, triangulation_of(options)).face_of;
    const CageElements& all = coordinates.elements();
    for (std::size_t e = 0; e < all.count(); ++e) {
      const auto vertices = all.vertices_of(e);
      const Vec3<double>& normal = all.normals()[e];
      std::vector<std::vector<double>> normals;
      for (const int i : all.shares_of(e, Owner::Normal)) {
        const Vec3<double> one = all.normal_of(i, Owner::Normal);
        normals.emplace_back(one.data(), one.data() + all.dimension());
      }
      elements.push_back({{vertices.begin(), vertices.end()},
                          faces[e],
                          {normal.data(), normal.data() + all.dimension()},
                          std::move(normals)});
    }
  }

  CageCoordinates coordinates;
  int threads;
  std::vector<Block> blocks;
  std::vector<Element> elements;
  std::size_t row = 0;
  bool is_numbers = true;
  // Tables of earlier calls, so that those for a few points find memory.
  mutable Reused<std::vector<CoordinateTable<double>>> reused;
};

Coordinates::Coordinates(const Cage& cage, const std::string& kind, const Options& options)
    : prepared_(std::make_shared<const Prepared>(checked_cage(cage, options), kind, options)) {}

int Coordinates::dimension() const { return prepared_->coordinates.dimension(); }
int Coordinates::max_order() const { return prepared_->coordinates.max_order(); }
std::string Coordinates::evaluation() const { return prepared_->coordinates.evaluation(); }
const std::vector<Block>& Coordinates::blocks() const { return prepared_->blocks; }
const std::vector<Element>& Coordinates::elements() const { return prepared_->elements; }
std::size_t Coordinates::row(int order) const { return prepared_->row * derivative_count(dimension(), order); }

void Coordinates::evaluate(std::span<const double> points, std::span<double> values, std::span<double> gradients,
                           std::span<double> hessians) const {
  const std::vector<Vec3<double>> at = vectors_of(points, dimension(), "points");
  const std::array<std::span<double>, 3> out{values, gradients, hessians};
  constexpr std::array names{"values", "gradients", "hessians"};
  const int order = !hessians.empty() ? 2 : !gradients.empty() ? 1 : 0;
  if (order > max_order())
    throw InputError(fmt::format("{} by {} gives derivatives up to order {}, not {}",
                                 prepared_->coordinates.kind().name, evaluation(), max_order(), order));
  for (int o = 0; o <= order; ++o) check_size(out[o].size(), at.size() * row(o), names[o]);
  // Large tables go with the call.
  constexpr std::size_t kept = 1U << 16;
  Reused<std::vector<CoordinateTable<double>>> own;
  auto& reused = std::min(at.size(), kBlock) * row(order) <= kept ? prepared_->reused : own;
  for_blocks(at.size(), prepared_->threads, [&](std::size_t first, std::size_t count) {
    auto held = reused.taken();
    std::vector<CoordinateTable<double>>& tables = *held;
    prepared_->coordinates.at(std::span(at).subspan(first, count), order, tables);
    for (int o = 0; o <= order; ++o)
      for (std::size_t p = 0; p < count; ++p) {
        auto to = out[o].begin() + static_cast<std::ptrdiff_t>((first + p) * row(o));
        for (const CoordinateTable<double>& table : tables)
          to = std::copy_n(table.tensors[o].data() + p * table.stride[o], table.stride[o], to);
      }
  });
}

void Coordinates::apply(std::span<const double> points, std::span<const double> data, int functions,
                        std::span<double> sums) const {
  const std::vector<Vec3<double>> at = vectors_of(points, dimension(), "points");
  if (!prepared_->is_numbers)
    throw InputError(fmt::format("{} coordinates are matrices, and take no data", prepared_->coordinates.kind().name));
  if (functions < 1) throw InputError(fmt::format("{} functions, not 1 or more", functions));
  check_size(data.size(), prepared_->row * functions, "data");
  check_size(sums.size(), at.size() * functions, "sums");
  CageData lists{.sets = functions, .blocks = {}};
  for (const Block& block : blocks()) {
    const auto part = data.subspan(block.offset * functions, block.count * functions);
    lists.blocks.emplace_back(part.begin(), part.end());
  }
  for_blocks(at.size(), prepared_->threads, [&](std::size_t first, std::size_t count) {
    const AppliedTable table = prepared_->coordinates.apply(std::span(at).subspan(first, count), 0, lists);
    std::ranges::copy(table.tensors[0], sums.begin() + static_cast<std::ptrdiff_t>(first * functions));
  });
}

void Coordinates::jvp(std::span<const double> points, std::span<const double> change, std::span<double> values) const {
  const RestDerivative& derivative = rest_derivative_of(prepared_->coordinates.kind());
  const std::vector<Vec3<double>> at = vectors_of(points, dimension(), "points");
  const std::vector<Vec3<double>> steps = vectors_of(change, dimension(), "change");
  const std::size_t vertices = prepared_->coordinates.elements().vertices().size();
  if (steps.size() != vertices)
    throw InputError(fmt::format("change: {} vertices, the cage has {}", steps.size(), vertices));
  check_size(values.size(), at.size() * row(), "values");
  derivative.jvp(prepared_->coordinates, at, steps, prepared_->threads, values);
}

void Coordinates::vjp(std::span<const double> points, std::span<const double> weights,
                      std::span<double> vertices) const {
  const RestDerivative& derivative = rest_derivative_of(prepared_->coordinates.kind());
  const std::vector<Vec3<double>> at = vectors_of(points, dimension(), "points");
  if (weights.size() != at.size() * row())
    throw InputError(fmt::format("weights: {} numbers, not {}", weights.size(), at.size() * row()));
  const std::size_t count = prepared_->coordinates.elements().vertices().size(),
                    d = static_cast<std::size_t>(dimension());
  check_size(vertices.size(), count * d, "vertices");
  const std::vector<Vec3<double>> found = derivative.vjp(prepared_->coordinates, at, weights, prepared_->threads);
  for (std::size_t v = 0; v < count; ++v)
    std::copy_n(found[v].data(), d, vertices.begin() + static_cast<std::ptrdiff_t>(v * d));
}

}  // namespace cageproof::library
