// SPDX-License-Identifier: MIT
// Biharmonic coordinates of polygons: Eq 5 and 6 of [W12], the scheme's numbers, and what the systems' report says.
#include "support.h"

#include "cageproof/core/input_error.h"

#include <gtest/gtest.h>

#include <numeric>

namespace cageproof::solved::test {
namespace {

constexpr int kVertices = 0, kDefault = 1, kCollocations = 5;

CageCoordinates prepared(const Cage& cage, double pieces, double collocation = kDefault) {
  return coordinates(cage, "biharmonic_boundary", {pieces, collocation});
}

struct Shape {
  const char* name;
  Cage cage;
  std::vector<Vec> points;  // inside, on edges and at vertices
};

std::vector<Shape> shapes() {
  return {{"square", polygon(unit_square), {{0.5, 0.5, 0}, {0.25, 0.5, 0}, {1e-9, 0.3, 0}, {0, 0.375, 0}, {1, 1, 0}}},
          {"pentagon", polygon(convex_pentagon), {{0.5, 0.5, 0}, {1, 1, 0}, {1, 0, 0}, {2, 1e-12, 0}, {0, 0, 0}}},
          {"L", polygon(l_shape), {{0.5, 0.5, 0}, {0, 1, 0}, {1, 1.5, 0}, {1.5, 0.25, 0}, {1, 1, 0}}},
          {"thin bar", polygon(thin_bar), {{0.5, 0.0078125, 0}, {0.25, 0, 0}, {0.9375, 0.001, 0}, {0, 0, 0}}},
          {"ring", ring(), {{0.5, 0.5, 0}, {3, 3, 0}, {1, 1.5, 0}, {2, 2, 0}, {0, 0, 0}}}};
}

TEST(biharmonic_boundary, reproduces_affine_maps_with_normals_as_the_paper_says) {
  for (const Shape& shape : shapes())
    for (const double pieces : {1, 2, 3, 4, 16})
      for (const Vec& point : shape.points) {
        const CageCoordinates coordinates = prepared(shape.cage, pieces);
        // A hundredth of a rounding times the condition where that is large: 3e6 for the thin bar in 16 pieces, whose
        // error depends on the machine's logarithms.
        double bound = 1e-12;
        for (const SolvedSystem& s : coordinates.solved()) bound = std::max(bound, 1e-18 * s.condition);
        const auto errors = affine_errors(coordinates, point, 0);
        EXPECT_LT(errors[0], bound) << shape.name << ", " << pieces << " pieces, at " << point.transpose();
      }
}

TEST(biharmonic_boundary, reproduces_affine_maps_to_the_condition_by_any_collocation) {
  for (const Shape& shape : shapes())
    for (const double pieces : {1, 2, 4})
      for (int c = 0; c < kCollocations; ++c) {
        const CageCoordinates coordinates = prepared(shape.cage, pieces, c);
        double condition = 10;  // sums of some ten terms
        for (const SolvedSystem& s : coordinates.solved()) condition = std::max(condition, s.condition);
        for (const Vec& point : shape.points)
          EXPECT_LT(affine_errors(coordinates, point, 0)[0], 1e-16 * condition)
              << shape.name << ", " << pieces << " pieces, collocation " << c << ", at " << point.transpose()
              << " condition " << condition;
      }
}

TEST(biharmonic_boundary, derivatives_of_affine_maps_are_theirs) {
  for (const double pieces : {1, 4}) {
    // Nowhere a point of symmetry, where second derivatives vanish and have no relative error.
    for (const Vec& point : {Vec(0.3, 0.2, 0), Vec(0.7, 0.9, 0)})
      for (const double error : affine_errors(prepared(polygon(l_shape), pieces), point, 2)) EXPECT_LT(error, 1e-12);
    for (const double error : affine_errors(prepared(polygon(unit_square), pieces), Vec(0.3, 0.2, 0), 2))
      EXPECT_LT(error, 1e-12);
  }
}

TEST(biharmonic_boundary, sums_to_nothing_outside) {
  for (const double error : affine_errors(prepared(polygon(l_shape), 4), Vec(1.5, 1.75, 0), 2, 0))
    EXPECT_LT(error, 1e-12);
}

struct Reference {
  const Corners& corners;
  double pieces, collocation;
  double alpha_1, beta_0, dx_alpha_1, dy_beta_0;
};

// At (0.3125, 0.5), from an independent implementation: the printed closed forms after the errata, dense
// pseudo-inverses of numpy, the cage divided by its diameter.
const std::vector<Reference> references{
    {unit_square, 1, 1, 0.117711069976, -0.073455968278, 0.638548416694, 0.229619605357},
    {unit_square, 1, 2, 0.120645243446, -0.071975555447, 0.624928502405, 0.213657922639},
    {unit_square, 1, 3, 0.119001669504, -0.096121836375, 0.632557681949, 0.222598841113},
    {unit_square, 1, 4, 0.117711069976, -0.073455968278, 0.638548416694, 0.229619605357},
    {unit_square, 3, 1, 0.113138838010, -0.034717297986, 0.670826129377, 0.216203328819},
    {unit_square, 3, 2, 0.113695327214, -0.034572481130, 0.669121459188, 0.207698263018},
    {unit_square, 3, 3, 0.094201848395, -0.023359867002, 0.760196258226, 0.319919713989},
    {unit_square, 3, 4, 0.113313414644, -0.030387039623, 0.674769395961, 0.207190364092},
    {convex_pentagon, 1, 0, 0.156209379740, -0.187051786861, 0.497492427209, -0.052933661244},
    {convex_pentagon, 1, 1, 0.121228073552, -0.163597157674, 0.394302656789, -0.006850149360},
    {convex_pentagon, 1, 2, 0.110723687929, -0.156705425803, 0.410619755900, 0.013239949681},
    {convex_pentagon, 1, 3, 0.277090756144, -0.150910613113, 0.096324875539, -0.175865912827},
    {convex_pentagon, 1, 4, 0.235619044318, -0.120883077703, 0.164678802070, -0.072426796363},
    {convex_pentagon, 3, 0, 0.087903743929, -0.132687860920, 0.372058995135, 0.024862705473},
    {convex_pentagon, 3, 1, 0.104623103300, -0.132890878364, 0.341220800564, 0.104607622372},
    {convex_pentagon, 3, 2, 0.101790674955, -0.134931253772, 0.346411779176, 0.114981227319},
    {convex_pentagon, 3, 3, 0.027346913996, 0.066696857143, 0.264011398230, -0.551000121465},
    {convex_pentagon, 3, 4, 0.111244869009, -0.122779125665, 0.294236186173, 0.119800541471},
    {l_shape, 1, 1, 0.089068161001, -0.117005814653, 0.284735057532, 0.084806284929},
    {l_shape, 1, 2, 0.082302522071, -0.107331453821, 0.284937469985, 0.080256997434},
    {l_shape, 1, 3, -0.238647018605, 0.147732572908, 0.760871977905, 0.228341279795},
    {l_shape, 1, 4, 0.048782772235, -0.072334707487, 0.279243116300, 0.101094559712},
    {l_shape, 3, 1, 0.054668417932, -0.047056766589, 0.280101242148, 0.163544430572},
    {l_shape, 3, 2, 0.046284049029, -0.043084528230, 0.288735919424, 0.184617390793},
    {l_shape, 3, 3, -0.025174814216, -0.028064273978, 0.675726117113, 0.151845341062},
    {l_shape, 3, 4, 0.028282558884, -0.023862637305, 0.272849001814, 0.198863927873}};

TEST(biharmonic_boundary, is_the_scheme_of_the_paper_in_every_refinement) {
  for (const Reference& r : references) {
    const auto found = prepared(polygon(r.corners), r.pieces, r.collocation).at<double>(Vec(0.3125, 0.5, 0), 1);
    // Twelve decimals are given.
    EXPECT_NEAR(found[0].value[1], r.alpha_1, 2e-12);
    EXPECT_NEAR(found[1].value[0], r.beta_0, 2e-12);
    EXPECT_NEAR(found[0].gradient[2], r.dx_alpha_1, 2e-12);
    EXPECT_NEAR(found[1].gradient[1], r.dy_beta_0, 2e-12);
  }
}

TEST(biharmonic_boundary, says_that_the_papers_square_system_is_singular) {
  for (const Corners* corners : {&unit_square, &rectangle, &kite, &l_shape, &hexagon})
    for (const double pieces : {1, 2, 4}) {
      const auto systems = prepared(polygon(*corners), pieces, kVertices).solved();
      ASSERT_EQ(systems.size(), 2u);
      EXPECT_TRUE(systems[0].is_singular());
      EXPECT_EQ(systems[0].rank, systems[0].columns - 1);
      EXPECT_EQ(systems[0].rows, systems[0].columns);
      EXPECT_GT(systems[0].condition, 1e14);
      for (const SolvedSystem& s : prepared(polygon(*corners), pieces).solved()) {
        EXPECT_FALSE(s.is_singular());
        EXPECT_LT(s.condition, 3e3);
        EXPECT_EQ(s.rows, 2 * s.columns);
      }
    }
}

TEST(biharmonic_boundary, solves_the_square_system_where_it_can) {
  for (const Corners* corners : {&triangle, &convex_pentagon})
    for (const SolvedSystem& s : prepared(polygon(*corners), 3, kVertices).solved()) {
      EXPECT_FALSE(s.is_singular());
      EXPECT_LT(s.condition, 1e3);
      EXPECT_LT(s.residual, 1e-12);
    }
}

// The paper's 1e-6 costs ten digits: Eq 6 holds to 1e-10, Eq 5 and the coordinates themselves to some 1e-6.
TEST(biharmonic_boundary, on_the_offset_cage_is_off_by_the_offset) {
  for (const Corners* corners : {&unit_square, &convex_pentagon, &l_shape}) {
    const Cage cage = polygon(*corners);
    const CageCoordinates offset(cage, coordinate_kind_named("biharmonic_boundary"),
                                 CoordinateOptions{.evaluation = "offset-1e-6"}),
        exact = prepared(cage, 4);
    EXPECT_EQ(offset.evaluation(), "offset-1e-6");
    const Vec point(0.25, 0.5, 0);
    const double error = largest_difference(values_at(offset, point), values_at(exact, point));
    EXPECT_GT(error, 1e-7);
    EXPECT_LT(error, 1e-4);
    EXPECT_GT(affine_errors(offset, point, 0)[0], 1e-8);
    const auto alpha = offset.at<double>(point, 0)[0].value;
    EXPECT_LT(std::abs(std::accumulate(alpha.begin(), alpha.end(), -1.0)), 1e-9);
  }
}

// Sizes of terms, in which errors are counted, are never less than the coordinates, and like them away from their
// zeros.
TEST(biharmonic_boundary, knows_the_sizes_of_its_terms) {
  const CageCoordinates c = prepared(polygon(l_shape), 4);
  for (const Vec& point : {Vec(0.25, 0.5, 0), Vec(1.75, 1.75, 0), Vec(0, 0.375, 0)}) {
    const auto terms = c.terms_at(point, 2), found = c.at<double>(point, 2);
    for (std::size_t b = 0; b < terms.size(); ++b)
      for (int o = 0; o <= 2; ++o)
        for (std::size_t i = 0; i < terms[b].of(o).size(); ++i) {
          EXPECT_GE(terms[b].of(o)[i], std::abs(found[b].of(o)[i]) * (1 - 1e-12));
          EXPECT_LT(terms[b].of(o)[i], 1e5);
        }
  }
}

std::string refusal(std::vector<double> parameters, const Cage& cage) {
  try {
    coordinates(cage, "biharmonic_boundary", std::move(parameters));
  } catch (const InputError& error) {
    return error.what();
  }
  return "";
}

TEST(biharmonic_boundary, refuses_what_it_cannot_prepare) {
  const Cage square = polygon(unit_square);
  for (const double pieces : {0., 65., 1.5, -1., static_cast<double>(NAN)})
    EXPECT_NE(refusal({pieces, 1}, square).find("pieces"), std::string::npos) << pieces;
  for (const double collocation : {-1., 5., 0.5})
    EXPECT_NE(refusal({1, collocation}, square).find("collocation"), std::string::npos) << collocation;
  EXPECT_NE(refusal({64, 1}, polygon(subdivided(unit_square, 17))).find("4352 nodes"), std::string::npos);
}

// So that a campaign on an outline of many edges leaves the kind out, and says so.
TEST(biharmonic_boundary, is_refused_by_polygons_of_too_many_edges_as_harmonic_is) {
  const Cage many = polygon(subdivided(unit_square, 260)), few = polygon(subdivided(unit_square, 256));
  for (const char* name : {"biharmonic_boundary", "harmonic"}) {
    const CoordinateKind& kind = coordinate_kind_named(name);
    EXPECT_TRUE(accepts(kind, few)) << name;
    EXPECT_FALSE(accepts(kind, many)) << name;
    EXPECT_NE(why_refused(kind, many).find("1040 edges in 4 pieces each have 4160 nodes"), std::string::npos) << name;
  }
}

// Printed forms have no values on the cage, where the systems hold.
TEST(biharmonic_boundary, refuses_evaluations_without_limits_and_units_out_of_range) {
  for (const char* kind : {"biharmonic_boundary", "harmonic"})
    EXPECT_THROW(CageCoordinates(polygon(unit_square), coordinate_kind_named(kind),
                                 CoordinateOptions{.evaluation = "published"}),
                 InputError)
        << kind;
  EXPECT_THROW(coordinates(polygon(unit_square, 1e160), "triharmonic_boundary"), InputError);
  EXPECT_NO_THROW(coordinates(polygon(unit_square, 1e150), "triharmonic_boundary"));
}

TEST(biharmonic_boundary, takes_names_for_collocation) {
  const auto parameters = parameters_of(coordinate_kind_named("biharmonic_boundary"));
  ASSERT_EQ(parameters.size(), 3u);
  EXPECT_EQ(parameters[1].value_of("vertices"), 0);
  EXPECT_EQ(parameters[1].value_of("mixed-and-midpoints"), 4);
  EXPECT_FALSE(parameters[1].value_of("0"));
  EXPECT_EQ(parameters[0].value_of("3"), 3);
  EXPECT_FALSE(parameters[0].allows(2.5));
}

}  // namespace
}  // namespace cageproof::solved::test
