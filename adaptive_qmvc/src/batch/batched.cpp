// SPDX-License-Identifier: MIT
// Mean value coordinates of cages whose quads stay bilinear surfaces, many points at a time.
#include "chunk_sums.h"

#include "cageproof/core/coordinates/coordinate_tables.h"
#include "cageproof/core/coordinates/coordinates_in_double.h"
#include "cageproof/core/parallel.h"
#include "cageproof/core/coordinates/whole_evaluation.h"

#include <algorithm>

namespace cageproof::adaptive_qmvc::batch {
namespace {

constexpr std::string_view kName = "batched";

class BatchedQuadCoordinates final : public BesideSums, public AppliesData {
 public:
  BatchedQuadCoordinates(std::shared_ptr<const CageElements> elements,
                         std::shared_ptr<const PreparedCoordinates> summed)
      : BesideSums(std::move(summed), 3), elements_(std::move(elements)), geometry_(*elements_) {}

  std::string evaluation() const override { return std::string(kName); }
  using BesideSums::fill;
  void fill(std::span<const Vec3<double>> points, int order, std::span<CoordinateTable<double>> tables) const override {
    if (!computes(order)) return fill_with_sums(points, order, tables);
    const std::size_t stride = tables[0].stride[0];
    std::vector<double>& to = tables[0].tensors[0];
    over_chunks(points, [&](std::size_t p, const double* coordinates, std::size_t step) {
      for (std::size_t v = 0; v < stride; ++v) to[p * stride + v] = coordinates[v * step];
    });
  }

  const AppliesData* products(int order) const override { return computes(order) ? this : nullptr; }
  void apply(std::span<const Vec3<double>> points, int /*order*/, const CageData& data,
             AppliedTable& table) const override {
    const std::size_t stride = table.stride[0], sets = data.sets, vertices = blocks()[0].size;
    const std::vector<double>& from = data.blocks[0];
    over_chunks(points, [&](std::size_t p, const double* coordinates, std::size_t step) {
      double* const to = table.tensors[0].data() + p * stride;
      for (std::size_t v = 0; v < vertices; ++v)
        for (std::size_t set = 0; set < sets; ++set) to[set] += coordinates[v * step] * from[v * sets + set];
    });
  }

 private:
  bool computes(int order) const { return geometry_.is_sound() && order == 0; }

  // put: (point, its first coordinate, steps from one to the next)
  template <class Put>
  void over_chunks(std::span<const Vec3<double>> points, Put put) const {
    const std::size_t size = chunk_size(geometry_), count = (points.size() + size - 1) / size;
    for_ranges_parallel(count, 1, [&](std::size_t begin, std::size_t end) {
      ChunkSums sums(geometry_, *elements_);
      for (std::size_t i = begin; i < end; ++i) {
        const std::size_t first = i * size;
        const auto here = points.subspan(first, std::min(size, points.size() - first));
        sums.run(here);
        std::vector<char> is_left(here.size(), 0);
        for (const int p : sums.left()) is_left[p] = 1;
        for (std::size_t p = 0; p < here.size(); ++p) {
          if (is_left[p] == 0) {
            put(first + p, sums.coordinates() + p, sums.stride());
            continue;
          }
          // On the cage, and at the ends of double's range: by sums of closed forms.
          put(first + p, sums_at(here[p], 0)[0].tensors[0].data(), 1);
        }
      }
    });
  }

  std::shared_ptr<const CageElements> elements_;
  Geometry geometry_;
};

// Kinds whose one block is that kernel's weights, divided by their sum.
bool is_quad_mean_value(const CoordinateKind& kind) {
  return kind.is_sum() && kind.keeps_quads && kind.normalised && kind.blocks.size() == 1 &&
         kind.blocks.front().kernel == "mean_value";
}

const RegisterWholeEvaluation registered{
    {.name = kName,
     .description = "the line form of all quads for vectors of points that see them alike; one by one next to a quad",
     // On cages of triangles it is mean value coordinates, whose derivatives `fast` computes as well.
     .exists = [](const CoordinateKind& kind,
                  const Cage& cage) { return is_quad_mean_value(kind) && cage.has_quads(); },
     .prepare = [](const CoordinateKind&, std::shared_ptr<const CageElements> elements, const CoordinateOptions&,
                   std::shared_ptr<const PreparedCoordinates> summed) -> std::shared_ptr<const PreparedCoordinates> {
       return std::make_shared<BatchedQuadCoordinates>(std::move(elements), std::move(summed));
     }}};

}  // namespace
}  // namespace cageproof::adaptive_qmvc::batch
