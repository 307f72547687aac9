// SPDX-License-Identifier: MIT
// [T24] Section 4.1.3: normal derivatives that make an energy of second derivatives on the cage least.
#include "../stretches.h"
#include "construction.h"
#include "layer_deformer.h"
#include "overlap.h"
#include "solver.h"

#include "cageproof/core/input_error.h"

#include <fmt/format.h>

#include <cmath>

namespace cageproof::deformation {
namespace {

// Of Laplacians (AHAP, laplacians), of all second derivatives (AAAP), of those along the rest normal (TP).
enum class Energy { Laplacian, Hessian, Normal };
enum class Alignment { Hard, Soft, Free, NonNegative };

// An operator of second derivatives of phi, psi, phibar and psibar at samples: as many rows per sample as it has
// numbers.
template <Scalar R>
std::array<Matrix<R>, 4> second_derivatives(Energy energy, const CageCoordinates& coordinates,
                                            const std::vector<Touching>& samples) {
  const auto tables = checked_limits<R>(coordinates, samples, 2);
  const int d = coordinates.dimension(), width = d * d;
  const int rows = energy == Energy::Hessian ? width : 1;
  const auto count = static_cast<Eigen::Index>(samples.size());
  const std::vector<Vec3<R>> normals =
      stretched_normals(Stretch::Unit, coordinates.elements(), vertices_in<R>(coordinates.elements()));
  std::array<Matrix<R>, 4> found;
  for (std::size_t b = 0; b < 4; ++b) {
    found[b] = Matrix<R>::Zero(rows * count, coordinates.blocks()[b].size);
    for (int i = 0; i < d; ++i)
      for (int j = 0; j < d; ++j) {
        const Matrix<R> along = component(tables[b], samples.size(), 2, width, i * d + j);
        for (Eigen::Index s = 0; s < count; ++s) {
          const Vec3<R>& n = normals[samples[s].element];
          if (energy == Energy::Hessian) found[b].row(rows * s + i * d + j) = along.row(s);
          else found[b].row(s) += R(n[i] * n[j]) * along.row(s);
        }
      }
  }
  return found;
}

// One column per element: sums of those of its normals, which basis functions multiply.
template <Scalar R>
Matrix<R> by_elements(const Matrix<R>& of_normals, const CageCoordinates& coordinates) {
  const CageElements& elements = coordinates.elements();
  const Owner owner = normals_owner(coordinates);
  Matrix<R> found = Matrix<R>::Zero(of_normals.rows(), static_cast<Eigen::Index>(elements.count()));
  for (std::size_t e = 0; e < elements.count(); ++e)
    for (const int share : elements.shares_of(e, owner))
      found.col(static_cast<Eigen::Index>(e)) += of_normals.col(share);
  return found;
}

// phi and psi are harmonic, so their Laplacians are exactly zero; those of phibar and psibar are phi and psi. The
// traces of Hessians would leave rounding in the first two, which outweighs the others where densities are small.
template <Scalar R>
std::array<Matrix<R>, 4> laplacians(const CageCoordinates& coordinates, const std::vector<Touching>& samples) {
  const auto tables = checked_limits<R>(coordinates, samples, 0);
  std::array<Matrix<R>, 4> found;
  for (std::size_t b = 0; b < 2; ++b) {
    found[b + 2] = component(tables[b], samples.size(), 0, 1, 0);
    found[b] = Matrix<R>::Zero(found[b + 2].rows(), found[b + 2].cols());
  }
  // The Laplacian's normal derivative is constant on elements whatever the map's own is.
  found[3] = by_elements(found[3], coordinates);
  return found;
}

// Places of parameters.
struct AlignedPlace {
  enum : std::size_t { kLevel, kEnergyLevel, kAlignment, kGammaA, kGammaD, kGammaRel, kNeumann };
};

template <Scalar R, Energy E>
class Aligned final : public LayerDeformer<R> {
 public:
  Aligned(CageCoordinates layers, const std::vector<double>& parameters)
      : LayerDeformer<R>(std::move(layers)),
        alignment_(static_cast<Alignment>(static_cast<int>(parameters[AlignedPlace::kAlignment]))),
        gamma_a_(parameters[AlignedPlace::kGammaA]) {
    const CageCoordinates& coordinates = this->coordinates();
    const std::array weights{parameters[AlignedPlace::kGammaD], parameters[AlignedPlace::kGammaRel]};
    if (E == Energy::Laplacian && weights[0] == 0 && weights[1] == 0)
      throw InputError("ahap with gamma_d = 0: Green coordinates have no Laplacians, and none are the least");
    this->regularise(regularisation_by<R>(Construction::OneThree, coordinates,
                                          static_cast<int>(parameters[AlignedPlace::kLevel]), weights,
                                          Account::Systems));
    const std::vector<Touching> samples =
        samples_of(coordinates.elements(), static_cast<int>(parameters[AlignedPlace::kEnergyLevel]));
    samples_ = static_cast<double>(samples.size());
    const auto of =
        E == Energy::Laplacian ? laplacians<R>(coordinates, samples) : second_derivatives<R>(E, coordinates, samples);
    Matrix<R> densities(of[2].rows(), of[2].cols() + of[3].cols());
    densities << of[2], of[3];
    of_vertices_ = of[0] + densities * this->regularisation().to_vertices;
    of_normals_ = of[1] + densities * this->regularisation().to_normals;
  }

  std::shared_ptr<const Deformer<R>> with_parameters(const std::vector<double>& parameters) const override {
    if (normals_by(parameters[AlignedPlace::kNeumann]) != this->normals_of()) return nullptr;
    return std::make_shared<Aligned>(this->coordinates(), parameters);
  }

  std::unique_ptr<const Posed<R>> pose(const Pose<R>& pose) const override {
    const CageElements& elements = this->coordinates().elements();
    check_pose(elements, pose);
    DeformationReport report;
    warn_of_orientation(elements, pose.vertices, report.warnings, alignment_ != Alignment::NonNegative);
    const Matrix<R> vertices = rows_of(pose.vertices, elements.dimension());
    // The pose less a similarity, whose energy is zero.
    const Similar<R> similar = this->similar_to(vertices);
    const Matrix<R> fixed = of_vertices_ * (vertices - similar.vertices);
    Matrix<R> normals;
    if (alignment_ == Alignment::Free) {
      normals = similar.normals +
                least_squares<R>(of_normals_, Matrix<R>(-fixed), "normal derivatives of least energy", report.systems);
    } else {
      const Matrix<R> units = rows_of(this->normals_of() == Owner::Corner
                                          ? corner_normals(Stretch::Unit, elements, pose.vertices, report.warnings)
                                          : stretched_normals(Stretch::Unit, elements, pose.vertices),
                                      elements.dimension());
      report.figures.emplace_back("energy a sample, unit normals", energy(fixed, units - similar.normals));
      normals = alignment_ == Alignment::Soft ? softly_along(units, fixed, similar.normals, report)
                                              : along(units, fixed, similar.normals, report);
    }
    if (alignment_ != Alignment::NonNegative) warn_of_digits(report);
    report.figures.emplace_back("energy a sample", energy(fixed, normals - similar.normals));
    return this->with(vertices, normals, similar, std::move(report));
  }

 private:
  // Methods that know of no negative stretches speak for themselves.
  static void warn_of_digits(DeformationReport& report) {
    if (report.systems.back().is_singular())
      report.warnings.push_back(fmt::format("{}: of deficient rank, {} of {}, the solution of least norm is taken",
                                            report.systems.back().name, report.systems.back().rank,
                                            report.systems.back().columns));
    else if (report.systems.back().condition > 1e10)
      report.warnings.push_back(fmt::format("{}: the condition is {:.1e}, and images lose digits like it",
                                            report.systems.back().name, report.systems.back().condition));
  }

  // \param normals beside the similarity's
  double energy(const Matrix<R>& fixed, const Matrix<R>& normals) const {
    return static_cast<double>(R((fixed + of_normals_ * normals).squaredNorm())) / samples_;
  }

  // Eq 32 and 33. Stretches are found from those along n' that the similarity's normals have.
  Matrix<R> along(const Matrix<R>& units, const Matrix<R>& fixed, const Matrix<R>& similar,
                  DeformationReport& report) const {
    const Matrix<R> start = units.cwiseProduct(similar).rowwise().sum();
    return least_stretched<R>(of_normals_, fixed + of_normals_ * Matrix<R>(start.col(0).asDiagonal() * units - similar),
                              units, start, alignment_ == Alignment::NonNegative, report);
  }

  // Eq 34 as least squares: each coordinate's energy, and gamma_a times what is across n'.
  Matrix<R> softly_along(const Matrix<R>& units, const Matrix<R>& fixed, const Matrix<R>& similar,
                         DeformationReport& report) const {
    using std::sqrt;
    const Eigen::Index rows = of_normals_.rows(), count = units.rows(), d = units.cols();
    const R weight = sqrt(R(gamma_a_));
    Matrix<R> matrix = Matrix<R>::Zero(d * (rows + count), d * count), right = Matrix<R>::Zero(d * (rows + count), 1);
    for (Eigen::Index c = 0; c < d; ++c) {
      matrix.block(c * rows, c * count, rows, count) = of_normals_;
      right.middleRows(c * rows, rows) = -fixed.col(c);
      for (Eigen::Index t = 0; t < count; ++t)
        for (Eigen::Index k = 0; k < d; ++k) {
          const Eigen::Index row = d * rows + c * count + t;
          matrix(row, k * count + t) = weight * ((c == k ? R(1) : R(0)) - R(units(t, c) * units(t, k)));
          right(row) -= matrix(row, k * count + t) * similar(t, k);
        }
    }
    const Matrix<R> solution =
        least_squares<R>(matrix, right, "normal derivatives of least energy, softly aligned", report.systems);
    return similar + solution.reshaped(count, d);
  }

  Alignment alignment_;
  double gamma_a_, samples_ = 0;
  Matrix<R> of_vertices_, of_normals_;
};

template <Energy E, Scalar R>
std::shared_ptr<const Deformer<R>> prepare(const Cage& cage, const DeformOptions& options) {
  return std::make_shared<Aligned<R, E>>(
      layers_of(cage, options, normals_by(options.parameters[AlignedPlace::kNeumann])), options.parameters);
}

std::vector<KindParameter> aligned_parameters() {
  std::vector<KindParameter> all{
      {{.name = "level", .preset = 1, .lowest = -1, .highest = 6, .whole = true},
       "times that elements are split for samples of the regularisation"},
      {{.name = "energy_level", .preset = 1, .lowest = -1, .highest = 6, .whole = true},
       "the same of the energy, which are part of the method"},
      {{.name = "alignment", .preset = 0, .lowest = -1, .highest = 4, .whole = true},
       "of normal derivatives with posed normals; nonnegative: hard, and none points inward",
       {"hard", "soft", "free", "nonnegative"}},
      {{.name = "gamma_a", .preset = 1, .lowest = kBelowZero, .highest = 1e300}, "weight of soft alignment, per area"}};
  for (KindParameter& p : weight_parameters(Construction::OneThree)) all.push_back(std::move(p));
  all.push_back(neumann_parameter());
  return all;
}

template <Energy E>
DeformMethod method(std::string_view name) {
  return {.name = name,
          .source = "[T24] Section 4.1.3, Eq 31-36",
          .keeps =
              "similarities and mirror images (alignment=free: affine maps; nonnegative, neumann=affine: "
              "similarities alone)",
          .kind = "biharmonic",
          .parameters = aligned_parameters(),
          .coordinate_parameters = {"neumann"},
          .takes_derivatives_on_cage = E != Energy::Laplacian,
          .refuses = why_overlap_is_refused,
          .prepare = prepare<E, double>,
          .prepare_in_50_digits = prepare<E, Mp50>};
}

const RegisterDeformMethod ahap{method<Energy::Laplacian>("ahap")};
const RegisterDeformMethod aaap{method<Energy::Hessian>("aaap")};
const RegisterDeformMethod tp{method<Energy::Normal>("tp")};

}  // namespace
}  // namespace cageproof::deformation
