// SPDX-License-Identifier: MIT
// Whole coordinates of closed triangle cages and of polygons, a vector of points at a time.
#include "clustered_sum.h"
#include "near_points.h"
#include "plane_blocks.h"

#include "cageproof/core/coordinates/coordinate_tables.h"
#include "cageproof/core/coordinates/coordinates_in_double.h"
#include "cageproof/core/lazy.h"
#include "cageproof/core/parallel.h"
#include "cageproof/core/reused.h"
#include "cageproof/core/coordinates/whole_evaluation.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

namespace cageproof::closed_form::batch {
namespace {

// The layers that a kind's blocks are made of, by their kernels; nothing for others.
std::optional<Layers> layers_of(const CoordinateKind& kind) {
  const auto are = [&](std::initializer_list<std::string_view> kernels) {
    return std::ranges::equal(kind.blocks, kernels, {}, &SummedBlock::kernel);
  };
  if (kind.normalised) return are({"mean_value"}) ? std::optional(Layers::MeanValue) : std::nullopt;
  if (kind.keeps_quads) return std::nullopt;
  if (are({"double_layer", "single_layer"})) return Layers::Harmonic;
  if (are({"double_layer", "single_layer", "biharmonic_double_layer", "biharmonic_single_layer"}))
    return Layers::Biharmonic;
  if (are({"kelvin_traction", "kelvin_displacement"})) return Layers::Kelvin;
  return std::nullopt;
}

constexpr std::string_view kName = "batched";

// Cages beyond this unit, or below one over it, are left to sums of closed forms: powers of it leave double's range.
constexpr int kLargestExponent = 240;
// Blocks of points that a thread takes at a time.
constexpr std::size_t kChunk = 16;
// Numbers that caches keep for whoever takes them next.
constexpr std::size_t kCached = 4000000;
// Numbers of a point below which its row is not sent past them: parts of lines cost more than they save.
constexpr std::size_t kShortRow = 256;
// Faces from which on points are taken in an order in which neighbours are near each other. Fewer faces are mostly seen
// alike by all points of a cage.
constexpr std::size_t kManyFaces = 256;

// Factors on triangle cages: 1/(4 pi) for harmonic layers and Kelvin's, 1/(8 pi) for biharmonic ones, and a third of
// that for psibar's values.
struct Space {
  using Geometry = batch::Geometry;
  using Runner = BlockRunner;
  static constexpr int dimension = 3;
  static constexpr std::array<int, 3> kept{1, 3, 6};
  static double factor(int order, std::size_t b) {
    return (b == 3 && order == 0 ? 1. / 3 : 1.) / ((b >= 2 ? 8 : 4) * pi<double>());
  }
};

// Factors on polygons: 1/(2 pi) and 1/(8 pi).
struct Plane {
  using Geometry = Polygon;
  using Runner = PlaneRunner;
  static constexpr int dimension = 2;
  static constexpr std::array<int, 3> kept{1, 2, 3};
  static double factor(int, std::size_t b) { return 1 / ((b >= 2 ? 8 : 2) * pi<double>()); }
};

template <class Shape>
class BatchedCoordinates final : public BesideSums, public AppliesData {
 public:
  BatchedCoordinates(Layers layers, std::shared_ptr<const CageElements> elements, const CoordinateOptions& options,
                     std::shared_ptr<const PreparedCoordinates> summed)
      : BesideSums(std::move(summed), Shape::dimension),
        layers_(layers),
        elements_(std::move(elements)),
        geometry_(*elements_),
        tree_([this] { return tree(); }) {
    if (layers_ == Layers::Kelvin) {
      mu_ = options.parameters[0];
      const double nu = options.parameters[1];
      if (!std::isinf(nu)) beta_ = Mp200(1) / (Mp200(2) * (Mp200(1) - Mp200(nu)));
    }
  }

  std::string evaluation() const override { return std::string(kName); }
  using BesideSums::fill;
  void fill(std::span<const Vec3<double>> points, int order, std::span<CoordinateTable<double>> tables) const override {
    if (!computes(order)) return fill_with_sums(points, order, tables);
    std::size_t numbers = 0;
    for (const CoordinateTable<double>& table : tables)
      for (const std::vector<double>& tensor : table.tensors) numbers += tensor.size();
    over_blocks(
        points, order,
        [&](const double* columns, const Request& request, std::span<const long> rows) {
          for (int o = 0; o <= order; ++o)
            for (std::size_t b = 0; b < blocks().size(); ++b)
              store(tables[b], rows, request, o, b, columns, numbers > kCached && tables[b].stride[o] >= kShortRow);
        },
        [&](std::size_t p, const std::vector<CoordinateTable<double>>& own) {
          for (int o = 0; o <= order; ++o)
            for (std::size_t b = 0; b < own.size(); ++b)
              std::ranges::copy(own[b].tensors[o],
                                tables[b].tensors[o].begin() + static_cast<std::ptrdiff_t>(p * tables[b].stride[o]));
        });
  }

  const AppliesData* products(int order) const override { return computes(order) ? this : nullptr; }
  void apply(std::span<const Vec3<double>> points, int order, const CageData& data,
             AppliedTable& table) const override {
    over_blocks(
        points, order,
        [&](const double* columns, const Request& request, std::span<const long> rows) {
          for (int o = 0; o <= order; ++o)
            for (std::size_t b = 0; b < blocks().size(); ++b)
              kernels().multiply({.to = table.tensors[o].data(),
                                  .stride = static_cast<long>(table.stride[o]),
                                  .point = rows.data(),
                                  .coordinates = blocks()[b].size,
                                  .rows = blocks()[b].shape.rows,
                                  .columns = blocks()[b].shape.columns,
                                  .sets = data.sets,
                                  .width = static_cast<int>(derivative_count(Shape::dimension, o)),
                                  .from = columns + at(request, o, b),
                                  .data = data.blocks[b].data(),
                                  .factor = factor(o, b)},
                                 static_cast<int>(rows.size()));
        },
        [&](std::size_t p, const std::vector<CoordinateTable<double>>& own) {
          for (int o = 0; o <= order; ++o) {
            const auto to = std::span(table.tensors[o]).subspan(p * table.stride[o], table.stride[o]);
            std::ranges::fill(to, 0.0);
            for (std::size_t b = 0; b < own.size(); ++b)
              add_products(own[b].tensors[o], blocks()[b], data.blocks[b], data.sets,
                           derivative_count(Shape::dimension, o), to);
          }
        });
  }

  std::unique_ptr<const StatedSum> sum_to(double error, const CageData& data, std::size_t points) const override {
    if (Shape::dimension != 3 || layers_ != Layers::Harmonic || data.sets != 3 || !computes(0)) return nullptr;
    return clustered_sum(tree_, static_cast<int>(elements_->count()), *this, data, error, points);
  }

 private:
  std::shared_ptr<const ClusterTree> tree() const {
    if constexpr (Shape::dimension == 3) return std::make_shared<const ClusterTree>(geometry_);
    else return nullptr;
  }

  bool computes(int order) const {
    return order <= 2 && geometry_.is_sound() && std::abs(geometry_.exponent()) <= kLargestExponent;
  }

  Request request_for(int order) const {
    const auto high = static_cast<double>(beta_);
    Request request{layers_, order, {high, static_cast<double>(Mp200(beta_ - high))}, beta_, {}};
    for (int o = 0; o <= order; ++o)
      for (std::size_t b = 0; b < blocks().size(); ++b) {
        request.layout.first[o][b] = request.layout.count;
        request.layout.count += blocks()[b].size * blocks()[b].entries() * Shape::kept[o];
      }
    return request;
  }
  static std::ptrdiff_t at(const Request& request, int order, std::size_t b) {
    return static_cast<std::ptrdiff_t>(request.layout.first[order][b]) * kernels().lanes;
  }

  // The product of the shape's factor, of one over mu for K, and of the unit.
  double factor(int order, std::size_t b) const {
    if (layers_ == Layers::MeanValue) return std::ldexp(1., -order * geometry_.exponent());
    double factor = Shape::factor(order, b);
    if (layers_ == Layers::Kelvin && b == 1) factor /= mu_;
    return std::ldexp(factor, (blocks()[b].degree - order) * geometry_.exponent());
  }

  // A thread takes this for one block after another.
  struct Running {
    Running(const BatchedCoordinates& of, int order)
        : request(of.request_for(order)), runner(of.geometry_, *of.elements_, request) {}
    const Request request;
    typename Shape::Runner runner;
    std::vector<Vec3<double>> here;
    std::vector<long> rows;
  };

  // put(columns, request, the block's points) takes each block; alone(point, its tables) each point that blocks leave
  // out.
  template <class Put, class Alone>
  void over_blocks(std::span<const Vec3<double>> points, int order, Put put, Alone alone) const {
    const std::size_t lanes = kernels().lanes, count = (points.size() + lanes - 1) / lanes;
    const bool many = elements_->count() >= kManyFaces, sorted = many && points.size() > lanes;
    const std::vector<std::size_t> order_of = sorted ? along_a_curve(points) : std::vector<std::size_t>();
    for_ranges_parallel(count, kChunk, [&](std::size_t begin, std::size_t end) {
      auto held = running_[order].taken();
      if (*held == nullptr) *held = std::make_unique<Running>(*this, order);
      auto& [request, runner, here, rows] = **held;
      for (std::size_t i = begin; i < end; ++i) {
        here.clear();
        rows.clear();
        for (std::size_t p = i * lanes; p < std::min((i + 1) * lanes, points.size()); ++p) {
          rows.push_back(static_cast<long>(sorted ? order_of[p] : p));
          here.push_back(points[rows.back()]);
        }
        const unsigned left = runner.run(here);
        put(runner.columns(), request, std::span<const long>(rows));
        for (std::size_t p = 0; left != 0 && p < here.size(); ++p)
          if ((left >> p & 1u) != 0) alone(static_cast<std::size_t>(rows[p]), left_at(here[p], request, runner));
      }
      // Many faces take little of the time to prepare, and much memory.
      if (many) (*held).reset();
    });
  }

  std::vector<CoordinateTable<double>> left_at(const Vec3<double>& point, const Request& request,
                                               typename Shape::Runner& runner) const {
    auto tables = sums_at(point, request.order);
    if constexpr (Shape::dimension == 3)
      if (layers_ != Layers::MeanValue) put_vertices_beside(point, request, runner, tables);
    return tables;
  }

  // Stores coordinates at a point on the border of faces. Only the vertices beside these have all derivatives there,
  // and the sides of a thin wall that they stand on cancel: sums over their faces get more digits than those in double
  // have.
  void put_vertices_beside(const Vec3<double>& point, const Request& request, BlockRunner& runner,
                           std::vector<CoordinateTable<double>>& tables) const {
    const std::vector<Touching> touches = elements_->touching(point);
    if (touches.empty()) return;
    std::vector<char> left_out(elements_->count(), 0), touched(elements_->vertices().size(), 0);
    for (const Touching& touch : touches) {
      left_out[touch.element] = 1;
      for (const int v : elements_->vertices_of(touch.element)) touched[v] = 1;
    }
    if (!runner.run_without(left_out, point)) return;
    auto found = zero_tables<double>(blocks(), Shape::dimension, 1, request.order);
    for (int o = 0; o <= request.order; ++o)
      for (std::size_t b = 0; b < blocks().size(); ++b) {
        if (blocks()[b].owner != Owner::Vertex) continue;
        store(found[b], std::array{0L}, request, o, b, runner.columns());
        const std::size_t width = found[b].stride[o] / touched.size();
        for (std::size_t v = 0; v < touched.size(); ++v)
          if (touched[v] == 0)
            std::copy_n(found[b].tensors[o].data() + v * width, width, tables[b].tensors[o].data() + v * width);
      }
  }

  // One order and block of columns to the rows of a block's points.
  void store(CoordinateTable<double>& table, std::span<const long> rows, const Request& request, int o, std::size_t b,
             const double* columns, bool streaming = false) const {
    kernels().store({.to = table.tensors[o].data(),
                     .stride = static_cast<long>(table.stride[o]),
                     .row = rows.data(),
                     .coordinates = blocks()[b].size,
                     .entries = blocks()[b].entries(),
                     .width = static_cast<int>(derivative_count(Shape::dimension, o)),
                     .from = columns + at(request, o, b),
                     .factor = factor(o, b),
                     .streaming = streaming},
                    static_cast<int>(rows.size()));
  }

  Layers layers_;
  std::shared_ptr<const CageElements> elements_;
  typename Shape::Geometry geometry_;
  Lazy<std::shared_ptr<const ClusterTree>> tree_;
  double mu_ = 1;
  Mp200 beta_ = 0;
  // By order. Calls for a few points would take longer to make one than to compute.
  mutable std::array<Reused<std::unique_ptr<Running>>, 3> running_;
};

const RegisterWholeEvaluation registered{
    {.name = kName,
     .description = "the whole cage for a vector of points at once; more digits next to edges and vertices",
     // Cages whose quads are kept are left to other evaluations.
     .exists =
         [](const CoordinateKind& kind, const Cage& cage) {
           return layers_of(kind) && (!kind.keeps_quads || (cage.dimension() == 3 && !cage.has_quads()));
         },
     .prepare = [](const CoordinateKind& kind, std::shared_ptr<const CageElements> elements,
                   const CoordinateOptions& options,
                   std::shared_ptr<const PreparedCoordinates> summed) -> std::shared_ptr<const PreparedCoordinates> {
       const Layers layers = *layers_of(kind);
       if (elements->dimension() == 2)
         return std::make_shared<BatchedCoordinates<Plane>>(layers, std::move(elements), options, std::move(summed));
       return std::make_shared<BatchedCoordinates<Space>>(layers, std::move(elements), options, std::move(summed));
     }}};

}  // namespace
}  // namespace cageproof::closed_form::batch
