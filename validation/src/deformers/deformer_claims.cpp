// SPDX-License-Identifier: MIT
#include "deformers/deformer_claims.h"

#include "cageproof/core/cage/embedded_cages.h"
#include "cageproof/deformation/deformer.h"
#include "deformer_campaign.h"

#include <algorithm>
#include <limits>
#include <string_view>

namespace cageproof::validation {
namespace {

using Points = std::vector<Vec3<double>>;

constexpr std::string_view claims_cage = "cube";
constexpr int claims_points = 16;

Points times(double factor, Points points) {
  for (Vec3<double>& p : points) p *= factor;
  return points;
}

Cage cage_times(double factor) {
  const Cage cage = embedded_cage(claims_cage);
  return cage.with(times(factor, cage.vertices()), cage.faces());
}

Points points_in(const Cage& cage) { return interior_points(cage, Triangulation::Shortest, 1, claims_points); }

Points rest_points() { return points_in(embedded_cage(claims_cage)); }

Points images_of(std::string_view method, std::vector<double> parameters, const Cage& cage, const Points& posed,
                 const Points& points) {
  const auto deformer = deformation::prepare_deformer<double>(deformation::deform_method_named(method), cage,
                                                              {.parameters = std::move(parameters)});
  const auto images = deformer->images(*deformer->pose({posed}), std::span(points), 0);
  const int d = cage.dimension();
  Points found(points.size(), Vec3<double>::Zero());
  for (std::size_t p = 0; p < points.size(); ++p)
    for (int c = 0; c < d; ++c) found[p][c] = images.tensors[0][d * p + c];
  return found;
}

// In sizes of the cage.
double largest(const Points& a, const Points& b, std::string_view cage = claims_cage) {
  double found = 0;
  for (std::size_t p = 0; p < a.size(); ++p) found = std::max(found, (a[p] - b[p]).norm());
  return found / embedded_cage(cage).size();
}

// The parameters of biharmonic_1_3: level, normals (unit or rms), gamma_d, gamma_rel.
constexpr double kLevel = 1, kUnit = 3, kRms = 0;

Points one_three(double gamma_d) {
  const Cage cage = embedded_cage(claims_cage);
  return images_of("biharmonic_1_3", {kLevel, kUnit, gamma_d, 0}, cage, bent(cage), rest_points());
}

void measure_limit(ErratumRow& row) {
  const Cage cage = embedded_cage(claims_cage);
  const Points small = one_three(1e-9);
  row.printed_error = largest(small, images_of("green", {kUnit}, cage, bent(cage), rest_points()));
  row.corrected_error = largest(small, one_three(1e-7));
}

// Images in a unit ten times smaller, taken back.
double change_with_unit(double gamma_d, double gamma_rel) {
  const Cage cage = embedded_cage(claims_cage);
  const std::vector<double> parameters{kLevel, kUnit, gamma_d, gamma_rel};
  const Points here = images_of("biharmonic_1_3", parameters, cage, bent(cage), rest_points());
  const Points there =
      images_of("biharmonic_1_3", parameters, cage_times(10), times(10, bent(cage)), times(10, rest_points()));
  return largest(here, times(0.1, there));
}

void measure_unit(ErratumRow& row) {
  row.printed_error = change_with_unit(1, 0);
  row.corrected_error = change_with_unit(1, 1);
}

double change_with_scale(double normals) {
  const Cage cage = embedded_cage(claims_cage);
  return largest(images_of("biharmonic_1_3", {kLevel, normals, 1, 0}, cage, times(1.5, cage.vertices()), rest_points()),
                 times(1.5, rest_points()));
}

void measure_scale(ErratumRow& row) {
  row.printed_error = change_with_scale(kUnit);
  row.corrected_error = change_with_scale(kRms);
}

// The distance of infinite nu without bulging from the nearest Green deformer, by its stretch; the worse of both
// variants.
double infinite_nu_off_green(std::string_view name) {
  const Cage cage = embedded_cage(name);
  const Points points = points_in(cage), posed = bent(cage);
  constexpr double global = 0, local = 1, bulging = 0, balanced = 0, blend = 0.5;
  double worst = 0;
  for (const double variant : {global, local}) {
    const Points found =
        images_of("somigliana", {variant, std::numeric_limits<double>::infinity(), bulging, balanced, blend}, cage,
                  posed, points);
    double nearest = std::numeric_limits<double>::infinity();
    for (double stretch = 0; stretch < 4; ++stretch)
      nearest = std::min(nearest, largest(found, images_of("green", {stretch}, cage, posed, points), name));
    worst = std::max(worst, nearest);
  }
  return worst;
}

void measure_infinite_nu(ErratumRow& row) {
  row.printed_error = infinite_nu_off_green(claims_cage);
  row.corrected_error = infinite_nu_off_green("square");
}

DeformerClaim measured(std::string source, std::string printed, std::string correct, std::string parameters,
                       void (*measure)(ErratumRow&)) {
  DeformerClaim claim;
  claim.row = {.source = std::move(source),
               .printed = std::move(printed),
               .correct = std::move(correct),
               .formula = "biharmonic_1_3",
               .evaluation = std::move(parameters),
               .regime = std::string(claims_cage),
               .samples = claims_points};
  claim.measure = measure;
  return claim;
}

DeformerClaim infinite_nu() {
  DeformerClaim claim = measured(
      "[C23] Section 5, Figure 7", "nu = +-infinity without bulging is Green's, in the plane; in space it is not",
      "so it is: no stretch of green in space gives it (as printed), one in the plane does (corrected)", "nu=inf",
      measure_infinite_nu);
  claim.row.formula = "somigliana";
  claim.row.regime = "cube, and square";
  return claim;
}

DeformerClaim told(std::string source, std::string printed, std::string correct) {
  DeformerClaim claim;
  claim.row.source = std::move(source);
  claim.row.printed = std::move(printed);
  claim.row.correct = std::move(correct);
  return claim;
}

}  // namespace

const std::vector<DeformerClaim>& deformer_claims() {
  static const std::vector<DeformerClaim> claims{
      measured("[T24] after Eq 30", "gamma_D = 0 results in Green coordinates; nothing is said of small gamma_D",
               "f jumps at 0: small gamma_D tend to the densities that leave no Laplacian misfit and fit values best, "
               "and 0 takes none at all",
               "gamma_d=1e-9", measure_limit),
      measured("[T24] Section 4.1.2", "gamma_D = 1, without a unit of length",
               "gamma_D has the unit of one over the fourth power of a length: gamma_rel over that of the cage's size",
               "gamma_d=1", measure_unit),
      measured("[T24] Section 4.1.3", "a unit Neumann condition; nothing is said of uniform scaling",
               "unit normals lose uniform scaling, which Green coordinates keep; normals stretched like their "
               "triangles keep it, too",
               "normals=unit", measure_scale),
      told("[T24] after Eq 30", "a large gamma_D fits positions better", "at the samples; elsewhere not always"),
      told("[T24] Eq 35, 36", "energies of second derivatives over the cage",
           "Hessians grow like one over the distance to an edge: the integrals are infinite, the sums grow with the "
           "samples, and their number is part of the method"),
      told("[W12] Eq 20, 22", "integrals of squared second derivatives over the boundary",
           "infinite wherever the posed boundary's Jacobian jumps at a vertex; the sums depend on the pieces"),
      infinite_nu(),
      told("[C23] Eq 15", "found useful against floating, at large displacements or bulging",
           "decisive without bulging, too: in the local variant in space f moves by up to 0.28 of the size")};
  return claims;
}

}  // namespace cageproof::validation
