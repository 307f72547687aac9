// SPDX-License-Identifier: MIT
// `green` coordinates: sums of layers, whose slopes by corners are known.
#include "cageproof/fast/layer_slopes.h"

#include "cageproof/core/catalogue/evaluation.h"
#include "cageproof/core/coordinates/rest_derivative.h"
#include "cageproof/core/parallel.h"

#include <algorithm>

namespace cageproof::fast {
namespace {

// The layers of one element at points, and their slopes.
class ElementSlopes {
 public:
  explicit ElementSlopes(const CageElements& elements)
      : elements_(elements),
        d_(elements.dimension()),
        single_(recommended(d_ == 3 ? "triangle.single_layer" : "segment.single_layer")),
        doubled_(recommended(d_ == 3 ? "triangle.double_layer" : "segment.double_layer")) {}

  // Calls use(point, slopes) for each point.
  template <class Use>
  void at(std::size_t element, std::span<const Vec3<double>> points, const Use& use) const {
    const auto corners = elements_.corners(element);
    const std::size_t n = points.size(), width = static_cast<std::size_t>(d_);
    std::vector<double> single(n), doubled(n * width);
    BatchOutput<double> outputs[2];
    for (BatchOutput<double>& output : outputs) output.entries = 1, output.dim = d_;
    outputs[0].tensors[0] = single.data(), outputs[0].stride[0] = 1;
    outputs[1].tensors[0] = doubled.data(), outputs[1].stride[0] = width;
    const Evaluation* const members[2]{&single_, &doubled_};
    Evaluation::together<double>(members, Batch<double>{corners, points, 0, {}}, outputs);
    for (std::size_t p = 0; p < n; ++p) {
      const double* const of = &doubled[p * width];
      use(p, d_ == 3 ? triangle_layer_slopes({corners[0], corners[1], corners[2]}, points[p], single[p],
                                             {of[0], of[1], of[2]})
                     : segment_layer_slopes({corners[0], corners[1]}, points[p], single[p], {of[0], of[1]}));
    }
  }

 private:
  static Evaluation recommended(std::string_view formula) {
    return EvaluationRegister::instance().with_role(formula, Role::Recommended).value();
  }

  const CageElements& elements_;
  int d_;
  Evaluation single_, doubled_;
};

void jvp(const CageCoordinates& coordinates, std::span<const Vec3<double>> points, std::span<const Vec3<double>> change,
         int threads, std::span<double> values) {
  const CageElements& elements = coordinates.elements();
  const ElementSlopes slopes(elements);
  const std::size_t n = elements.vertices().size(), row = n + elements.count();
  std::ranges::fill(values, 0.0);
  constexpr std::size_t together = 64;
  for_each_parallel((points.size() + together - 1) / together, threads, [&](std::size_t block) {
    const std::size_t first = block * together, count = std::min(together, points.size() - first);
    for (std::size_t e = 0; e < elements.count(); ++e) {
      const auto vertices = elements.vertices_of(e);
      slopes.at(e, points.subspan(first, count), [&](std::size_t p, const LayerSlopes& by) {
        double* const to = &values[(first + p) * row];
        for (std::size_t m = 0; m < vertices.size(); ++m) {
          const Vec3<double>& step = change[vertices[m]];
          to[n + e] += by.single[m].dot(step);
          for (std::size_t j = 0; j < vertices.size(); ++j) to[vertices[j]] += by.doubled[j][m].dot(step);
        }
      });
    }
  });
}

std::vector<Vec3<double>> vjp(const CageCoordinates& coordinates, std::span<const Vec3<double>> points,
                              std::span<const double> weights, int threads) {
  const CageElements& elements = coordinates.elements();
  const ElementSlopes slopes(elements);
  const std::size_t n = elements.vertices().size(), row = n + elements.count();
  // Each element sums over all points by itself, so that sums do not depend on threads.
  std::vector<std::array<Vec3<double>, 3>> of_corners(elements.count());
  constexpr std::size_t together = 256;
  for_each_parallel(elements.count(), threads, [&](std::size_t e) {
    const auto vertices = elements.vertices_of(e);
    of_corners[e].fill(Vec3<double>::Zero());
    for (std::size_t first = 0; first < points.size(); first += together) {
      const std::size_t count = std::min(together, points.size() - first);
      slopes.at(e, points.subspan(first, count), [&](std::size_t p, const LayerSlopes& by) {
        const double* const weight = &weights[(first + p) * row];
        for (std::size_t m = 0; m < vertices.size(); ++m) {
          of_corners[e][m] += weight[n + e] * by.single[m];
          for (std::size_t j = 0; j < vertices.size(); ++j) of_corners[e][m] += weight[vertices[j]] * by.doubled[j][m];
        }
      });
    }
  });
  std::vector<Vec3<double>> found(n, Vec3<double>::Zero());
  for (std::size_t e = 0; e < elements.count(); ++e) {
    const auto vertices = elements.vertices_of(e);
    for (std::size_t m = 0; m < vertices.size(); ++m) found[vertices[m]] += of_corners[e][m];
  }
  return found;
}

const RegisterRestDerivative registered{{.kind = "green", .jvp = jvp, .vjp = vjp}};

}  // namespace
}  // namespace cageproof::fast
