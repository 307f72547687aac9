// SPDX-License-Identifier: MIT
// Derivatives of layers by corners agree with differences of the layers in 50 digits, which share nothing with them,
// and keep laws.
#include "cageproof/fast/layer_slopes.h"

#include "cageproof/core/catalogue/evaluation.h"
#include "cageproof/core/numbers/random_stream.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <map>

namespace cageproof::fast::layer_slopes_test {
namespace {

using Vec = Vec3<double>;
constexpr double kUnit = std::numeric_limits<double>::epsilon() / 2;

// Corners, a point, and how far it is from where derivatives end.
struct Sample {
  std::string regime;
  std::vector<Vec> corners;
  Vec point;
  double distance;
  double condition = 1;
};

// One layer at a point in a scalar: one number, or one per corner.
template <Scalar R>
std::vector<R> layer(const Evaluation& of, const std::vector<Vec3<R>>& corners, const Vec3<R>& point) {
  std::vector<R> found(static_cast<std::size_t>(of.formula().components()));
  BatchOutput<R> output{.tensors = {found.data()}, .entries = 1, .dim = of.formula().dim()};
  output.stride[0] = found.size();
  of(Batch<R>{corners, std::span(&point, 1), 0, {}}, output);
  return found;
}

// Differences of fourth order by a coordinate of a corner.
std::vector<double> differences(const Evaluation& of, const Sample& s, std::size_t corner, int axis) {
  const Mp50 h = Mp50(1e-9) * s.distance;
  const auto at = [&](int steps) {
    std::vector<Vec3<Mp50>> corners;
    corners.reserve(s.corners.size());
    for (const Vec& c : s.corners) corners.push_back(convert<Mp50>(c));
    corners[corner][axis] += steps * h;
    return layer<Mp50>(of, corners, convert<Mp50>(s.point));
  };
  const auto near = at(1), back = at(-1), far = at(2), far_back = at(-2);
  std::vector<double> found;
  for (std::size_t i = 0; i < near.size(); ++i)
    found.push_back(static_cast<double>(Mp50((8 * (near[i] - back[i]) - (far[i] - far_back[i])) / (12 * h))));
  return found;
}

LayerSlopes slopes_of(const Sample& s) {
  const bool plane = s.corners.size() == 2;
  const std::string element = plane ? "segment" : "triangle";
  const auto value = [&](const char* kernel) {
    return layer<double>(evaluation_named(element + kernel, "hybrid"), s.corners, s.point);
  };
  const double single = value(".single_layer")[0];
  const std::vector<double> doubled = value(".double_layer");
  return plane ? segment_layer_slopes({s.corners[0], s.corners[1]}, s.point, single, {doubled[0], doubled[1]})
               : triangle_layer_slopes({s.corners[0], s.corners[1], s.corners[2]}, s.point, single,
                                       {doubled[0], doubled[1], doubled[2]});
}

// The largest error of a layer's slopes over the largest of them, in units of rounding times what a rounding of the
// input may cost: the size of the element over the distance. Of the single layer and the double.
std::array<double, 2> errors_of(const Sample& s) {
  const std::string element = s.corners.size() == 2 ? "segment" : "triangle";
  const Evaluation single = evaluation_named(element + ".single_layer", "closed_form"),
                   doubled = evaluation_named(element + ".double_layer", "closed_form");
  const LayerSlopes found = slopes_of(s);
  std::array<double, 2> error{}, size{};
  const auto compare = [&](int which, double value, double truth) {
    if (const double off = std::abs(value - truth); !(off <= error[which])) error[which] = off;
    size[which] = std::max(size[which], std::abs(truth));
  };
  for (std::size_t m = 0; m < s.corners.size(); ++m)
    for (int axis = 0; axis < (s.corners.size() == 2 ? 2 : 3); ++axis) {
      compare(0, found.single[m][axis], differences(single, s, m, axis)[0]);
      const std::vector<double> truth = differences(doubled, s, m, axis);
      for (std::size_t j = 0; j < s.corners.size(); ++j) compare(1, found.doubled[j][m][axis], truth[j]);
    }
  const double unit = kUnit * s.condition;
  return {error[0] / size[0] / unit, error[1] / size[1] / unit};
}

Vec any(RandomStream& random, bool plane) {
  return {random.uniform(-1, 1), random.uniform(-1, 1), plane ? 0 : random.uniform(-1, 1)};
}

std::vector<Sample> samples(bool plane, int count) {
  std::vector<Sample> found;
  for (int i = 0; i < count; ++i) {
    RandomStream random(11, plane ? "segment slopes" : "triangle slopes", i);
    std::vector<Vec> corners{any(random, plane), any(random, plane)};
    if (!plane) corners.push_back(any(random, plane));
    Vec middle = Vec::Zero();
    for (const Vec& c : corners) middle += c / static_cast<double>(corners.size());
    const double size = (corners[1] - corners[0]).norm(), small = std::pow(10.0, -1 - i % 9);
    const double u = random.uniform(0.2, 0.8);
    const Vec on_side = u * corners[0] + (1 - u) * corners[1], step = any(random, plane);
    const auto add = [&](const char* regime, const Vec& point, double distance, double condition = 1) {
      found.push_back({regime, corners, point, distance, condition});
    };
    add("about", middle + step, 0.1 * size);
    add("far", middle + std::pow(10.0, 1 + i % 6) * step, size);
    add("next to a corner", corners[0] + small * step, small * step.norm(), size / (small * step.norm()));
    if (plane) {
      add("next to a face", on_side + small * step, small * std::abs(step.norm()));
      continue;
    }
    const Vec across = (corners[1] - corners[0]).cross(corners[2] - corners[0]);
    const double from_side = small * step.cross((corners[1] - corners[0]) / size).norm();
    add("next to a side", on_side + small * step, from_side, size / from_side);
    add("next to a face", middle + small * across, 0.01 * size);
    add("in the plane", 2 * corners[1] - middle, 0.1 * size);
    const double thin = std::pow(10.0, -1 - i % 4);
    corners[2] = on_side + thin * (corners[2] - on_side);
    add("thin", middle + step, 0.1 * thin * size, 1 / (thin * thin));
  }
  return found;
}

void expect_errors(bool plane, const std::map<std::string, std::array<double, 2>>& most) {
  std::map<std::string, std::array<double, 2>> worst;
  for (const Sample& s : samples(plane, 40)) {
    const std::array<double, 2> errors = errors_of(s);
    for (int which = 0; which < 2; ++which) {
      double& largest = worst[s.regime][which];
      if (!(errors[which] <= largest)) largest = errors[which];
    }
  }
  for (const auto& [regime, errors] : worst) {
    ::testing::Test::RecordProperty(regime, std::to_string(errors[0]) + ' ' + std::to_string(errors[1]));
    ASSERT_TRUE(most.contains(regime)) << regime;
    EXPECT_LE(errors[0], most.at(regime)[0]) << regime;
    EXPECT_LE(errors[1], most.at(regime)[1]) << regime;
  }
}

TEST(layer_slopes, triangle_against_50_digits) {
  // Twice or so what was measured.
  expect_errors(false, {{"about", {32, 256}},
                        {"far", {32, 512}},
                        {"in the plane", {64, 1024}},
                        {"next to a corner", {4, 16}},
                        {"next to a side", {2, 4}},
                        {"next to a face", {16, 64}},
                        {"thin", {1, 128}}});
}

TEST(layer_slopes, segment_against_50_digits) {
  expect_errors(true,
                {{"about", {16, 32}}, {"far", {8, 16}}, {"next to a corner", {1, 4}}, {"next to a face", {8, 16}}});
}

// Moving corners and point together changes nothing, and so does scaling them; of the double layer.
TEST(layer_slopes, laws) {
  for (const bool plane : {false, true})
    for (const Sample& s : samples(plane, 40)) {
      if (s.regime != "about") continue;
      const LayerSlopes found = slopes_of(s);
      Vec sum = Vec::Zero();
      double along = 0, size = 0;
      for (std::size_t m = 0; m < s.corners.size(); ++m) {
        for (std::size_t j = 0; j < s.corners.size(); ++j) {
          sum += found.doubled[j][m];
          // The hat functions add up to one, and the solid angle is of degree zero.
          along += found.doubled[j][m].dot(s.corners[m] - s.point);
          size += found.doubled[j][m].norm();
        }
      }
      EXPECT_LT(std::abs(along), 1e-13 * size);
      const std::string element = plane ? "segment" : "triangle";
      const Evaluation of = evaluation_named(element + ".double_layer", "hybrid");
      std::vector<double> values(s.corners.size()), gradients(s.corners.size() * (plane ? 2 : 3));
      BatchOutput<double> output{.tensors = {values.data(), gradients.data()}, .entries = 1, .dim = plane ? 2 : 3};
      output.stride[0] = values.size(), output.stride[1] = gradients.size();
      of(Batch<double>{s.corners, std::span(&s.point, 1), 1, {}}, output);
      for (std::size_t i = 0; i < gradients.size(); ++i) sum[static_cast<int>(i % (plane ? 2 : 3))] += gradients[i];
      EXPECT_LT(sum.norm(), 1e-13 * size);
    }
}

TEST(layer_slopes, none_on_the_border) {
  const std::vector<Vec> corners{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
  for (const Vec& point : {corners[1], Vec(0.5, 0, 0), Vec(0, 0.25, 0)}) {
    const LayerSlopes found = slopes_of({"", corners, point, 0});
    EXPECT_FALSE(found.doubled[0][0].allFinite() && found.doubled[1][1].allFinite() && found.doubled[2][2].allFinite());
  }
}

}  // namespace
}  // namespace cageproof::fast::layer_slopes_test
