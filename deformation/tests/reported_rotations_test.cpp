// SPDX-License-Identifier: MIT
// Rotations that a pose does not determine, vertices whose normals or rotations cancel, and tractions of flat poses.
#include "../src/somigliana/corotation.h"
#include "settings.h"
#include "variational_cases.h"

namespace cageproof::deformation::test::reported_rotations_test {
namespace {

enum Variant { kGlobal, kLocal, kBlend };

Setting somigliana(Variant variant, double gamma = 0) {
  return {"somigliana", {{"variant", static_cast<double>(variant)}, {"gamma", gamma}}};
}

Cage octahedron() {
  std::vector<Vec> vertices;
  std::vector<Face> faces;
  vertices.reserve(6);
  faces.reserve(8);
  for (int k = 0; k < 3; ++k)
    for (const double side : {1., -1.}) vertices.emplace_back(side * Vec::Unit(k));
  for (const int x : {0, 1})
    for (const int y : {2, 3})
      for (const int z : {4, 5}) {
        const bool even = (x + y + z) % 2 == 0;
        faces.push_back({{x, even ? y : z, even ? z : y, -1}});
      }
  return Cage::make("octahedron", vertices, faces, {});
}

// Poses whose best rotation of all vertices is not one: on a line in space; mirror images with two equal least singular
// values, of which all three of the cube's are equal; a point in either dimension.
TEST(reported, rotations_of_all_vertices_that_are_not_unique) {
  struct Scaled {
    Case of;
    Vec by;
  };
  for (const auto& [c, by] : std::vector<Scaled>{{cube(), {1, 0, 0}},
                                                 {cube(), {1, 1, -1}},
                                                 {cube(), {2, 1, -1}},
                                                 {cube(), {0, 0, 0}},
                                                 {square(), {1, -1, 0}},
                                                 {square(), {0, 0, 0}}}) {
    const int d = c.cage.dimension();
    for (const auto& posed : {scaled(c.cage.vertices(), by), turned(scaled(c.cage.vertices(), by), d)}) {
      EXPECT_TRUE(warns_of(report_of(c.cage, somigliana(kGlobal), posed), "the rotation of all vertices is not unique"))
          << c.name << ' ' << by.transpose();
      EXPECT_TRUE(is_finite(deformed(*prepared_with(c.cage, somigliana(kGlobal)), posed, c.points)));
    }
  }
  // Flat, a line in the plane, mirrored with another least singular value: all unique.
  for (const auto& [c, by] : std::vector<Scaled>{
           {cube(), {1, 1.5, 0}}, {cube(), {1, 1.5, -.5}}, {square(), {1, 0, 0}}, {square(), {1, -.5, 0}}})
    for (const auto& posed : {scaled(c.cage.vertices(), by), turned(scaled(c.cage.vertices(), by), c.cage.dimension())})
      EXPECT_FALSE(warns_of(report_of(c.cage, somigliana(kGlobal), posed), "unique"))
          << c.name << ' ' << by.transpose();
  // Between the variants both are needed.
  const std::vector<Vec> mirrored = scaled(cube().cage.vertices(), Vec(1, 1, -1));
  EXPECT_TRUE(warns_of(report_of(cube().cage, somigliana(kBlend), mirrored), "all vertices is not unique"));
}

// Mirrored as a whole, rotations of elements are mirrored in their planes, and of a cube those around a vertex are half
// turns about three axes, whose sum is a multiple of minus the identity.
TEST(reported, rotations_of_vertices_that_are_not_unique) {
  const Case c = cube();
  const std::vector<Vec> inside_out = scaled(c.cage.vertices(), Vec(-1, -1, -1));
  for (const auto& posed : {inside_out, turned(inside_out, 3)}) {
    const DeformationReport report = report_of(c.cage, somigliana(kLocal), posed);
    int vertices = 0;
    for (const std::string& w : report.warnings) vertices += contains(w, "the rotation of vertex ") ? 1 : 0;
    EXPECT_GT(vertices, 0);
    EXPECT_TRUE(warns_of(report, "inside out"));
  }
  EXPECT_TRUE(report_of(c.cage, somigliana(kLocal), c.posed).warnings.empty());
}

// Rotations of two edges half a turn apart add up to nothing but rounding.
TEST(reported, rotations_around_a_vertex_that_cancel) {
  const Case c = square();
  // Edge 0 turns by a quarter to the left, edge 1 to the right, the others not.
  const std::vector<Vec> folded{{0, 0, 0}, {0, 1, 0}, {1, 1, 0}, {0, 1, 0}};
  for (const auto& posed : {folded, turned(folded, 2)}) {
    const DeformationReport report = report_of(c.cage, somigliana(kLocal), posed);
    EXPECT_TRUE(warns_of(report, "the rotation of vertex 1 is not unique"));
    EXPECT_FALSE(warns_of(report, "the rotation of vertex 3 is not unique"));
  }
}

// Normals around a vertex that cancel leave no spread, which bulging needs and nothing else.
TEST(reported, vertices_without_a_normal) {
  const Case c = square();
  // Vertex 1 is the tip of a fold.
  const std::vector<Vec> folded{{0, 0, 0}, {1, .5, 0}, {0, 0, 0}, {-1, 1, 0}};
  const Cage eight = octahedron();
  // Around vertices 0 and 1 the triangles above have the area of those below, and no others.
  std::vector<Vec> pancake = scaled(eight.vertices(), Vec(1, 1, 0));
  pancake[4] = Vec(0, .3, 0);
  pancake[5] = Vec(0, -.2, 0);
  struct Cancelling {
    Cage cage;
    std::vector<Vec> posed;
    std::string vertex;
  };
  for (const Cancelling& cancelling :
       std::vector<Cancelling>{{c.cage, folded, "vertex 1"}, {eight, pancake, "vertex 0"}})
    for (const Variant variant : {kGlobal, kLocal}) {
      const int d = cancelling.cage.dimension();
      for (const auto& posed : {cancelling.posed, turned(cancelling.posed, d)}) {
        EXPECT_EQ(refusal_of([&] { report_of(cancelling.cage, somigliana(variant, 1), posed); }),
                  "the normals around " + cancelling.vertex + " add up to nothing: it has no spread")
            << d << variant;
        EXPECT_EQ(refusal_of([&] { report_of(cancelling.cage, somigliana(variant), posed); }), "") << d << variant;
      }
    }
}

// A pose without volume, whose normals are all parallel: Eq 15's matrix is singular, and tractions are balanced.
TEST(reported, tractions_of_flat_poses_are_balanced) {
  struct Flat {
    Cage cage;
    Vec by;
  };
  for (const auto& [cage, by] : std::vector<Flat>{{octahedron(), {1, 1, 0}},
                                                  {octahedron(), {2, .5, 0}},
                                                  {pentagon().cage, {1, 0, 0}},
                                                  {l_shape().cage, {1, 1, 0}}}) {
    const CageElements elements(cage, false, Triangulation::Shortest);
    const int d = cage.dimension();
    std::vector<Vec> flat = scaled(cage.vertices(), by);
    // A pose of the L with its vertices on a line, in no order.
    if (cage.name() == "L")
      for (Vec& v : flat) v = (v[0] + .3 * v[1]) * Vec::UnitX();
    for (const auto& posed : {flat, turned(flat, d)})
      for (const double nu : {0., .3, .45}) {
        const Corotation<double> found = corotation_of<double>(elements, posed, {.blend = 1, .nu = nu});
        Vec left = Vec::Zero();
        double whole = 0;
        for (std::size_t e = 0; e < elements.count(); ++e) {
          const auto corners = elements.corners(e);
          const Vec u = corners[1] - corners[0];
          const double measure = d == 2 ? u.norm() : u.cross(Vec(corners[2] - corners[0])).norm() / 2;
          left += measure * found.tractions[e];
          whole += measure * found.tractions[e].norm();
        }
        EXPECT_GT(whole, 0);
        EXPECT_LE(left.norm(), 1e-14 * whole) << cage.name() << nu;
      }
  }
}

// Mirror images have many nearest rotations, and nearest similarities; so has what is drawn out to a line.
TEST(reported, variational_rotations_that_are_not_unique) {
  const Case c = bar();
  for (const Nearest nearest : {Nearest::Rotation, Nearest::Similarity})
    for (const auto& by : {Vec(1, 1, -1), Vec(2, 1, -1), Vec(1, 0, 0)}) {
      Constraints constraints = bar_constraints(c.cage);
      for (auto& [at, to] : constraints.positions) to = at.cwiseProduct(by);
      VariationalOptions options = bar_options(Subspace::Harmonic, 2);
      options.nearest = nearest;
      options.beta = 1e-16;
      const auto posed = Variational<double>(c.cage, constraints, options).pose();
      EXPECT_TRUE(warns_of(posed->report(), "rotations[0]: the nearest rotation is not unique in step 2"))
          << by.transpose();
    }
}

}  // namespace
}  // namespace cageproof::deformation::test::reported_rotations_test
