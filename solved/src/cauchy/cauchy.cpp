// SPDX-License-Identifier: MIT
// Cauchy coordinates: Green coordinates of the plane as complex numbers (Weber, Ben-Chen, Gotsman 2009; [W12] Section
// 5.2 after the errata).
#include "cageproof/core/geometry/box.h"
#include "cageproof/core/coordinates/coordinates.h"
#include "cageproof/core/coordinates/coordinates_in_double.h"
#include "cageproof/core/coordinates/whole_evaluation.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

namespace cageproof::solved {
namespace {

// In f(z) = sum phi_j f_j + sum psi_j d_j of Green coordinates, a similarity of the edge gives d_j = -i (f_next - f_j)
// / length_j for the outward normal. So C_j = phi_j + i (psi_j / length_j - psi_before / length_before): the complex
// number that vertex j is multiplied with. What the single layers' logarithm makes of a unit of length drops out.
//
// Many points at once take int_s Gamma_j (x.n I + n x' - x n')/(2 pi r^2) instead, the matrix of the same complex
// number and Kelvin's traction where nu is infinite: differences of logarithms over lengths lose what a short segment
// is shorter than a block's largest entry.
class CauchyCoordinates final : public CoordinatesInDouble<CauchyCoordinates>, public HasTerms {
 public:
  CauchyCoordinates(const Cage& cage, const CoordinateOptions& options)
      : exponent_(exponent_of(cage)),
        green_(in_unit(cage, exponent_), coordinate_kind_named("green"),
               CoordinateOptions{.evaluation = options.evaluation == quickest ? std::string() : options.evaluation}) {
    if (options.evaluation == quickest) {
      const CoordinateKind& tractions = coordinate_kind_named("somigliana");
      CoordinateOptions whole{.evaluation = std::string(quickest)};
      for (const KindParameter& p : parameters_of(tractions))
        whole.parameters.push_back(p.name == "nu" ? std::numeric_limits<double>::infinity() : 1);
      whole_.emplace(in_unit(cage, exponent_), tractions, whole);
    }
    const int vertices = static_cast<int>(cage.vertices().size());
    for (const auto& [label, reproduces] :
         {std::pair{"re", Reproduces::Vertices}, std::pair{"im", Reproduces::TurnedVertices}})
      blocks_.push_back({.label = label,
                         .owner = Owner::Vertex,
                         .size = vertices,
                         .shape = {},
                         .reproduces = reproduces,
                         .trace = {.kind = CoordinateBlock::Trace::Kind::Zero}});
  }

  const std::vector<CoordinateBlock>& blocks() const override { return blocks_; }
  int max_order() const override { return green_.max_order(); }
  std::string evaluation() const override { return whole_ ? whole_->evaluation() : green_.evaluation(); }
  bool is_exact_in(ScalarKind scalar) const override {
    return scalar != ScalarKind::Digits200 && green_.is_exact_in(scalar);
  }

  const HasTerms* terms() const override { return this; }
  // Both layers of each edge: next to a vertex those of its two edges are larger than their sum.
  void fill_terms(std::span<const Vec3<double>> points, int order,
                  std::span<CoordinateTable<double>> tables) const override {
    const CageElements& elements = green_.elements();
    const auto& known = EvaluationRegister::instance();
    const Evaluation of_hats = *known.with_role("segment.double_layer", Role::Recommended),
                     of_edge = *known.with_role("segment.single_layer", Role::Recommended);
    Result<double> hats, edge;
    const auto add = [&](CoordinateTable<double>& table, std::size_t p, int o, int vertex, std::span<const double> part,
                         double over) {
      for (std::size_t d = 0; d < part.size(); ++d)
        if (const double x = std::abs(std::ldexp(part[d], -o * exponent_)) / over; std::isfinite(x))
          table.tensors[o][p * table.stride[o] + vertex * part.size() + d] += x;
    };
    for (std::size_t p = 0; p < points.size(); ++p) {
      const Vec3<double> point(std::ldexp(points[p][0], -exponent_), std::ldexp(points[p][1], -exponent_), 0);
      for (std::size_t e = 0; e < elements.count(); ++e) {
        const std::vector<Vec3<double>> corners = elements.corners(e);
        const Query<double> query{corners, point, order};
        of_hats(query, hats);
        of_edge(query, edge);
        const double length = (corners[1] - corners[0]).norm();
        const auto ends = elements.vertices_of(e);
        for (int o = 0; o <= order; ++o) {
          const std::size_t width = derivative_count(2, o);
          for (std::size_t k = 0; k < 2; ++k) {
            add(tables[0], p, o, ends[k], std::span(hats.of(o)).subspan(k * width, width), 1);
            add(tables[1], p, o, ends[k], edge.of(o), length);
          }
        }
      }
    }
  }

  template <Scalar R>
  void compute(std::span<const Vec3<R>> points, int order, std::span<CoordinateTable<R>> tables) const {
    using std::hypot, std::ldexp;
    std::vector<Vec3<R>> scaled;
    for (const Vec3<R>& p : points) scaled.push_back(Vec3<R>(ldexp(p[0], -exponent_), ldexp(p[1], -exponent_), R(0)));
    if constexpr (std::same_as<R, double>)
      if (whole_) return take_tractions(scaled, order, tables);
    const auto green = green_.at<R>(scaled, order);
    const CageElements& elements = green_.elements();
    for (int o = 0; o <= order; ++o) {
      const std::size_t width = derivative_count(2, o), stride = tables[0].stride[o];
      for (std::size_t i = 0; i < green[0].tensors[o].size(); ++i)
        tables[0].tensors[o][i] = ldexp(green[0].tensors[o][i], -o * exponent_);
      for (std::size_t e = 0; e < elements.count(); ++e) {
        const auto ends = elements.vertices_of(e);
        const Vec3<R> along = convert<R>(elements.vertices()[ends[1]]) - convert<R>(elements.vertices()[ends[0]]);
        const R length = hypot(along[0], along[1]);
        for (std::size_t p = 0; p < points.size(); ++p)
          for (std::size_t d = 0; d < width; ++d) {
            const R part =
                ldexp(R(green[1].tensors[o][p * green[1].stride[o] + e * width + d] / length), -o * exponent_);
            R* const at = &tables[1].tensors[o][p * stride + d];
            at[ends[0] * width] += part;
            at[ends[1] * width] -= part;
          }
      }
    }
  }

 private:
  /// \param scaled points in units of 2^exponent_
  void take_tractions(std::span<const Vec3<double>> scaled, int order,
                      std::span<CoordinateTable<double>> tables) const {
    const auto tractions = whole_->at<double>(scaled, order);
    constexpr std::size_t real = 0, imaginary = 2, entries = 4;  // of a matrix, row by row
    const auto vertices = static_cast<std::size_t>(blocks_[0].size);
    for (int o = 0; o <= order; ++o) {
      const std::size_t width = derivative_count(2, o);
      for (std::size_t p = 0; p < scaled.size(); ++p)
        for (std::size_t v = 0; v < vertices; ++v) {
          const double* const matrix = &tractions[0].tensors[o][p * tractions[0].stride[o] + v * entries * width];
          for (std::size_t d = 0; d < width; ++d) {
            const std::size_t at = p * tables[0].stride[o] + v * width + d;
            tables[0].tensors[o][at] = std::ldexp(matrix[real * width + d], -o * exponent_);
            tables[1].tensors[o][at] = std::ldexp(matrix[imaginary * width + d], -o * exponent_);
          }
        }
    }
  }

  // The exponent of the largest extent: in a unit of that size, logarithms are as small as possible.
  static int exponent_of(const Cage& cage) {
    const auto [low, high] = box_of(cage.vertices());
    return std::ilogb((high - low).maxCoeff());
  }

  // In units of 2^exponent, exactly.
  static Cage in_unit(const Cage& cage, int exponent) {
    std::vector<Vec3<double>> vertices;
    for (const Vec3<double>& v : cage.vertices())
      vertices.emplace_back(std::ldexp(v[0], -exponent), std::ldexp(v[1], -exponent), 0);
    return cage.with(std::move(vertices), cage.faces());
  }

  int exponent_;
  CageCoordinates green_;
  std::optional<CageCoordinates> whole_;  // of many points at once
  std::vector<CoordinateBlock> blocks_;
};

const RegisterCoordinateKind register_cauchy{
    {.name = "cauchy",
     .source = "Weber, Ben-Chen, Gotsman 2009; [W12] Section 5.2 after the errata",
     .own_dimension = 2,
     .prepare = [](const Cage& cage, const CoordinateOptions& options) -> std::shared_ptr<const PreparedCoordinates> {
       return std::make_shared<CauchyCoordinates>(cage, options);
     },
     .made_of_sums = true}};

}  // namespace
}  // namespace cageproof::solved
