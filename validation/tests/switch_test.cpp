// SPDX-License-Identifier: MIT
// Where the hybrid changes from the edge form to Gauss points, both must keep its promise, so that no jump can
// be seen.
#include "cageproof/closed_form/triangle/affine_single_layer.h"
#include "cageproof/closed_form/triangle/biharmonic_double_layer.h"
#include "cageproof/closed_form/triangle/biharmonic_single_layer.h"
#include "cageproof/closed_form/triangle/double_layer.h"
#include "cageproof/closed_form/triangle/kelvin_displacement.h"
#include "cageproof/closed_form/triangle/kelvin_traction.h"
#include "cageproof/closed_form/triangle/mean_value.h"
#include "cageproof/closed_form/triangle/single_layer.h"
#include "cageproof/closed_form/triangle/solid_angle.h"
#include "cageproof/fast/triangle/hybrid.h"
#include "cageproof/validation/promise.h"
#include "cageproof/validation/regime.h"
#include "cageproof/validation/truth.h"

#include <gtest/gtest.h>

namespace cageproof::validation::switch_test {
namespace {

namespace cf = closed_form::triangle;
namespace hybrid = fast::triangle;

// The point on the ray from the centroid where the far form takes over.
template <class F>
Vec3<double> switch_point(const Triangle<double>& t, const Vec3<double>& through) {
  const Vec3<double> centre = (t[0] + t[1] + t[2]) / 3, ray = (through - centre).normalized();
  double near = 0, far = 100;
  for (int i = 0; i < 50; ++i) {
    const double middle = (near + far) / 2;
    const Vec3<double> point = centre + middle * ray;
    const cf::Frame<double> frame(t, point);
    const bool is_far = !hybrid::cut_to_panels(frame, t, point, hybrid::panels_wanted<F, 2>(frame)).empty();
    (is_far ? far : near) = middle;
  }
  return centre + far * ray;
}

template <class F>
void expect_no_jump(const std::string& name, int samples) {
  const Formula& formula = *find_formula(name);
  const TruthSource source = truth_source(formula);
  for (int i = 0; i < samples; ++i) {
    Sample sample = make_sample(formula, *find_regime(i % 2 == 0 ? "generic" : "near-plane"), 5, i);
    const Triangle<double> t{sample.corners[0], sample.corners[1], sample.corners[2]};
    sample.point = switch_point<F>(t, sample.point);
    const cf::Frame<double> frame(t, sample.point);
    const hybrid::Panels panels = hybrid::cut_to_panels(frame, t, sample.point, hybrid::panels_wanted<F, 2>(frame));
    ASSERT_FALSE(panels.empty());
    using Jet = closed_form::Jet<double, F::components>;
    const std::span<const double> parameters(sample.parameters);
    const hybrid::PanelFormOf<F, double, 2> moments(frame, panels);
    const Jet far = cf::finish<F, 2, double>(cf::composed<F, 2, double>(moments, parameters), frame.unit, 3);
    Jet near = cf::finish<F, 2, double>(cf::near_components<F, 2>(frame, parameters), frame.unit, 3);
    // Thin elements are computed with more digits on the near side.
    if (F::cancels_nearby || frame.shape() < hybrid::kThinShape) {
      cf::PointMoments<2> at(t, sample.point);
      near = cf::bounded_form<F, 2>(at, parameters, false, closed_form::kTolerance).jet;
    }
    const Truth truth = truth_from(source, sample, 2);
    for (int o = 0; o <= 2; ++o) {
      Mp100 jump = 0;
      const auto add = [&jump](double a, double b) {
        const Mp100 d = Mp100(a) - b;
        jump += d * d;
      };
      for (int c = 0; c < F::components; ++c) {
        if (o == 0) add(far.value[c], near.value[c]);
        for (int d = 0; o == 1 && d < 3; ++d) add(far.gradient[c][d], near.gradient[c][d]);
        for (int d = 0; o == 2 && d < 9; ++d) add(far.hessian[c](d / 3, d % 3), near.hessian[c](d / 3, d % 3));
      }
      const double promise = *promise_for({"truth", name, "hybrid", "double", "generic", o}).bound;
      EXPECT_LE(static_cast<double>(Mp100(sqrt(jump) / (truth.conditioned[o] * Mp100(unit_roundoff<double>())))),
                promise)
          << "order " << o << ", sample " << i;
    }
  }
}

TEST(far_switch, single_layer) { expect_no_jump<cf::SingleLayer>("triangle.single_layer", 60); }
TEST(far_switch, double_layer) { expect_no_jump<cf::DoubleLayer>("triangle.double_layer", 60); }
TEST(far_switch, solid_angle) { expect_no_jump<cf::SolidAngle>("triangle.solid_angle", 60); }
TEST(far_switch, biharmonic_single_layer) {
  expect_no_jump<cf::BiharmonicSingleLayer>("triangle.biharmonic_single_layer", 60);
}
TEST(far_switch, biharmonic_double_layer) {
  expect_no_jump<cf::BiharmonicDoubleLayer>("triangle.biharmonic_double_layer", 60);
}
TEST(far_switch, affine_single_layer) { expect_no_jump<cf::AffineSingleLayer>("triangle.affine_single_layer", 60); }
TEST(far_switch, kelvin_displacement) { expect_no_jump<cf::KelvinDisplacement>("triangle.kelvin_displacement", 30); }
TEST(far_switch, kelvin_traction) { expect_no_jump<cf::KelvinTraction>("triangle.kelvin_traction", 30); }
TEST(far_switch, mean_value) { expect_no_jump<cf::MeanValue>("triangle.mean_value", 30); }

}  // namespace
}  // namespace cageproof::validation::switch_test
