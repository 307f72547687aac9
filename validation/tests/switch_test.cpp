// SPDX-License-Identifier: MIT
// Where the fast evaluation changes from the edge form to Gauss points, both must keep its promise, so that no jump can be seen.
#include "cageproof/closed_form/triangle/triangle_form.h"
#include "cageproof/validation/promise.h"
#include "cageproof/validation/regime.h"
#include "cageproof/validation/truth.h"

#include <gtest/gtest.h>

namespace cageproof::validation {
namespace {

namespace cf = closed_form;

// The point on the ray from the centroid where the far form takes over.
template <class F>
Vec3<double> switch_point(const Triangle<double>& t, const Vec3<double>& through) {
  const Vec3<double> centre = (t[0] + t[1] + t[2]) / 3, ray = (through - centre).normalized();
  double near = 0, far = 100;
  for (int i = 0; i < 50; ++i) {
    const double middle = (near + far) / 2;
    const bool is_far =
        cf::far_points_for<F, 2>(cf::Frame<double>(t, Vec3<double>(centre + middle * ray)), cf::far_tolerance).has_value();
    (is_far ? far : near) = middle;
  }
  return centre + far * ray;
}

template <class F>
void expect_no_jump(const std::string& name, int samples) {
  const Formula& formula = *find_formula(name);
  const Evaluation reference = *EvaluationRegister::instance().find(name, "closed_form");
  for (int i = 0; i < samples; ++i) {
    Sample sample = make_sample(formula, *find_regime(i % 2 == 0 ? "generic" : "near-plane"), 5, i);
    const Triangle<double> t{sample.corners[0], sample.corners[1], sample.corners[2]};
    sample.point = switch_point<F>(t, sample.point);
    const cf::Frame<double> frame(t, sample.point);
    const auto points = cf::far_points_for<F, 2>(frame, cf::far_tolerance);
    ASSERT_TRUE(points.has_value());
    Result<double> far, near;
    const std::span<const double> parameters(sample.parameters);
    cf::store(cf::finish<F, 2, double>(cf::far_components<F, 2>(frame, *points, parameters), frame.unit, 3), 2, far);
    cf::store(cf::finish<F, 2, double>(cf::near_components<F, 2>(frame, parameters), frame.unit, 3), 2, near);
    // What is thin is computed with more digits on the near side.
    if (std::same_as<F, cf::MeanValue> || frame.shape() < cf::thin_shape)
      cf::store(cf::refined<F, 2>(t, sample.point, parameters, frame.unit, cf::accurate_tolerance, 3).jet, 2, near);
    const Truth truth = truth_from(reference, sample, 2);
    for (int o = 0; o <= 2; ++o) {
      Mp100 jump = 0;
      for (std::size_t k = 0; k < far.of(o).size(); ++k) {
        const Mp100 d = Mp100(far.of(o)[k]) - near.of(o)[k];
        jump += d * d;
      }
      const double promise = *promise_for({"truth", name, "closed_form", "double", "generic", o}).bound;
      EXPECT_LE(static_cast<double>(Mp100(sqrt(jump) / (truth.conditioned[o] * Mp100(unit_roundoff<double>())))), promise)
          << "order " << o << ", sample " << i;
    }
  }
}

TEST(far_switch, single_layer) { expect_no_jump<cf::SingleLayer>("triangle.single_layer", 60); }
TEST(far_switch, double_layer) { expect_no_jump<cf::DoubleLayer>("triangle.double_layer", 60); }
TEST(far_switch, solid_angle) { expect_no_jump<cf::SolidAngle>("triangle.solid_angle", 60); }
TEST(far_switch, biharmonic_single_layer) { expect_no_jump<cf::BiharmonicSingleLayer>("triangle.biharmonic_single_layer", 60); }
TEST(far_switch, biharmonic_double_layer) { expect_no_jump<cf::BiharmonicDoubleLayer>("triangle.biharmonic_double_layer", 60); }
TEST(far_switch, affine_single_layer) { expect_no_jump<cf::AffineSingleLayer>("triangle.affine_single_layer", 60); }
TEST(far_switch, kelvin_displacement) { expect_no_jump<cf::KelvinDisplacement>("triangle.kelvin_displacement", 30); }
TEST(far_switch, kelvin_traction) { expect_no_jump<cf::KelvinTraction>("triangle.kelvin_traction", 30); }
TEST(far_switch, mean_value) { expect_no_jump<cf::MeanValue>("triangle.mean_value", 30); }

}  // namespace
}  // namespace cageproof::validation
