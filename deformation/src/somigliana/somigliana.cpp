// SPDX-License-Identifier: MIT
// The corotational Somigliana deformer ([C23] Section 4, Eq 11), of triangulated cages and of quads that are kept.
#include "../kept_quads.h"
#include "../posed_orientation.h"
#include "corotation.h"
#include "derivative.h"
#include "parts.h"
#include "pole.h"
#include "posed_matrices.h"

#include "cageproof/core/input_error.h"
#include "cageproof/deformation/stretch.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <type_traits>

namespace cageproof::deformation {
namespace {

template <Scalar R>
class SomiglianaPosed final : public Posed<R> {
 public:
  /// \param nu of coordinates that are made of its parts; none for those that have it already
  SomiglianaPosed(int dimension, const std::vector<Vec3<R>>& vertices, Corotation<R> pose, std::optional<double> nu)
      : d_(dimension), pose_(std::move(pose)), nu_(nu) {
    report_.warnings = std::move(pose_.warnings);
    for (std::size_t v = 0; v < vertices.size(); ++v)
      turned_vertices_.push_back(pose_.of_vertices[v].transpose() * vertices[v].head(d_));
    for (std::size_t i = 0; i < pose_.tractions.size(); ++i)
      turned_tractions_.push_back(pose_.of_normals[i].transpose() * pose_.tractions[i].head(d_));
    if constexpr (std::is_same_v<R, double>)
      if (d_ == 3)
        values_ = PosedMatrices({pose_.of_vertices, turned_vertices_}, {pose_.of_normals, turned_tractions_});
  }

  const DeformationReport& report() const override { return report_; }

  // x' = T^-1 y, T = sum R_i T_i R_i^t, y = sum R_i T_i R_i^t v'_i + sum R_j K_j R_j^t s'_j; derivatives by the
  // quotient rule.
  Images<R> images(std::span<const CoordinateTable<R>> given, std::size_t points, int order) const override {
    std::vector<CoordinateTable<R>> made;
    if (nu_) made = assembled(given, *nu_);
    const std::span<const CoordinateTable<R>> coordinates = nu_ ? made : given;
    Images<R> images;
    for (int o = 0; o <= order; ++o) images.tensors[o].assign(points * d_ * derivative_count(d_, o), R(0));
    if constexpr (std::is_same_v<R, double>)
      if (d_ == 3 && order == 0) {
        for (std::size_t p = 0; p < points; ++p) {
          const auto row = [&](std::size_t b) {
            return std::span(coordinates[b].tensors[0]).subspan(p * coordinates[b].stride[0], coordinates[b].stride[0]);
          };
          Eigen::Map<Vec3<double>>(&images.tensors[0][3 * p]) = values_.image(row(0), row(1));
        }
        return images;
      }
    for (std::size_t p = 0; p < points; ++p) {
      const auto zeroth = sums(coordinates, p, 0, 0);
      const SpaceSolver<R> solver(zeroth.whole);
      const Column image = solver.solve(zeroth.image);
      std::vector<Sums> first;
      std::vector<Column> slopes;
      put(image, p, 0, 0, images);
      for (int a = 0; order >= 1 && a < d_; ++a) {
        first.push_back(sums(coordinates, p, 1, a));
        slopes.push_back(solver.solve(first[a].image - first[a].whole * image));
        put(slopes[a], p, 1, a, images);
      }
      for (int a = 0; order >= 2 && a < d_; ++a)
        for (int b = 0; b < d_; ++b) {
          const Sums second = sums(coordinates, p, 2, a * d_ + b);
          put(solver.solve(second.image - first[a].whole * slopes[b] - first[b].whole * slopes[a] -
                           second.whole * image),
              p, 2, a * d_ + b, images);
        }
    }
    return images;
  }

 private:
  using Column = SpaceVector<R>;
  struct Sums {
    SpaceMatrix<R> whole;
    Column image;
  };

  // A coordinate's matrix, one of its derivatives.
  SpaceMatrix<R> matrix_of(const CoordinateTable<R>& table, std::size_t p, std::size_t coordinate, int order,
                           int which) const {
    const std::size_t width = derivative_count(d_, order);
    const R* const from = &table.tensors[order][p * table.stride[order] + coordinate * d_ * d_ * width + which];
    SpaceMatrix<R> found(d_, d_);
    for (int i = 0; i < d_; ++i)
      for (int j = 0; j < d_; ++j) found(i, j) = from[(i * d_ + j) * width];
    return found;
  }

  Sums sums(std::span<const CoordinateTable<R>> coordinates, std::size_t p, int order, int which) const {
    Sums found{SpaceMatrix<R>::Zero(d_, d_), Column::Zero(d_)};
    for (std::size_t v = 0; v < turned_vertices_.size(); ++v) {
      const SpaceMatrix<R> turned = pose_.of_vertices[v] * matrix_of(coordinates[0], p, v, order, which);
      found.whole += turned * pose_.of_vertices[v].transpose();
      found.image += turned * turned_vertices_[v];
    }
    for (std::size_t i = 0; i < turned_tractions_.size(); ++i)
      found.image += pose_.of_normals[i] * (matrix_of(coordinates[1], p, i, order, which) * turned_tractions_[i]);
    return found;
  }

  void put(const Column& image, std::size_t p, int order, int which, Images<R>& images) const {
    const std::size_t width = derivative_count(d_, order);
    for (int c = 0; c < d_; ++c) images.tensors[order][(p * d_ + c) * width + which] = image[c];
  }

  int d_;
  Corotation<R> pose_;
  std::optional<double> nu_;
  std::vector<Column> turned_vertices_, turned_tractions_;
  PosedMatrices values_;  // of double in space
  DeformationReport report_;
};

// The parameters' order.
enum : std::size_t { kVariant, kNu, kGamma, kBalance, kBlend };

template <Scalar R>
class Somigliana final : public Deformer<R> {
 public:
  /// \param in_parts whether the coordinates serve every nu
  Somigliana(CageCoordinates coordinates, bool in_parts, const std::vector<double>& parameters)
      : coordinates_(std::move(coordinates)),
        in_parts_(in_parts),
        options_{.blend = parameters[kVariant] == 2 ? parameters[kBlend] : parameters[kVariant],
                 .nu = parameters[kNu],
                 .gamma = parameters[kGamma],
                 .balance = parameters[kBalance] == 0} {}

  std::shared_ptr<const Deformer<R>> with_parameters(const std::vector<double>& parameters) const override {
    if (!in_parts_ && parameters[kNu] != options_.nu) return nullptr;
    return std::make_shared<Somigliana>(coordinates_, in_parts_, parameters);
  }

  const CageCoordinates& coordinates() const override { return coordinates_; }
  DeformationReport prepared() const override {
    DeformationReport report;
    warn_of_pole(options_.nu, report.warnings);
    return report;
  }
  std::unique_ptr<const Posed<R>> pose(const Pose<R>& pose) const override {
    check_pose(coordinates_.elements(), pose, normals_owner(coordinates_));
    Corotation<R> corotation = corotation_of<R>(coordinates_.elements(), pose.vertices, options_);
    warn_of_orientation(coordinates_.elements(), pose.vertices, corotation.warnings);
    return std::make_unique<SomiglianaPosed<R>>(coordinates_.dimension(), pose.vertices, std::move(corotation),
                                                in_parts_ ? std::optional<double>(options_.nu) : std::nullopt);
  }

  // Bulging has none yet.
  std::unique_ptr<const PoseDerivative<R>> derivative(const Pose<R>& pose) const override {
    const CageElements& elements = coordinates_.elements();
    check_pose(elements, pose, normals_owner(coordinates_));
    if (options_.gamma != 0) return nullptr;
    return std::make_unique<SomiglianaDerivative<R>>(coordinates_.dimension(), pose.vertices,
                                                     corotation_of<R>(elements, pose.vertices, options_),
                                                     CorotationSlopes<R>(elements, pose.vertices, options_),
                                                     in_parts_ ? std::optional<double>(options_.nu) : std::nullopt);
  }

 private:
  CageCoordinates coordinates_;
  bool in_parts_;
  CorotationOptions options_;
};

// A form with a paper's misprint, which may not hang on nu as Kelvin's kernels do.
bool is_printed(const CoordinateKind& kind, const Cage& cage, const std::string& evaluation) {
  if (evaluation.empty()) return false;
  return std::ranges::any_of(formulas_of(kind, cage), [&](const Formula* formula) {
    const auto found = EvaluationRegister::instance().find(formula->name, evaluation);
    return found && found->role() == Role::Printed;
  });
}

std::string_view kind_of_somigliana(bool keeps_quads) { return keeps_quads ? "quad_somigliana" : "somigliana"; }

template <Scalar R, bool KeepsQuads>
std::shared_ptr<const Deformer<R>> prepare_somigliana(const Cage& cage, const DeformOptions& options) {
  const CoordinateKind& kind = coordinate_kind_named(kind_of_somigliana(KeepsQuads));
  const bool in_parts =
      std::ranges::find(options.varied, "nu") != options.varied.end() && !is_printed(kind, cage, options.evaluation);
  const CoordinateOptions plain{options.evaluation, options.triangulation, {1, options.parameters[kNu]}};
  return std::make_shared<Somigliana<R>>(
      in_parts ? somigliana_parts(cage, KeepsQuads, plain) : CageCoordinates(cage, kind, plain), in_parts,
      options.parameters);
}

template <bool KeepsQuads>
DeformMethod method_of_somigliana() {
  return {
      .name = kind_of_somigliana(KeepsQuads),
      .source = KeepsQuads ? "[C23] Section 4, Eq 10-15, on bilinear faces" : "[C23] Section 4, Eq 10-15",
      .keeps = "similarities",
      .kind = kind_of_somigliana(KeepsQuads),
      .parameters = {{{.name = "variant", .preset = 0, .lowest = -1, .highest = 3, .whole = true},
                      KeepsQuads ? "one rotation and stretch for all, or one for each vertex, triangle and corner of a "
                                   "quad, or between these"
                                 : "one rotation and stretch for all, or one for each vertex and element, or between "
                                   "these",
                      {"global", "local", "blend"}},
                     {{.name = "nu", .preset = 0.3, .lowest = -1, .highest = 0.5, .includes_infinity = true},
                      "Poisson's ratio"},
                     {{.name = "gamma", .preset = 0, .lowest = -1e6, .highest = 1e6}, "bulging"},
                     {{.name = "balance", .preset = 0, .lowest = -1, .highest = 2, .whole = true},
                      "whether tractions are balanced, Eq 15",
                      {"on", "off"}},
                     {{.name = "blend", .preset = 0.5, .lowest = kBelowZero, .highest = 1, .includes_highest = true},
                      "only of variant=blend, others ignore it: from global, 0, to local, 1"}},
      .with_parameters_of_kind = false,
      .has_pose_derivative = true,
      .refuses = KeepsQuads ? why_quads_are_refused : nullptr,
      .prepare = prepare_somigliana<double, KeepsQuads>,
      .prepare_in_50_digits = prepare_somigliana<Mp50, KeepsQuads>};
}

const RegisterDeformMethod somigliana{method_of_somigliana<false>()}, quad_somigliana{method_of_somigliana<true>()};

}  // namespace
}  // namespace cageproof::deformation
