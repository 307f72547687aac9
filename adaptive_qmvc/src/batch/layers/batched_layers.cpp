// SPDX-License-Identifier: MIT
// Harmonic and biharmonic layers of cages whose quads stay bilinear surfaces, many points at a time.
#include "layer_sums.h"

#include "cageproof/core/coordinates/coordinate_tables.h"
#include "cageproof/core/coordinates/coordinates_in_double.h"
#include "cageproof/core/parallel.h"
#include "cageproof/core/coordinates/whole_evaluation.h"

#include <algorithm>

namespace cageproof::adaptive_qmvc::batch {
namespace {

constexpr std::string_view kLayersName = "batched";

// Cages beyond this unit, or below one over it, are left to sums: powers of it leave double's range.
constexpr int kLargestUnit = 240;

// Points whose coordinates are stored together, and sets of data that are multiplied with them together.
constexpr std::size_t kTile = 8, kGroup = 4;
using SetGroup = double __attribute__((vector_size(kGroup * sizeof(double))));

class BatchedQuadLayers final : public BesideSums, public AppliesData {
 public:
  BatchedQuadLayers(std::shared_ptr<const CageElements> elements, std::shared_ptr<const PreparedCoordinates> summed)
      : BesideSums(std::move(summed), 3), elements_(std::move(elements)), geometry_(*elements_) {
    if (geometry_.is_sound() && std::abs(geometry_.exponent()) <= kLargestUnit)
      tables_.emplace(geometry_, *elements_, blocks().size() == 4);
  }

  std::string evaluation() const override { return std::string(kLayersName); }
  using BesideSums::fill;
  void fill(std::span<const Vec3<double>> points, int order, std::span<CoordinateTable<double>> tables) const override {
    if (!computes(order)) return fill_with_sums(points, order, tables);
    over_points(
        points,
        [&](std::size_t p, std::size_t count, const double* row) {
          // Row by row: tables are written to memory.
          for (std::size_t i = 0; i < count; ++i)
            for (CoordinateTable<double>& table : tables) {
              const std::size_t size = table.stride[0];
              std::copy_n(row, size, table.tensors[0].data() + (p + i) * size);
              row += size;
            }
        },
        [&](std::size_t p, const std::vector<CoordinateTable<double>>& own) {
          for (std::size_t b = 0; b < own.size(); ++b)
            std::ranges::copy(own[b].tensors[0],
                              tables[b].tensors[0].begin() + static_cast<std::ptrdiff_t>(p * tables[b].stride[0]));
        });
  }

  const AppliesData* products(int order) const override { return computes(order) ? this : nullptr; }
  void apply(std::span<const Vec3<double>> points, int /*order*/, const CageData& data,
             AppliedTable& table) const override {
    const std::size_t numbers = numbers_of_point();
    // By fours, [group][number][4], of all blocks together.
    const std::size_t groups = (data.sets + kGroup - 1) / kGroup;
    std::vector<SetGroup> from(groups * numbers, SetGroup{});
    std::size_t first = 0;
    for (std::size_t b = 0; b < blocks().size(); first += blocks()[b++].size)
      for (int i = 0; i < blocks()[b].size; ++i)
        for (int set = 0; set < data.sets; ++set)
          from[set / kGroup * numbers + first + i][set % kGroup] = data.blocks[b][i * data.sets + set];
    over_points(
        points,
        [&](std::size_t p, std::size_t count, const double* row) {
          for (std::size_t i = 0; i < count; ++i, row += numbers)
            for (std::size_t g = 0; g < groups; ++g) {
              SetGroup sum{};
              for (std::size_t n = 0; n < numbers; ++n) sum += row[n] * from[g * numbers + n];
              double* const to = table.tensors[0].data() + (p + i) * table.stride[0] + g * kGroup;
              for (std::size_t set = 0; set < std::min(kGroup, data.sets - g * kGroup); ++set) to[set] = sum[set];
            }
        },
        [&](std::size_t p, const std::vector<CoordinateTable<double>>& own) {
          const auto to = std::span(table.tensors[0]).subspan(p * table.stride[0], table.stride[0]);
          std::ranges::fill(to, 0.0);
          for (std::size_t b = 0; b < own.size(); ++b)
            add_products(own[b].tensors[0], blocks()[b], data.blocks[b], data.sets, 1, to);
        });
  }

 private:
  bool computes(int order) const { return tables_.has_value() && order == 0; }
  std::size_t numbers_of_point() const {
    std::size_t sum = 0;
    for (const CoordinateBlock& block : blocks()) sum += block.size;
    return sum;
  }

  // put: (first point, points, their rows: one block after the other). alone: (point, its tables), of what sums
  // leave out, which replaces what was put.
  template <class Put, class Alone>
  void over_points(std::span<const Vec3<double>> points, Put put, Alone alone) const {
    const std::size_t size = LayerSums::chunk_size(geometry_, *tables_), count = (points.size() + size - 1) / size;
    for_ranges_parallel(count, 1, [&](std::size_t begin, std::size_t end) {
      LayerSums sums(geometry_, *elements_, *tables_);
      const std::size_t numbers = numbers_of_point();
      std::vector<double> rows(kTile * numbers);
      for (std::size_t i = begin; i < end; ++i) {
        const std::size_t first = i * size;
        const auto here = points.subspan(first, std::min(size, points.size() - first));
        sums.run(here);
        for (std::size_t p = 0; p < here.size(); p += kTile) {
          const std::size_t tile = std::min(kTile, here.size() - p);
          sums.put(p, tile, rows.data(), numbers);
          put(first + p, tile, rows.data());
        }
        for (const int p : sums.left()) alone(first + p, sums_at(here[p], 0));
      }
    });
  }

  std::shared_ptr<const CageElements> elements_;
  Geometry geometry_;
  std::optional<LayerTables> tables_;  // nothing where double's range does not hold them
};

// Kinds of one double layer a vertex and one single layer a normal, and those of the biharmonic ones, too.
bool is_of_layers(const CoordinateKind& kind) {
  if (!kind.is_sum() || !kind.keeps_quads || kind.normalised) return false;
  if (kind.blocks.size() != 2 && kind.blocks.size() != 4) return false;
  for (std::size_t b = 0; b < kind.blocks.size(); ++b)
    if (kind.blocks[b].kernel != kKernels[b] || kind.blocks[b].one_a_normal != (b % 2 == 1)) return false;
  return true;
}

const RegisterWholeEvaluation registered_layers{
    {.name = kLayersName,
     .description = "lines of all quads for vectors of points that see them alike; one by one next to a quad",
     .exists = [](const CoordinateKind& kind, const Cage& cage) { return cage.dimension() == 3 && is_of_layers(kind); },
     .prepare = [](const CoordinateKind&, std::shared_ptr<const CageElements> elements, const CoordinateOptions&,
                   std::shared_ptr<const PreparedCoordinates> summed) -> std::shared_ptr<const PreparedCoordinates> {
       return std::make_shared<BatchedQuadLayers>(std::move(elements), std::move(summed));
     }}};

}  // namespace
}  // namespace cageproof::adaptive_qmvc::batch
