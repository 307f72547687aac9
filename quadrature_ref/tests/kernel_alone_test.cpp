// SPDX-License-Identifier: MIT
// A kernel that somebody adds in a file of their own, with a row for it and nothing else: this file.
#include "cageproof/quadrature_ref/scalar_kernel.h"
#include "segment_support.h"

namespace cageproof::quadrature_ref {
namespace {

/// The winding of the plane about a point, in turns, and that of space: x.n/(2 pi r^2) and x.n/(4 pi r^3).
struct Turns {
  template <int Dim, Scalar R>
  static R factor() {
    return 1 / ((Dim == 2 ? 2 : 4) * pi<R>());
  }
  template <int Order, int Dim, Scalar R>
  static void jet(const Node<R>& node, const R& scale, KernelJet<Dim, R>& jet) {
    height_power_jet<-Dim, Order>(node, scale, jet);
  }
};

// The kernel before its row: rows are looked up when evaluations are asked for.
const RegisterKernel kernel{"turns", scalar_kernels<Turns, 2, 3>()};
const RegisterFormula row{{.name = "segment.turns",
                           .symbol = "t",
                           .source = "this test",
                           .definition = "int_s Gamma_k x.n/(2 pi r^2)",
                           .element = ElementKind::Segment,
                           .shape = {.per_corner = true},
                           .degree = 0,
                           .flip_sign = -1,
                           .vanishes_in_plane = true,
                           .laplacian = {Laplacian::Kind::Zero},
                           .face_jump = {.number = 1},
                           .parameters = {}}};

TEST(KernelAlone, has_all_rules_of_the_elements_with_a_row) {
  EXPECT_EQ(
      EvaluationRegister::instance().standard("segment.turns"),
      (std::vector<std::string>{"adaptive", "gauss-16", "gauss-4", "gauss-8", "multiprecision", "near-singular-16"}));
  const auto integral = EvaluationRegister::instance().with_role("segment.turns", Role::Integral);
  ASSERT_TRUE(integral);
  EXPECT_EQ(integral->name(), "multiprecision");
  EXPECT_EQ(integral->cost(), CostClass::Multiprecision);
  EXPECT_TRUE(evaluation_named("segment.turns", "adaptive").states_error());
  // No row, no evaluation.
  for (const char* formula : {"triangle.turns", "quad.turns"})
    EXPECT_FALSE(EvaluationRegister::instance().find(formula, "multiprecision")) << formula;
}

// Around a closed polygon: one turn inside, none outside; the basis functions' parts reproduce the point's place along
// each edge.
TEST(KernelAlone, sums_to_one_turn_inside_a_polygon) {
  const auto at = [](double x, double y) { return Vec3<double>(x, y, 0); };
  const std::array<Vec3<double>, 5> polygon{at(0, 0), at(2, 0), at(2, 1), at(1, .5), at(0, 1)};
  const auto turns = [&]<Scalar R>(const char* name, const Vec3<double>& point) {
    R sum = 0;
    for (std::size_t k = 0; k < polygon.size(); ++k)
      for (const R& x :
           evaluate<R>("segment.turns", name, SegmentSample{"", {polygon[k], polygon[(k + 1) % 5]}, point}, 2).value)
        sum += x;
    return sum;
  };
  for (const Vec3<double>& inside : {at(.5, .5), at(1.875, .0625), at(1, .5 - 0x1p-40)})
    EXPECT_LT(log10_of(Mp50(abs(Mp50(turns.operator()<Mp50>("multiprecision", inside) - 1)))), -29);
  EXPECT_LT(log10_of(Mp50(abs(turns.operator()<Mp50>("multiprecision", at(1, .75))))), -29);
  EXPECT_NEAR(turns.operator()<double>("gauss-64", at(.5, .5)), 1, 1e-14);
  EXPECT_NEAR(turns.operator()<double>("near-singular-16", at(1.875, .0625)), 1, 1e-14);
  EXPECT_NEAR(turns.operator()<double>("adaptive", at(1, .5 - 0x1p-40)), 1, 1e-10);
}

TEST(KernelAlone, on_the_segment_it_is_half_the_basis_function) {
  const auto r = evaluate<Mp50>("segment.turns", "multiprecision",
                                SegmentSample{"", {Vec3<double>(0, 0, 0), Vec3<double>(4, 0, 0)}, {1, 0, 0}}, 0);
  EXPECT_LT(log10_of(Mp50(abs(Mp50(r.value[0] - Mp50(3) / 8)))), -30);
  EXPECT_LT(log10_of(Mp50(abs(Mp50(r.value[1] - Mp50(1) / 8)))), -30);
}

// On the line beyond an end the height is zero, and with it every value, exactly.
TEST(KernelAlone, vanishes_on_the_line) {
  const SegmentSample s{"", {Vec3<double>(0, 0, 0), Vec3<double>(4, 0, 0)}, {5, 0, 0}};
  for (const char* name : {"gauss-8", "near-singular-16", "adaptive", "multiprecision"}) {
    const auto r = evaluate<double>("segment.turns", name, s, 1);
    EXPECT_EQ(r.value, (std::vector<double>{0, 0})) << name;
    EXPECT_NE(r.gradient[1], 0) << name;
    EXPECT_TRUE(r.converged) << name;
  }
}

// One node: the rule's value is the kernel at it times a constant, so its differences in eta are the kernel's
// derivatives.
TEST(KernelAlone, derivatives_against_differences_in_the_plane) {
  const Segment<Mp50> s{Vec3<Mp50>(0, 0, 0), Vec3<Mp50>(2, 1, 0)};
  const Vec3<Mp50> eta(Mp50(1) / 3, Mp50(-2) / 7, 0);
  const Mp50 h = Mp50(1) / 1000000000;
  for (const std::string formula : {"segment.turns", "segment.single_layer"}) {
    const auto value_at = [&](const Vec3<Mp50>& point) {
      Result<Mp50> r;
      evaluation_named(formula, "gauss-1")(Query<Mp50>{s, point, 2}, r);
      return r;
    };
    const Result<Mp50> exact = value_at(eta);
    const std::size_t components = exact.value.size();
    std::vector<Mp50> gradient(components * 2), hessian(components * 4);
    for (int j = 0; j < 2; ++j) {
      Vec3<Mp50> up = eta, down = eta;
      up[j] += h;
      down[j] -= h;
      const Result<Mp50> above = value_at(up), below = value_at(down);
      for (std::size_t c = 0; c < components; ++c) {
        gradient[2 * c + j] = (above.value[c] - below.value[c]) / (2 * h);
        for (int i = 0; i < 2; ++i)
          hessian[4 * c + 2 * i + j] = (above.gradient[2 * c + i] - below.gradient[2 * c + i]) / (2 * h);
      }
    }
    // Central differences are off by h^2 times two more derivatives.
    EXPECT_LT(log10_error(gradient, exact.gradient), -15) << formula;
    EXPECT_LT(log10_error(hessian, exact.hessian), -15) << formula;
  }
}

}  // namespace
}  // namespace cageproof::quadrature_ref
