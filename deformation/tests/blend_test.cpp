// SPDX-License-Identifier: MIT
// Between the variants of the corotational deformer ([C23] Figure 4): rotations and stretches blended.
#include "support.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <complex>

namespace cageproof::deformation::test {
namespace {

using Complex = std::complex<double>;

enum Variant { kGlobal, kLocal, kBlend };

Images<double> somigliana(const Case& c, Variant variant, double blend, double nu = 0.3, double gamma = 1) {
  const auto deformer = prepared(c.cage, "somigliana", {static_cast<double>(variant), nu, gamma, 0, blend});
  return deformed(*deformer, c.posed, c.points);
}

double distance(const Images<double>& a, const Images<double>& b) {
  double worst = 0;
  for (std::size_t i = 0; i < a.tensors[0].size(); ++i) keep_larger(worst, std::abs(a.tensors[0][i] - b.tensors[0][i]));
  return worst;
}

TEST(blend, is_global_at_zero_and_local_at_one_exactly) {
  for (const Case& c : {cube(), bar(), l_shape(), pentagon()}) {
    const Images<double> global = somigliana(c, kGlobal, 0.25), local = somigliana(c, kLocal, 0.25);
    EXPECT_EQ(global.tensors[0], somigliana(c, kBlend, 0).tensors[0]) << c.name;
    EXPECT_EQ(local.tensors[0], somigliana(c, kBlend, 1).tensors[0]) << c.name;
    EXPECT_GT(distance(global, local), 1e-3) << c.name;
    // Without a jump at either end.
    EXPECT_LT(distance(global, somigliana(c, kBlend, 1e-10)), 1e-8) << c.name;
    EXPECT_LT(distance(local, somigliana(c, kBlend, 1 - 1e-10)), 1e-8) << c.name;
    EXPECT_GT(distance(global, somigliana(c, kBlend, 0.5)), 1e-4) << c.name;
  }
}

// Infinite nu leaves no tractions in the plane, and rotations commute with what multiplies vertices: whatever they are.
TEST(blend, of_infinite_nu_is_green_in_the_plane) {
  for (const Case& c : {square(), l_shape(), pentagon()})
    EXPECT_LT(
        distance(deformed(*prepared(c.cage, "green", {1}), c.posed, c.points), somigliana(c, kBlend, 0.5, INFINITY, 0)),
        1e-12)
        << c.name;
}

TEST(blend, keeps_similarities) {
  for (Case c : {cube(), bar()}) {
    const Eigen::Matrix3d map = 1.5 * Eigen::AngleAxisd(0.7, Vec(1, 2, -1).normalized()).toRotationMatrix();
    for (std::size_t v = 0; v < c.posed.size(); ++v) c.posed[v] = map * c.cage.vertices()[v];
    const Images<double> images = somigliana(c, kBlend, 0.375);
    for (std::size_t p = 0; p < c.points.size(); ++p)
      EXPECT_LT((image(images, p) - map * c.points[p]).norm(), 1e-13 * c.size) << c.name;
  }
}

// Eq 10-15 in the plane in complex numbers, where the rotation between two is half their angle, without bulging.
TEST(blend, halfway_is_the_mean_of_angles_and_of_stretches) {
  for (const Case& c : {square(), l_shape(), pentagon()}) {
    const double nu = 0.3;
    const CageCoordinates coordinates(c.cage, coordinate_kind_named("somigliana"),
                                      CoordinateOptions{.parameters = {1, nu}});
    const auto at = coordinates.at<double>(c.points[0], 0);
    const CageElements& elements = coordinates.elements();
    const auto complex = [](const Vec& v) { return Complex(v[0], v[1]); };
    const std::size_t n = c.posed.size();
    Complex middle, posed_middle, covariance;
    double size = 0;
    for (std::size_t v = 0; v < n; ++v) {
      middle += complex(c.cage.vertices()[v]) / static_cast<double>(n);
      posed_middle += complex(c.posed[v]) / static_cast<double>(n);
    }
    for (std::size_t v = 0; v < n; ++v) {
      const Complex step = complex(c.cage.vertices()[v]) - middle;
      covariance += (complex(c.posed[v]) - posed_middle) * std::conj(step);
      size += std::norm(step);
    }
    const auto between = [&](const Complex& local) {
      const Complex global = covariance / std::abs(covariance);
      return global * std::polar(1., std::arg(local / global) / 2);
    };
    std::vector<Complex> of_vertices(n), of_elements, tractions, normals;
    std::vector<double> lengths;
    Eigen::Matrix2d sides = Eigen::Matrix2d::Zero();
    Eigen::Vector2d uneven = Eigen::Vector2d::Zero();
    for (std::size_t e = 0; e < elements.count(); ++e) {
      const auto ends = elements.vertices_of(e);
      const Complex before = complex(c.cage.vertices()[ends[1]]) - complex(c.cage.vertices()[ends[0]]),
                    after = complex(c.posed[ends[1]]) - complex(c.posed[ends[0]]);
      const double length = std::abs(before);
      const Complex local = after / before / std::abs(after / before);
      for (const int end : ends) of_vertices[end] += length * local;
      const double stretch = (std::abs(covariance) / size + std::abs(after) / length) / 2;
      of_elements.push_back(between(local));
      normals.push_back(of_elements[e] * complex(elements.normals()[e]));
      tractions.push_back(2 * (stretch + nu / (1 - 2 * nu) * 2 * stretch) * normals[e]);
      const Eigen::Vector2d m(normals[e].real(), normals[e].imag());
      sides += length * m * m.transpose();
      uneven += length * Eigen::Vector2d(tractions[e].real(), tractions[e].imag());
    }
    const Eigen::Vector2d xi = sides.inverse() * uneven;
    Eigen::Matrix2d whole = Eigen::Matrix2d::Zero();
    Eigen::Vector2d sum = Eigen::Vector2d::Zero();
    const auto add = [&](const std::vector<double>& block, std::size_t i, const Complex& turn, const Complex& times) {
      Eigen::Matrix2d rotation, matrix;
      rotation << turn.real(), -turn.imag(), turn.imag(), turn.real();
      matrix << block[4 * i], block[4 * i + 1], block[4 * i + 2], block[4 * i + 3];
      Eigen::Matrix2d turned = rotation * matrix * rotation.transpose();
      sum += turned * Eigen::Vector2d(times.real(), times.imag());
      return turned;
    };
    for (std::size_t v = 0; v < n; ++v)
      whole += add(at[0].value, v, between(of_vertices[v] / std::abs(of_vertices[v])), complex(c.posed[v]));
    for (std::size_t e = 0; e < elements.count(); ++e)
      add(at[1].value, e, of_elements[e],
          tractions[e] - normals[e] * (normals[e].real() * xi[0] + normals[e].imag() * xi[1]));
    const Eigen::Vector2d expected = whole.inverse() * sum;
    const Images<double> found = somigliana(c, kBlend, 0.5, nu, 0);
    EXPECT_LT((expected - image(found, 0, 2).head<2>()).norm(), 1e-13 * c.size) << c.name;
  }
}

// Half a turn has no middle. Vertices that change places turn the edge between them by half a turn, and the whole by
// nothing.
TEST(blend, of_opposite_rotations_is_reported) {
  Case c = square();
  c.posed = c.cage.vertices();
  std::swap(c.posed[0], c.posed[1]);
  const auto warnings = [&](double blend) {
    return prepared(c.cage, "somigliana", {kBlend, 0.3, 0, 0, blend})->pose({c.posed, {}})->report().warnings;
  };
  const auto found = warnings(0.5);
  EXPECT_NE(std::ranges::find(found, "the rotation of element 0 is not unique"), found.end());
  const auto nearer = warnings(0.25);
  EXPECT_EQ(std::ranges::find(nearer, "the rotation of element 0 is not unique"), nearer.end());
}

}  // namespace
}  // namespace cageproof::deformation::test
