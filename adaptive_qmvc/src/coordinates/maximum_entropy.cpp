// SPDX-License-Identifier: MIT
// Registers maximum entropy coordinates, whose prior is quad mean value coordinates.
#include "coordinates/maximum_entropy.h"

#include "cageproof/core/coordinates/coordinates.h"
#include "cageproof/core/coordinates/coordinates_in_double.h"

#include <memory>

namespace cageproof::adaptive_qmvc {
namespace {

class MaximumEntropy final : public CoordinatesInDouble<MaximumEntropy> {
 public:
  MaximumEntropy(const Cage& cage, const CoordinateOptions& options)
      : prior_(cage, coordinate_kind_named("quad_mean_value"), CoordinateOptions{.evaluation = options.evaluation}),
        vertices_(cage.vertices()),
        size_(cage.size()) {
    blocks_.push_back({.label = "lambda",
                       .owner = Owner::Vertex,
                       .size = static_cast<int>(vertices_.size()),
                       .shape = {},
                       .reproduces = Reproduces::Vertices});
  }
  const std::vector<CoordinateBlock>& blocks() const override { return blocks_; }
  int max_order() const override { return prior_.max_order(); }
  std::string evaluation() const override { return prior_.evaluation(); }
  bool is_exact_in(ScalarKind scalar) const override {
    return scalar != ScalarKind::Digits200 && prior_.is_exact_in(scalar);
  }

  template <Scalar R>
  void compute(std::span<const Vec3<R>> points, int order, std::span<CoordinateTable<R>> tables) const {
    Result<R> found;
    for (std::size_t p = 0; p < points.size(); ++p) {
      maximum_entropy(vertices_, prior_.at<R>(points[p], order).front(), points[p], size_, order, found);
      for (int o = 0; o <= order; ++o)
        std::ranges::copy(found.of(o),
                          tables[0].tensors[o].begin() + static_cast<std::ptrdiff_t>(p * tables[0].stride[o]));
    }
  }

 private:
  CageCoordinates prior_;
  std::vector<Vec3<double>> vertices_;
  double size_;
  std::vector<CoordinateBlock> blocks_;
};

std::shared_ptr<const PreparedCoordinates> prepare(const Cage& cage, const CoordinateOptions& options) {
  return std::make_shared<MaximumEntropy>(cage, options);
}

const RegisterCoordinateKind register_maximum_entropy{
    {.name = "maximum_entropy",
     .source = "Hormann, Sukumar 2008; [T18] Section 5",
     .normalised = true,
     .keeps_quads = true,
     .prepare = prepare,
     .missing_because = "outside the convex hull of the vertices whose quad mean value "
                        "coordinates are positive, there are no positive coordinates"}};

}  // namespace
}  // namespace cageproof::adaptive_qmvc
