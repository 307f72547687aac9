// SPDX-License-Identifier: MIT
// Complex biharmonic coordinates of polygons ([W12] Section 5.2 after the errata): biharmonic_boundary where each
// edge's normal derivative is that of the similarity of the edge.
#include "../boundary/boundary_coordinates.h"
#include "../boundary/boundary_parameters.h"
#include "../boundary/collocation.h"

#include "cageproof/core/coordinates/coordinates_in_double.h"

namespace cageproof::solved {
namespace {

// In f = sum alpha_j f_j + sum beta_j d_j a similarity of the edge gives d_j = -i (f_next - f_j)/length_j for the
// outward normal. So C_j = alpha_j + i (beta_j/length_j - beta_before/length_before).
class ComplexBiharmonic final : public CoordinatesInDouble<ComplexBiharmonic>,
                                public SolvesSystems,
                                public HasLimits,
                                public HasTerms {
 public:
  ComplexBiharmonic(const Cage& cage, const CoordinateOptions& options)
      : real_(cage, coordinate_kind_named("biharmonic_boundary"), options) {
    for (const auto& [label, reproduces] :
         {std::pair{"re", Reproduces::Vertices}, std::pair{"im", Reproduces::TurnedVertices}})
      blocks_.push_back({.label = label,
                         .owner = Owner::Vertex,
                         .size = static_cast<int>(cage.vertices().size()),
                         .shape = {},
                         .reproduces = reproduces});
  }

  const std::vector<CoordinateBlock>& blocks() const override { return blocks_; }
  int max_order() const override { return real_.max_order(); }
  std::string evaluation() const override { return real_.evaluation(); }
  bool is_exact_in(ScalarKind scalar) const override { return real_.is_exact_in(scalar); }
  bool is_prompt_in(ScalarKind scalar) const override { return real_.is_prompt_in(scalar); }
  const SolvesSystems* systems() const override { return this; }
  const HasLimits* limits() const override { return this; }
  const HasTerms* terms() const override { return this; }
  std::vector<SolvedSystem> solved() const override { return real_.solved(); }

  void fill_limits(std::span<const Touching> places, int order,
                   std::span<CoordinateTable<double>> tables) const override {
    put<double>(real_.limits_at<double>(places, order), places.size(), order, -1, tables);
  }
  void fill_limits(std::span<const Touching> places, int order,
                   std::span<CoordinateTable<Mp50>> tables) const override {
    put<Mp50>(real_.limits_at<Mp50>(places, order), places.size(), order, -1, tables);
  }

  // Both edges' terms of a vertex add up.
  void fill_terms(std::span<const Vec3<double>> points, int order,
                  std::span<CoordinateTable<double>> tables) const override {
    std::vector<CoordinateTable<double>> terms(2);
    for (std::size_t p = 0; p < points.size(); ++p) {
      const std::vector<Result<double>> here = real_.terms_at(points[p], order);
      for (std::size_t b = 0; b < 2; ++b)
        for (int o = 0; o <= order; ++o) {
          const std::span<const double> values(here[b].of(o));
          terms[b].stride[o] = values.size();
          terms[b].tensors[o].insert(terms[b].tensors[o].end(), values.begin(), values.end());
        }
    }
    put<double>(terms, points.size(), order, 1, tables);
  }

  template <Scalar R>
  void compute(std::span<const Vec3<R>> points, int order, std::span<CoordinateTable<R>> tables) const {
    put<R>(real_.at<R>(points, order), points.size(), order, -1, tables);
  }

 private:
  /// \param at_end of an edge: its sign there
  template <Scalar R>
  void put(const std::vector<CoordinateTable<R>>& real, std::size_t points, int order, int at_end,
           std::span<CoordinateTable<R>> tables) const {
    using std::hypot;
    const CageElements& elements = real_.elements();
    for (int o = 0; o <= order; ++o) {
      const std::size_t width = derivative_count(2, o), stride = tables[0].stride[o];
      for (std::size_t i = 0; i < points * stride; ++i) tables[0].tensors[o][i] = real[0].tensors[o][i];
      for (std::size_t e = 0; e < elements.count(); ++e) {
        const auto ends = elements.vertices_of(e);
        const Vec3<R> along = convert<R>(elements.vertices()[ends[1]]) - convert<R>(elements.vertices()[ends[0]]);
        const R length = hypot(along[0], along[1]);
        for (std::size_t p = 0; p < points; ++p)
          for (std::size_t d = 0; d < width; ++d) {
            const R part = real[1].tensors[o][p * real[1].stride[o] + e * width + d] / length;
            R* const at = &tables[1].tensors[o][p * stride + d];
            at[ends[0] * width] += part;
            at[ends[1] * width] += R(at_end) * part;
          }
      }
    }
  }

  CageCoordinates real_;
  std::vector<CoordinateBlock> blocks_;
};

std::vector<KindParameter> complex_parameters() {
  std::vector<KindParameter> all =
      boundary_parameters(collocations(), "where the boundary's equations are asked to hold");
  all.push_back(unit_parameter());
  return all;
}

const RegisterCoordinateKind register_biharmonic_complex{
    {.name = "biharmonic_complex",
     .source = "[W12] Section 5.2 after the errata",
     .own_dimension = 2,
     .prepare = [](const Cage& cage, const CoordinateOptions& options) -> std::shared_ptr<const PreparedCoordinates> {
       return std::make_shared<ComplexBiharmonic>(cage, options);
     },
     .parameters = complex_parameters(),
     .refuses = why_not_refined}};

}  // namespace
}  // namespace cageproof::solved
