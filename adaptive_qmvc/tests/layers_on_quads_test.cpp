// SPDX-License-Identifier: MIT
// Green, biharmonic and Somigliana coordinates of cages that keep their quads: what their sums reproduce, in, on and
// outside cages of twisted, planar and mixed faces.
#include "cageproof/core/coordinates/coordinates.h"
#include "cageproof/core/cage/embedded_cages.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace cageproof::adaptive_qmvc::layers_on_quads_test {
namespace {

using Vec = Vec3<double>;
using Eigen::Matrix3d;

// A cube of integers, one whose faces are all twisted, and one of those with a face in two triangles.
std::vector<Cage> cages() {
  std::vector<Vec> integers, twisted;
  integers.reserve(8);
  for (int i = 0; i < 8; ++i) integers.emplace_back(i & 1, (i >> 1) & 1, (i >> 2) & 1);
  twisted = integers;
  for (int i = 0; i < 8; ++i) twisted[i] += Vec(0.03125 * (i % 3), -0.046875 * (i % 4), 0.0390625 * ((i * i) % 5));
  const std::vector<Face> quads{{{0, 2, 3, 1}}, {{4, 5, 7, 6}}, {{0, 1, 5, 4}},
                                {{2, 6, 7, 3}}, {{0, 4, 6, 2}}, {{1, 3, 7, 5}}};
  std::vector<Face> mixed(quads.begin() + 1, quads.end());
  mixed.push_back({{0, 2, 3, -1}});
  mixed.push_back({{0, 3, 1, -1}});
  return {Cage::make("integers", integers, quads), Cage::make("twisted", twisted, quads),
          Cage::make("mixed", twisted, mixed)};
}

struct Sums {
  double of_one;
  Vec position;
  Matrix3d gradient;  // of the position
  Vec gradient_of_one;
};

Sums sums_at(const CageCoordinates& coordinates, const std::vector<Result<double>>& found, int order) {
  Sums sums{0, Vec::Zero(), Matrix3d::Zero(), Vec::Zero()};
  const CageElements& elements = coordinates.elements();
  for (std::size_t b = 0; b < found.size(); ++b) {
    const CoordinateBlock& block = coordinates.blocks()[b];
    if (block.reproduces != Reproduces::Vertices && block.reproduces != Reproduces::Normals) continue;
    for (int i = 0; i < block.size; ++i) {
      const bool vertex = block.reproduces == Reproduces::Vertices;
      const Vec datum = vertex ? elements.vertices()[i] : Vec(block.normal_factor * elements.normal_of(i, block.owner));
      sums.position += found[b].value[i] * datum;
      if (vertex) sums.of_one += found[b].value[i];
      if (order < 1) continue;
      const Vec gradient(found[b].gradient[3 * i], found[b].gradient[3 * i + 1], found[b].gradient[3 * i + 2]);
      sums.gradient += datum * gradient.transpose();
      if (vertex) sums.gradient_of_one += gradient;
    }
  }
  return sums;
}

CageCoordinates prepared(const Cage& cage, const char* kind) {
  return CageCoordinates(cage, coordinate_kind_named(kind), CoordinateOptions{});
}

const std::vector<Vec> kInside{Vec(0.5, 0.4, 0.5), Vec(0.25, 0.5, 0.75), Vec(0.5, 0.4, 0.2)},
    kOutside{Vec(3, 0, 0), Vec(0.5, 0.5, -2), Vec(100, -50, 20)};

TEST(LayersOnQuads, reproduce_positions_inside_and_nothing_outside) {
  for (const Cage& cage : cages())
    for (const char* kind : {"quad_green", "quad_biharmonic"}) {
      const CageCoordinates coordinates = prepared(cage, kind);
      for (const Vec& point : kInside) {
        const Sums sums = sums_at(coordinates, coordinates.at<double>(point, 1), 1);
        EXPECT_NEAR(sums.of_one, 1, 4e-15) << cage.name();
        EXPECT_LT((sums.position - point).norm(), 4e-15) << cage.name();
        EXPECT_LT(sums.gradient_of_one.norm(), 2e-14) << cage.name();
        EXPECT_LT((sums.gradient - Matrix3d::Identity()).norm(), 2e-14) << cage.name();
      }
      for (const Vec& point : kOutside) {
        const Sums sums = sums_at(coordinates, coordinates.at<double>(point, 1), 1);
        EXPECT_LT(std::abs(sums.of_one) + sums.position.norm(), 1e-13) << cage.name();
        EXPECT_LT(sums.gradient_of_one.norm() + sums.gradient.norm(), 1e-13) << cage.name();
      }
    }
}

TEST(LayersOnQuads, reproduce_positions_on_faces_edges_and_vertices) {
  for (const Cage& cage : cages()) {
    const CageCoordinates coordinates = prepared(cage, "quad_green");
    const std::vector<Vec>& v = cage.vertices();
    std::vector<Vec> points = v;
    for (const Face& face : cage.faces())
      for (int k = 0; k < face.size(); ++k)
        points.emplace_back((v[face.vertices[k]] + v[face.vertices[(k + 1) % face.size()]]) / 2);
    if (cage.name() == "integers")
      points.insert(points.end(), {Vec(0.5, 0.5, 0), Vec(0, 0.25, 0.125), Vec(1, 0.75, 0.5)});
    for (const Vec& point : points) {
      const Sums sums = sums_at(coordinates, coordinates.at<double>(point, 0), 0);
      EXPECT_NEAR(sums.of_one, 1, 4e-15) << cage.name() << " " << point.transpose();
      EXPECT_LT((sums.position - point).norm(), 1e-14) << cage.name() << " " << point.transpose();
    }
  }
}

// Limits at points within faces, which doubles need not hold: twisted faces as well as flat ones.
TEST(LayersOnQuads, have_limits_with_derivatives_within_faces) {
  for (const Cage& cage : cages()) {
    const CageCoordinates coordinates = prepared(cage, "quad_green");
    const CageElements& elements = coordinates.elements();
    std::vector<Touching> places;
    for (std::size_t e = 0; e < elements.count(); ++e) {
      const double u = 0.3, w = 0.6;
      if (elements.type(e).flat) places.push_back({static_cast<int>(e), {0.2, 0.3, 0.5, 0}});
      else places.push_back({static_cast<int>(e), {(1 - u) * (1 - w), u * (1 - w), u * w, (1 - u) * w}});
    }
    const auto limits = coordinates.limits_at<double>(places, 1);
    for (std::size_t p = 0; p < places.size(); ++p) {
      Vec point = Vec::Zero();
      const auto vertices = elements.vertices_of(places[p].element);
      for (std::size_t k = 0; k < vertices.size(); ++k) point += places[p].basis[k] * elements.vertices()[vertices[k]];
      std::vector<Result<double>> at(limits.size());
      for (std::size_t b = 0; b < limits.size(); ++b)
        for (int o = 0; o <= 1; ++o) {
          const auto first = limits[b].tensors[o].begin() + static_cast<std::ptrdiff_t>(p * limits[b].stride[o]);
          at[b].of(o).assign(first, first + static_cast<std::ptrdiff_t>(limits[b].stride[o]));
        }
      const Sums sums = sums_at(coordinates, at, 1);
      EXPECT_NEAR(sums.of_one, 1, 1e-14) << cage.name() << " " << p;
      EXPECT_LT((sums.position - point).norm(), 1e-14) << cage.name() << " " << p;
      EXPECT_LT(sums.gradient_of_one.norm(), 1e-13) << cage.name() << " " << p;
      EXPECT_LT((sums.gradient - Matrix3d::Identity()).norm(), 1e-13) << cage.name() << " " << p;
    }
  }
}

// A generic linear displacement, with its own tractions.
TEST(LayersOnQuads, of_somigliana_reproduce_linear_displacements) {
  const Matrix3d f = (Matrix3d() << 1.3, 0.05, -0.2, 0.2, 0.8, 0.1, -0.1, 0.3, 1.1).finished();
  constexpr double mu = 1, nu = 0.3;  // the kind's defaults are read below
  for (const Cage& cage : cages()) {
    const CageCoordinates coordinates(cage, coordinate_kind_named("quad_somigliana"),
                                      CoordinateOptions{.parameters = {mu, nu}});
    const Matrix3d stress = 2 * mu * nu / (1 - 2 * nu) * f.trace() * Matrix3d::Identity() + mu * (f + f.transpose());
    const CageElements& elements = coordinates.elements();
    const auto displacement_at = [&](const Vec& point) {
      const auto found = coordinates.at<double>(point, 0);
      Vec sum = Vec::Zero();
      for (std::size_t b = 0; b < found.size(); ++b) {
        const CoordinateBlock& block = coordinates.blocks()[b];
        for (int i = 0; i < block.size; ++i) {
          const Vec datum = block.owner == Owner::Vertex ? Vec(f * elements.vertices()[i])
                                                         : Vec(stress * elements.normal_of(i, block.owner));
          sum += Eigen::Map<const Eigen::Matrix<double, 3, 3, Eigen::RowMajor>>(&found[b].value[9 * i]) * datum;
        }
      }
      return sum;
    };
    for (const Vec& point : kInside) EXPECT_LT((displacement_at(point) - f * point).norm(), 1e-14) << cage.name();
    for (const Vec& point : kOutside) EXPECT_LT(displacement_at(point).norm(), 1e-13) << cage.name();
  }
}

// Without its area element a quad's layer would leave the range of doubles, of Hessians first. Units are powers of two,
// so that nothing but exponents changes.
TEST(LayersOnQuads, are_the_same_in_any_unit) {
  const Cage cage = cages()[2];
  const CageCoordinates coordinates(cage, coordinate_kind_named("quad_green"),
                                    CoordinateOptions{.evaluation = "line_form"});
  for (const int exponent : {-340, -60, 332}) {
    std::vector<Vec> vertices = cage.vertices();
    for (Vec& vertex : vertices) vertex *= std::ldexp(1., exponent);
    const CageCoordinates scaled(cage.with(vertices, cage.faces()), coordinate_kind_named("quad_green"),
                                 CoordinateOptions{.evaluation = "line_form"});
    for (const Vec& point : {Vec(0.5, 0.375, 0.125), Vec(0x1p14, 0x1p13, 3), Vec(0x1p27, 0, 0x1p26)}) {
      const auto expected = coordinates.at<double>(point, 2),
                 found = scaled.at<double>(Vec(point * std::ldexp(1., exponent)), 2);
      for (std::size_t b = 0; b < found.size(); ++b)
        for (int o = 0; o <= 2; ++o)
          for (std::size_t i = 0; i < found[b].of(o).size(); ++i)
            ASSERT_EQ(found[b].of(o)[i],
                      std::ldexp(expected[b].of(o)[i], (coordinates.blocks()[b].degree - o) * exponent))
                << exponent << " block " << b << " order " << o << " from " << point.transpose();
    }
  }
}

// One normal of a flat element, four of a quad, of unit length; where the surface is no parallelogram they differ.
TEST(LayersOnQuads, have_one_normal_a_corner) {
  const std::vector<Cage> all = cages();
  const CageCoordinates mixed = prepared(all[2], "quad_green");
  const CageElements& elements = mixed.elements();
  ASSERT_EQ(elements.count(Owner::Normal), 5U * 4 + 2);
  EXPECT_EQ(mixed.blocks()[1].size, 22);
  EXPECT_EQ(elements.shares_of(0, Owner::Normal).size(), 4U);
  EXPECT_EQ(elements.shares_of(6, Owner::Normal).size(), 1U);
  EXPECT_EQ(elements.element_of(21, Owner::Normal), 6U);
  for (std::size_t i = 0; i < 22; ++i) EXPECT_NEAR(elements.normal_of(i, Owner::Normal).norm(), 1, 1e-15);
  EXPECT_GT((elements.normal_of(0, Owner::Normal) - elements.normal_of(2, Owner::Normal)).norm(), 1e-2);
  EXPECT_EQ(elements.area_element_of(20, Owner::Normal), 1);
  EXPECT_EQ(prepared(all[0], "quad_green").elements().area_element_of(5, Owner::Normal), 1);
}

TEST(LayersOnQuads, keep_quads_of_kinds_that_have_such_a_form) {
  EXPECT_EQ(keeping_quads(coordinate_kind_named("green")).name, "quad_green");
  EXPECT_EQ(keeping_quads(coordinate_kind_named("quad_somigliana")).name, "quad_somigliana");
  EXPECT_EQ(keeping_quads(coordinate_kind_named("maximum_entropy")).name, "maximum_entropy");
  EXPECT_ANY_THROW(keeping_quads(coordinate_kind_named("biharmonic_affine")));
}

}  // namespace
}  // namespace cageproof::adaptive_qmvc::layers_on_quads_test
