// SPDX-License-Identifier: MIT
// Derivatives of images by posed vertices agree with differences of the images themselves, in 50 digits and in double,
// and keep laws: both directions are one matrix, and rigid motions and scalings of the pose take the images with them.
#include "settings.h"

#include "cageproof/deformation/point_images.h"

#include <random>

namespace cageproof::deformation::test::pose_derivative_test {
namespace {

// A change of the posed vertices that keeps nothing.
std::vector<Vec> some_change(const Case& c) {
  std::mt19937_64 random(5);
  std::uniform_real_distribution<double> number(-1, 1);
  std::vector<Vec> change(c.posed.size(), Vec::Zero());
  for (Vec& v : change)
    for (int k = 0; k < c.cage.dimension(); ++k) v[k] = number(random);
  return change;
}

template <Scalar R>
std::vector<Vec3<R>> moved(const Case& c, const std::vector<Vec>& change, const R& by) {
  std::vector<Vec3<R>> found;
  for (std::size_t v = 0; v < change.size(); ++v) found.push_back(convert<R>(c.posed[v]) + by * convert<R>(change[v]));
  return found;
}

template <Scalar R>
std::vector<R> images_at(const Case& c, const Deformer<R>& deformer, const std::vector<Vec>& change, const R& by) {
  std::vector<Vec3<R>> points;
  points.reserve(c.points.size());
  for (const Vec& p : c.points) points.push_back(convert<R>(p));
  return deformed<R>(deformer, moved<R>(c, change, by), points).tensors[0];
}

// Differences of fourth order.
template <Scalar R>
std::vector<double> differences(const Case& c, const Deformer<R>& deformer, const std::vector<Vec>& change,
                                const R& h) {
  const auto near = images_at<R>(c, deformer, change, h), back = images_at<R>(c, deformer, change, R(-h));
  const auto far = images_at<R>(c, deformer, change, R(2 * h)), far_back = images_at<R>(c, deformer, change, R(-2 * h));
  std::vector<double> found;
  for (std::size_t i = 0; i < near.size(); ++i)
    found.push_back(static_cast<double>(R((8 * (near[i] - back[i]) - (far[i] - far_back[i])) / (12 * h))));
  return found;
}

std::unique_ptr<const PoseDerivative<double>> derivative_of(const Case& c, const Setting& s,
                                                            const Deformer<double>& deformer) {
  return pose_derivative<double>(deform_method_named(s.method), deformer, {.vertices = c.posed});
}

std::vector<double> along(const Case& c, const Deformer<double>& deformer, const PoseDerivative<double>& derivative,
                          const std::vector<Vec>& change) {
  return deformer.images(*derivative.along(change), c.points, 0).tensors[0];
}

double largest_difference(const std::vector<double>& a, const std::vector<double>& b) {
  double worst = 0;
  for (std::size_t i = 0; i < a.size(); ++i) keep_larger(worst, std::abs(a[i] - b[i]));
  return worst;
}

bool has_derivative(const Setting& s) {
  const bool is_least = s.method == "biharmonic_boundary" && s.parameters[0].second == 2;
  const bool bulges = s.method.ends_with("somigliana") && s.parameters[1].second != 0;
  return deform_method_named(s.method).has_pose_derivative && !is_least && !bulges;
}

std::vector<Case> cases() { return {cube(), square(), pentagon()}; }

TEST(pose_derivative, differences_in_50_digits) {
  const std::vector<Setting> quick{{"mean_value"},
                                   {"cauchy"},
                                   {"elastic"},
                                   {"biharmonic_boundary", {{"normals", 0}}},
                                   {"biharmonic_boundary", {{"normals", 1}}},
                                   {"biharmonic_1_3", {{"level", 0}, {"normals", 0}}}};
  std::vector<Setting> all = quick;
  for (const double stretch : {0., 1., 2., 3.}) {
    all.push_back({"green", {{"stretch", stretch}}});
    all.push_back({"biharmonic_direct", {{"normals", stretch}, {"neumann", 1}}});
  }
  for (const double stretch : {0., 1., 2., 3., 4.}) all.push_back({"quad_green", {{"stretch", stretch}}});
  for (const double variant : {0., 1., 2.}) all.push_back({"somigliana", {{"variant", variant}}});
  for (const Case& c : cases())
    for (const Setting& s : all) {
      if (!why_refused(deform_method_named(s.method), c.cage).empty()) continue;
      const auto deformer = prepared_with(c.cage, s);
      const auto wide = prepared_with<Mp50>(c.cage, s);
      const std::vector<Vec> change = some_change(c);
      // The truncation error is of order h^4, the rounding error 1e-50/h.
      const std::vector<double> truth = differences<Mp50>(c, *wide, change, Mp50(1e-8));
      const double error = largest_difference(along(c, *deformer, *derivative_of(c, s, *deformer), change), truth);
      RecordProperty(c.name + ' ' + s.text(), std::to_string(error));
      EXPECT_LT(error, 3e-14) << c.name << ' ' << s.text();
    }
}

TEST(pose_derivative, differences_of_every_setting) {
  for (const Case& c : cases())
    for (const Setting& s : settings_on(c.cage)) {
      const auto& deformer = kept_with(c.cage, s);
      if (!has_derivative(s)) {
        const std::string text = refusal_of([&] { derivative_of(c, s, deformer); });
        EXPECT_TRUE(contains(text, s.method.data()) && contains(text, "green, ")) << s.text() << ": " << text;
        continue;
      }
      const std::vector<Vec> change = some_change(c);
      const std::vector<double> truth = differences<double>(c, deformer, change, 1e-3);
      EXPECT_LT(largest_difference(along(c, deformer, *derivative_of(c, s, deformer), change), truth), 2e-10)
          << c.name << ' ' << s.text();
    }
}

TEST(pose_derivative, both_directions_are_one_matrix) {
  for (const Case& c : cases())
    for (const Setting& s : settings_on(c.cage)) {
      if (!has_derivative(s)) continue;
      const auto& deformer = kept_with(c.cage, s);
      const auto derivative = derivative_of(c, s, deformer);
      const std::vector<Vec> change = some_change(c);
      const std::vector<double> images = along(c, deformer, *derivative, change);
      std::vector<double> weights(images.size());
      for (std::size_t i = 0; i < weights.size(); ++i) weights[i] = std::sin(1.0 + static_cast<double>(i));
      const std::vector<Vec> back =
          pulled_back(deformer.coordinates(), c.points, *derivative, weights, {0, 2, 2}, std::nullopt);
      double forward = 0, backward = 0, size = 0;
      for (std::size_t i = 0; i < weights.size(); ++i) forward += weights[i] * images[i], size += std::abs(weights[i]);
      for (std::size_t v = 0; v < back.size(); ++v) backward += back[v].dot(change[v]);
      EXPECT_NEAR(forward, backward, 2e-14 * size) << c.name << ' ' << s.text();
    }
}

// f of a pose that is turned is f turned, and so is its derivative along the turn; as with shifts; with scalings where
// posed normals are not of unit length, or products of two stretches.
TEST(pose_derivative, motions_of_the_pose) {
  for (const Case& c : cases())
    for (const Setting& s : settings_on(c.cage)) {
      if (!has_derivative(s)) continue;
      const auto& deformer = kept_with(c.cage, s);
      const auto derivative = derivative_of(c, s, deformer);
      // True coordinates sum to one as far as least squares meet their data.
      const double bound = s.method.ends_with("_goursat") ? 1e-9 : 2e-13;
      const std::vector<double> images = deformed<double>(deformer, c.posed, c.points).tensors[0];
      const int d = c.cage.dimension();
      const Vec axis = d == 2 ? Vec(0, 0, 1) : Vec(.3, -.5, .8), shift = d == 2 ? Vec(1, 2, 0) : Vec(1, 2, -3);
      const auto expect = [&](const char* what, const auto& motion) {
        std::vector<Vec> change;
        change.reserve(c.posed.size());
        for (const Vec& v : c.posed) change.push_back(motion(v));
        std::vector<double> expected;
        for (std::size_t p = 0; p < c.points.size(); ++p) {
          Vec at = Vec::Zero();
          for (int k = 0; k < d; ++k) at[k] = images[p * d + k];
          const Vec to = motion(at);
          expected.insert(expected.end(), to.data(), to.data() + d);
        }
        EXPECT_LT(largest_difference(along(c, deformer, *derivative, change), expected), bound)
            << c.name << ' ' << s.text() << ": " << what;
      };
      expect("a shift", [&](const Vec&) { return Vec(shift); });
      // Displacements of linear elasticity do not turn with the pose.
      if (s.method != "elastic") expect("a turn", [&](const Vec& v) { return Vec(axis.cross(v)); });
      const bool has_unit = !s.parameters.empty() && s.parameters[0].second >= 3;
      const bool is_unit_boundary =
          (s.method == "biharmonic_boundary" || s.method == "biharmonic_goursat") && s.parameters[0].second == 0;
      if (!has_unit && !is_unit_boundary) expect("a scaling", [&](const Vec& v) { return v; });
    }
}

// A pose far away or of another size has the same derivative.
TEST(pose_derivative, places_and_sizes) {
  Case c = cube();
  const std::vector<Vec> change = some_change(c);
  for (const Setting& s : {Setting{"green", {{"stretch", 0}}}, Setting{"quad_green", {{"stretch", 1}}},
                           Setting{"biharmonic_direct", {{"normals", 2}, {"neumann", 1}}}}) {
    const auto deformer = prepared_with(c.cage, s);
    const std::vector<double> here = along(c, *deformer, *derivative_of(c, s, *deformer), change);
    // Rotations of elements are not unique where the map's stretches differ by all digits from the normal's.
    const int most = s.method == "biharmonic_direct" ? 10 : 200;
    for (const double by : {std::ldexp(1.0, most), std::ldexp(1.0, -most)}) {
      Case other = c;
      for (Vec& v : other.posed) v *= by;
      EXPECT_LT(largest_difference(along(other, *deformer, *derivative_of(other, s, *deformer), change), here), 1e-13)
          << s.text() << ' ' << by;
    }
    Case far = c;
    for (Vec& v : far.posed) v += Vec(1 << 20, 0, 0);
    EXPECT_LT(largest_difference(along(far, *deformer, *derivative_of(far, s, *deformer), change), here), 1e-9)
        << s.text();
  }
}

TEST(pose_derivative, elements_without_area) {
  Case c = cube();
  c.posed[1] = c.posed[0];
  c.posed[2] = c.posed[0];
  const auto refusal = [&](double stretch) {
    const Setting s{"green", {{"stretch", stretch}}};
    const auto deformer = prepared_with(c.cage, s);
    return refusal_of([&] { derivative_of(c, s, *deformer); });
  };
  for (const double stretch : {0., 1., 2., 3.})
    EXPECT_TRUE(contains(refusal(stretch), "no area")) << stretch << refusal(stretch);
}

TEST(pose_derivative, points_without_images) {
  const Case c = cube();
  const Setting s{"green"};
  const auto deformer = prepared_with(c.cage, s);
  const auto derivative = derivative_of(c, s, *deformer);
  std::vector<Vec> points(200, c.points[0]);
  points[70] = Vec(9, 9, 9);
  points[150] = Vec(NAN, 0, 0);
  std::vector<double> weights(600, 1.0);
  const auto region = region_of(deformer->coordinates());
  const auto pull = [&](int jobs) {
    return pulled_back(deformer->coordinates(), points, *derivative, weights, {0, jobs, 16}, region);
  };
  const BoundPoints bound(deformer->coordinates(), points, {0, 1, 16}, region);
  EXPECT_TRUE(contains(refusal_of([&] { pull(1); }), "point 70"));
  EXPECT_TRUE(contains(refusal_of([&] { bound.pulled_back(*derivative, weights, 1); }), "point 70"));
  for (const std::size_t p : {70, 150}) std::fill_n(weights.begin() + static_cast<std::ptrdiff_t>(3 * p), 3, 0.0);
  const std::vector<Vec> one = pull(1), three = pull(3), kept = bound.pulled_back(*derivative, weights, 2);
  for (std::size_t v = 0; v < one.size(); ++v) {
    EXPECT_TRUE(one[v].allFinite());
    EXPECT_EQ(one[v], three[v]);
    EXPECT_EQ(one[v], kept[v]);
  }
}

}  // namespace
}  // namespace cageproof::deformation::test::pose_derivative_test
