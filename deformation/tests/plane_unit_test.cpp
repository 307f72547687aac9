// SPDX-License-Identifier: MIT
// The unit of length in the plane, where layers have logarithms: what does not depend on it, and what does.
#include "settings.h"
#include "variational_cases.h"

namespace cageproof::deformation::test {
namespace {

std::vector<Vec> times(double s, std::vector<Vec> points) {
  for (Vec& p : points) p *= s;
  return points;
}

// How far images in a unit ten times smaller are from those in the cage's own, in sizes.
double change(const Case& c, const Setting& setting) {
  const double s = 10;
  const Cage larger = c.cage.with(times(s, c.cage.vertices()), c.cage.faces());
  const Images<double> here = deformed(*prepared_with(c.cage, setting), c.posed, c.points),
                       there = deformed(*prepared_with(larger, setting), times(s, c.posed), times(s, c.points));
  return (image(there, 0, 2) / s - image(here, 0, 2)).norm() / c.size;
}

// Logarithms add a constant to psi a length: over the normals of a closed cage these sum to nothing where each is as
// long as its edge, over unit normals they do not.
TEST(plane_unit, does_not_matter_where_normals_are_stretched) {
  for (const Case& c : {square(), l_shape(), pentagon()}) {
    for (const double stretch : {0., 1., 2.}) EXPECT_LT(change(c, {"green", {{"stretch", stretch}}}), 1e-14) << c.name;
    EXPECT_GT(change(c, {"green", {{"stretch", 3}}}), 1e-3) << c.name;
    for (const double variant : {0., 1., 2.})
      EXPECT_LT(change(c, {"somigliana", {{"variant", variant}, {"gamma", 2}}}), 1e-14) << c.name;
    EXPECT_LT(change(c, {"cauchy"}), 1e-14) << c.name;
  }
}

// A larger unit adds |x|^2 to the biharmonic layers, which no layer is: not even weights that are free of the unit, nor
// stretched normals, make up for it.
TEST(plane_unit, matters_to_biharmonic_layers) {
  for (const Case& c : {l_shape(), pentagon()})
    for (const double normals : {0., 3.}) {
      EXPECT_GT(change(c, {"biharmonic_weber", {{"normals", normals}}}), 1e-3) << c.name << normals;
      EXPECT_GT(change(c, {"biharmonic_1_3", {{"normals", normals}, {"gamma_rel", 1}}}), 1e-3) << c.name << normals;
    }
}

TEST(plane_unit, matters_to_biharmonic_maps_by_constraints_but_not_to_harmonic_ones) {
  const Case c = pentagon();
  const auto image_in = [&](Subspace subspace, double s) {
    Constraints there = plane_constraints();
    for (auto& [at, to] : there.positions) at *= s, to *= s;
    for (auto& [at, jacobian] : there.orientations) at *= s;
    there.rotations = times(s, there.rotations);
    there.hessians = times(s, there.hessians);
    const Variational<double> model(c.cage.with(times(s, c.cage.vertices()), c.cage.faces()), there,
                                    {.subspace = subspace,
                                     .alpha = .01 * s * s,
                                     .beta = .01 * s * s,
                                     .gamma = .001 * s * s * s * s,
                                     .steps = 5,
                                     .tolerance = 0});
    return Vec(image(model.images(*model.pose(), times(s, c.points), 0), 0, 2) / s);
  };
  const auto changed = [&](Subspace s) { return (image_in(s, 10) - image_in(s, 1)).norm() / c.size; };
  EXPECT_LT(changed(Subspace::Harmonic), 1e-13);
  EXPECT_GT(changed(Subspace::Biharmonic), 1e-4);
}

}  // namespace
}  // namespace cageproof::deformation::test
