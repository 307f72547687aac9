// SPDX-License-Identifier: MIT
// Sums over clusters of far faces against sums face by face: errors as stated, and no larger than asked for.
#include "../src/batch/cluster_error.h"
#include "../src/batch/clustered_sum.h"
#include "block_errors.h"
#include "fine_sphere.h"

#include "cageproof/core/cage/embedded_cages.h"

#include <gtest/gtest.h>

#include <cmath>

namespace cageproof {
namespace {

using namespace block_errors;
namespace batch = closed_form::batch;

// The sphere drawn out to a limb along x that is a hundredth as thick at its end: faces of all sizes from 1 to 1e-3.
Cage graded(int faces) {
  const Cage round = sphere(faces);
  std::vector<Point> vertices = round.vertices();
  for (Point& v : vertices) {
    const double along = (1 + v[0]) / 2, width = std::pow(10., -2 * along);
    v = Point(4 * (1 - width), v[1] * width, v[2] * width) + Point(v[0] * width, 0, 0);
  }
  std::vector<Face> all = round.faces();
  return round.with(std::move(vertices), std::move(all));
}

// A pose with a bend, far from the origin, and normals times a factor that differs from face to face.
CageData pose_of(const CageCoordinates& coordinates, const Point& shift) {
  CageData data{3, {{}, {}}};
  for (const Point& v : coordinates.elements().vertices())
    for (const double x :
         {v[0] + 0.4 * std::sin(2 * v[1]) + shift[0], 1.2 * v[1] + shift[1], v[2] * (1 + 0.3 * v[0]) + shift[2]})
      data.blocks[0].push_back(x);
  const auto& normals = coordinates.elements().normals();
  for (std::size_t f = 0; f < normals.size(); ++f)
    for (int c = 0; c < 3; ++c)
      data.blocks[1].push_back((1.1 + 0.3 * std::sin(0.1 * static_cast<double>(f))) * normals[f][c]);
  return data;
}

double size_of(const CageData& data) {
  Point low = Point::Constant(1e300), high = -low;
  for (std::size_t i = 0; i < data.blocks[0].size(); ++i) {
    const int c = static_cast<int>(i % 3);
    low[c] = std::min(low[c], data.blocks[0][i]);
    high[c] = std::max(high[c], data.blocks[0][i]);
  }
  return (high - low).norm();
}

// Deep inside, next to faces, and on them.
std::vector<Point> points_in(const Cage& cage, const CageElements& elements, int count) {
  Point middle = Point::Zero();
  std::vector<Point> points;
  for (int i = 0; i < count; ++i) {
    RandomStream random(5, "clusters/" + cage.name(), i);
    const std::size_t e = random.below(static_cast<int>(elements.count()));
    const auto k = elements.corners(e);
    double a = random.uniform(), b = random.uniform();
    if (a + b > 1) a = 1 - a, b = 1 - b;
    const Point on = k[0] + a * (k[1] - k[0]) + b * (k[2] - k[0]);
    middle = on - elements.normals()[e] * (k[1] - k[0]).norm();
    constexpr std::array depths{3., 1., 0.3, 1e-2, 1e-6, 0.};
    points.push_back(i % 8 == 7   ? k[0]
                     : i % 8 == 6 ? Point((k[0] + k[1]) / 2)
                                  : Point(on + depths[i % 8] * (middle - on)));
  }
  return points;
}

struct Found {
  double worst = 0;  // over the size of the pose
  int together = 0;  // points that are not summed face by face
};

Found errors_of(const Cage& cage, const CageCoordinates& coordinates, int digits, const Point& shift = {0, 0, 0}) {
  const CageData data = pose_of(coordinates, shift);
  const double size = size_of(data), asked = std::pow(10., -digits) * size;
  const std::vector<Point> points = points_in(cage, coordinates.elements(), 64);
  const auto sum = coordinates.sum_to(asked, data, 1000000);
  EXPECT_GT(sum->degree(), 0) << cage.name();
  std::vector<double> values(3 * points.size(), -1), errors(points.size(), -1);
  sum->fill(points, 1, values, errors);
  const AppliedTable exact = coordinates.apply(points, 0, data);
  // Roundings of the pose, and of sums over all faces.
  const double rounding = 0x1p-53 * (64 * size + 4 * shift.norm());
  Found found;
  for (std::size_t p = 0; p < points.size(); ++p) {
    const Eigen::Map<const Point> value(&values[3 * p]), truth(&exact.tensors[0][3 * p]);
    const double error = (value - truth).norm();
    EXPECT_LE(error, errors[p] + rounding) << cage.name() << ' ' << digits << " at " << points[p].transpose();
    EXPECT_LE(errors[p], asked);
    found.worst = std::max(found.worst, error / size);
    found.together += errors[p] > 0 ? 1 : 0;
  }
  return found;
}

TEST(Clustered, images_of_spheres_have_the_digits_that_are_asked_for) {
  for (const int faces : {1280, 5120, 20480}) {
    const Cage cage = sphere(faces);
    const CageCoordinates coordinates = coordinates_of(cage, "green", "batched");
    for (const int digits : {3, 6, 12}) {
      const Found found = errors_of(cage, coordinates, digits);
      EXPECT_LE(found.worst, std::pow(10., -digits)) << faces;
      EXPECT_GE(found.together, 40) << faces << ' ' << digits;
    }
  }
}

TEST(Clustered, images_of_a_graded_cage_have_the_digits_that_are_asked_for) {
  const Cage cage = graded(5120);
  const CageCoordinates coordinates = coordinates_of(cage, "green", "batched");
  for (const int digits : {3, 6, 12}) {
    const Found found = errors_of(cage, coordinates, digits);
    EXPECT_LE(found.worst, std::pow(10., -digits));
    EXPECT_GE(found.together, 40) << digits;
  }
}

TEST(Clustered, a_pose_far_from_the_origin_keeps_its_digits) {
  const Cage cage = sphere(1280);
  const CageCoordinates coordinates = coordinates_of(cage, "green", "batched");
  EXPECT_LE(errors_of(cage, coordinates, 6, {1e5, -2e5, 3e5}).worst, 1e-6);
}

// Whatever other points are asked with it.
TEST(Clustered, an_image_depends_on_its_point_only) {
  const Cage cage = sphere(1280);
  const CageCoordinates coordinates = coordinates_of(cage, "green", "batched");
  const CageData data = pose_of(coordinates, {0, 0, 0});
  const std::vector<Point> points = points_in(cage, coordinates.elements(), 64);
  const auto sum = coordinates.sum_to(1e-6, data, 1000000);
  std::vector<double> all(3 * points.size()), one(3), errors(points.size());
  sum->fill(points, 1, all, errors);
  for (std::size_t p = 0; p < points.size(); p += 5) {
    sum->fill(std::span(points).subspan(p, 1), 1, one, std::span(errors).first(1));
    for (int c = 0; c < 3; ++c) EXPECT_EQ(one[c], all[3 * p + c]);
  }
}

TEST(Clustered, few_faces_are_summed_one_by_one) {
  const Cage cage = embedded_cage("cube");
  const CageCoordinates coordinates = coordinates_of(cage, "green", "batched");
  const CageData data = pose_of(coordinates, {0, 0, 0});
  const auto sum = coordinates.sum_to(1e-3, data, 1000000);
  EXPECT_EQ(sum->degree(), 0);
  const std::vector<Point> points{{0.1, 0.2, 0.3}, {-0.4, 0.1, 0}};
  std::vector<double> values(6), errors(2, -1);
  sum->fill(points, 1, values, errors);
  EXPECT_EQ(errors, std::vector<double>(2, 0));
  EXPECT_EQ(values, coordinates.apply(points, 0, data).tensors[0]);
}

TEST(Clustered, others_than_green_by_batched_have_none) {
  const Cage cage = embedded_cage("cube");
  for (const auto& [kind, evaluation] :
       {std::pair{"green", "hybrid"}, {"biharmonic", "batched"}, {"mean_value", "batched"}})
    EXPECT_EQ(coordinates_of(cage, kind, evaluation).sum_to(1e-3, {3, {}}, 1000), nullptr) << kind;
}

// The terms of a pole and of a dipole that are cut off, over all directions of both.
TEST(Clustered, bounds_of_what_is_cut_off_hold_and_are_met) {
  for (const double rho : {0.1, 0.4, 0.7})
    for (const int degree : {2, 7, 16}) {
      double pole = 0, dipole = 0;
      for (int i = 0; i <= 200; ++i) {
        const double t = std::cos(pi<double>() * i / 200), r = std::sqrt(1 + rho * rho - 2 * rho * t);
        // Terms rho^l P_l(t), and their derivatives along and across the source's direction.
        double before = 0, here = 1, slope_before = 0, slope = 0, power = 1, sum = 0, along = 0, across = 0;
        for (int l = 0; l <= degree; ++l) {
          sum += power * here;
          along += l * power / rho * here;
          across += power / rho * slope;
          const double next = ((2 * l + 1) * t * here - l * before) / (l + 1);
          const double slope_next = slope_before + (2 * l + 1) * here;
          before = here, here = next, slope_before = slope, slope = slope_next, power *= rho;
        }
        const double sine = std::sqrt(1 - t * t);
        pole = std::max(pole, std::abs(1 / r - sum));
        dipole = std::max(dipole, std::hypot((t - rho) / (r * r * r) - along, sine * (1 / (r * r * r) - across)));
      }
      EXPECT_LE(pole, batch::cut_off_single(degree, rho) * (1 + 1e-12) + 1e-15);
      EXPECT_LE(dipole, batch::cut_off_double(degree, rho) * (1 + 1e-12) + 1e-15);
      EXPECT_GE(pole, 0.9 * batch::cut_off_single(degree, rho) - 1e-15);
      EXPECT_GE(dipole, 0.9 * batch::cut_off_double(degree, rho) - 1e-15);
    }
}

}  // namespace
}  // namespace cageproof
