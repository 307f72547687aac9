// SPDX-License-Identifier: MIT
// The regularised biharmonic coordinates of [T24] Eq 27: alpha = phi + phibar C11 + psibar C12 of vertices, beta = psi
// + phibar C21 + psibar C22 of elements.
#include "construction.h"
#include "overlap.h"

#include "cageproof/core/coordinates/coordinates_in_double.h"

#include <mutex>
#include <tuple>

namespace cageproof::deformation {
namespace {

class RegularisedCoordinates final : public CoordinatesInDouble<RegularisedCoordinates>,
                                     public SolvesSystems,
                                     public HasLimits,
                                     public HasTerms {
 public:
  RegularisedCoordinates(Construction construction, const Cage& cage, const CoordinateOptions& options)
      : construction_(construction),
        layers_(cage, coordinate_kind_named("biharmonic"),
                CoordinateOptions{options.evaluation, options.triangulation, {}}),
        parameters_(options.parameters) {
    const CageElements& elements = layers_.elements();
    blocks_ = {{.label = "alpha",
                .owner = Owner::Vertex,
                .size = static_cast<int>(elements.vertices().size()),
                .shape = {},
                .reproduces = Reproduces::Vertices},
               {.label = "beta",
                .owner = Owner::Element,
                .size = static_cast<int>(elements.count()),
                .shape = {},
                .reproduces = Reproduces::Normals,
                .degree = 1}};
    densities<double>();
  }

  const std::vector<CoordinateBlock>& blocks() const override { return blocks_; }
  int max_order() const override { return layers_.max_order(); }
  std::string evaluation() const override { return layers_.evaluation(); }
  // Densities have 50 digits at most.
  bool is_exact_in(ScalarKind scalar) const override {
    return scalar != ScalarKind::Digits100 && scalar != ScalarKind::Digits200 && layers_.is_exact_in(scalar);
  }
  bool is_prompt_in(ScalarKind scalar) const override {
    if (scalar == ScalarKind::Float || scalar == ScalarKind::Double) return true;
    const auto samples = static_cast<double>(samples_of(layers_.elements(), level()).size());
    const double unknowns = blocks_[0].size + blocks_[1].size;
    return 2 * samples * unknowns * unknowns < 1e5;
  }
  const SolvesSystems* systems() const override { return this; }
  const HasLimits* limits() const override { return this; }
  const HasTerms* terms() const override { return this; }
  std::vector<SolvedSystem> solved() const override {
    return takes_50_digits() ? regularisation<Mp50>(Account::Systems).solved : solved_in_double();
  }

  void fill_limits(std::span<const Touching> places, int order,
                   std::span<CoordinateTable<double>> tables) const override {
    put<double>(layers_.limits_at<double>(places, order), places.size(), order, tables);
  }
  void fill_limits(std::span<const Touching> places, int order,
                   std::span<CoordinateTable<Mp50>> tables) const override {
    put<Mp50>(layers_.limits_at<Mp50>(places, order), places.size(), order, tables);
  }

  void fill_terms(std::span<const Vec3<double>> points, int order,
                  std::span<CoordinateTable<double>> tables) const override {
    std::call_once(terms_made_, [&] {
      if (!takes_50_digits()) {
        terms_ = transposed(regularisation<double>(Account::Terms).terms);
        return;
      }
      // Nothing but the densities themselves is rounded.
      const Densities<double>& known = densities<double>();
      terms_ = {known.of_vertices.cwiseAbs(), known.of_elements.cwiseAbs()};
    });
    for (std::size_t p = 0; p < points.size(); ++p) {
      const std::vector<Result<double>> layers = layers_.terms_at(points[p], order);
      put_point<double>(
          terms_, p, order, [&](std::size_t b, int o) { return layers[b].of(o).data(); }, tables);
    }
  }

  template <Scalar R>
  void compute(std::span<const Vec3<R>> points, int order, std::span<CoordinateTable<R>> tables) const {
    put<R>(layers_.at<R>(points, order), points.size(), order, tables);
  }

 private:
  // Transposed: rows are coordinates, columns the densities of phibar, then those of psibar.
  template <Scalar R>
  struct Densities {
    Matrix<R> of_vertices, of_elements;
  };
  template <Scalar R>
  struct Prepared {
    std::once_flag once;
    Densities<R> densities;
  };

  int level() const { return static_cast<int>(parameters_[0]); }
  bool takes_50_digits() const {
    std::call_once(digits_chosen_, [&] {
      takes_50_digits_ =
          deformation::takes_50_digits(construction_, layers_, level(), [&] { return solved_in_double(); });
    });
    return takes_50_digits_;
  }

  std::vector<SolvedSystem> solved_in_double() const { return regularisation<double>(Account::Systems).solved; }

  template <Scalar R>
  Regularisation<R> regularisation(Account account) const {
    return regularisation_by<R>(construction_, layers_, level(), std::span(parameters_).subspan(1), account);
  }

  template <Scalar R>
  Densities<R> transposed(const Matrix<R>& to) const {
    return {to.leftCols(blocks_[0].size).transpose(), to.rightCols(blocks_[1].size).transpose()};
  }

  template <Scalar R>
  const Densities<R>& densities() const {
    Prepared<R>& made = std::get<Prepared<R>>(prepared_);
    std::call_once(made.once, [&] {
      if (std::same_as<R, Mp100> || (std::same_as<R, double> && takes_50_digits())) {
        const Densities<Mp50>& known = densities<Mp50>();
        made.densities = {known.of_vertices.template cast<R>(), known.of_elements.template cast<R>()};
      } else if constexpr (!std::same_as<R, Mp100>) {
        const Regularisation<R> found = regularisation<R>(Account::None);
        made.densities = {found.to_vertices.transpose(), found.to_normals.transpose()};
      }
    });
    return made.densities;
  }

  template <Scalar R>
  void put(const std::vector<CoordinateTable<R>>& layers, std::size_t points, int order,
           std::span<CoordinateTable<R>> tables) const {
    const Densities<R>& known = densities<R>();
    for (std::size_t p = 0; p < points; ++p)
      put_point<R>(
          known, p, order, [&](std::size_t b, int o) { return &layers[b].tensors[o][p * layers[b].stride[o]]; },
          tables);
  }

  // Eq 27 at point p: `layer(b, o)` are the derivatives of order o of phi, psi, phibar and psibar there.
  template <Scalar R, class Layer>
  void put_point(const Densities<R>& known, std::size_t p, int order, const Layer& layer,
                 std::span<CoordinateTable<R>> tables) const {
    using Rows = Eigen::Matrix<R, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;
    const Eigen::Index vertices = blocks_[0].size, elements = blocks_[1].size;
    for (int o = 0; o <= order; ++o) {
      const auto width = static_cast<Eigen::Index>(derivative_count(layers_.dimension(), o));
      const auto rows_of_layer = [&](std::size_t b, Eigen::Index count) {
        return Eigen::Map<const Rows>(layer(b, o), count, width);
      };
      Matrix<R> free(vertices + elements, width);
      free << rows_of_layer(2, vertices), rows_of_layer(3, elements);
      const auto put_block = [&](std::size_t b, Eigen::Index count, const Matrix<R>& of) {
        Eigen::Map<Rows> into(&tables[b].tensors[o][p * tables[b].stride[o]], count, width);
        into = rows_of_layer(b, count);
        into.noalias() += of * free;
      };
      put_block(0, vertices, known.of_vertices);
      put_block(1, elements, known.of_elements);
    }
  }

  Construction construction_;
  CageCoordinates layers_;
  std::vector<double> parameters_;
  std::vector<CoordinateBlock> blocks_;
  mutable std::tuple<Prepared<double>, Prepared<Mp50>, Prepared<Mp100>> prepared_;
  mutable std::once_flag digits_chosen_;
  mutable bool takes_50_digits_ = false;
  mutable std::once_flag terms_made_;
  mutable Densities<double> terms_;
};

template <Construction C>
CoordinateKind kind(std::string_view name, std::string_view source) {
  std::vector<KindParameter> parameters{level_parameter()};
  for (KindParameter& p : weight_parameters(C)) parameters.push_back(std::move(p));
  return {
      .name = name,
      .source = source,
      .own_dimension = 0,
      .prepare = [](const Cage& cage, const CoordinateOptions& options) -> std::shared_ptr<const PreparedCoordinates> {
        return std::make_shared<RegularisedCoordinates>(C, cage, options);
      },
      .parameters = std::move(parameters),
      .solves_on_samples = true,
      .refuses = why_overlap_is_refused,
      .made_of_sums = true};
}

const RegisterCoordinateKind one_three_kind{
    kind<Construction::OneThree>("regularised_1_3", "[T24] Section 4.1, Eq 20-30")};
const RegisterCoordinateKind one_two_kind{
    kind<Construction::OneTwo>("regularised_1_2", "[T24] Appendix D.1, after the errata")};
const RegisterCoordinateKind weber_kind{
    kind<Construction::Weber>("regularised_weber", "[T24] Appendix D.2, after the errata")};

}  // namespace
}  // namespace cageproof::deformation
