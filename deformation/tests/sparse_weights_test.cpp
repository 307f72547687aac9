// SPDX-License-Identifier: MIT
// Bounds of rows with dropped weights, against the worst poses that are found, and against half of themselves.
#include "support.h"

#include "cageproof/core/input_error.h"
#include "cageproof/deformation/sparse_weights.h"
#include "cageproof/deformation/stretch.h"

#include <gtest/gtest.h>

#include <random>

namespace cageproof::deformation::sparse_weights_test {
namespace {

using test::Vec;
using Wide = Eigen::Matrix<long double, 3, 1>;

// Points all over the cage's box, some of them outside the cage.
std::vector<Vec> points_in(const Cage& cage, int count, std::mt19937& random) {
  Vec low = cage.vertices()[0], high = low;
  for (const Vec& v : cage.vertices()) low = low.cwiseMin(v), high = high.cwiseMax(v);
  std::uniform_real_distribution<double> share(0.02, 0.98);
  std::vector<Vec> points;
  for (int p = 0; p < count; ++p) {
    Vec at;
    for (int k = 0; k < 3; ++k) at[k] = low[k] + share(random) * (high[k] - low[k]);
    points.push_back(at);
  }
  return points;
}

// Rows of all blocks side by side.
std::vector<std::vector<double>> rows_of(const CageCoordinates& coordinates, const std::vector<Vec>& points) {
  const auto tables = coordinates.at<double>(points, 0);
  std::vector<std::vector<double>> rows(points.size());
  for (std::size_t p = 0; p < points.size(); ++p)
    for (const auto& table : tables)
      for (std::size_t i = 0; i < table.stride[0]; ++i) rows[p].push_back(table.tensors[0][p * table.stride[0] + i]);
  return rows;
}

std::vector<double> dense(const SparseRow& row, std::size_t columns) {
  std::vector<double> weights(columns, 0);
  for (std::size_t i = 0; i < row.columns.size(); ++i) weights[row.columns[i]] = row.weights[i];
  return weights;
}

std::vector<double> changes_of(const std::vector<double>& before, const std::vector<double>& after) {
  std::vector<double> changes(before.size());
  for (std::size_t i = 0; i < before.size(); ++i) changes[i] = after[i] - before[i];
  return changes;
}

// The product of a row with what it multiplies.
Wide image(const std::vector<double>& weights, const std::vector<Vec>& multiplied) {
  Wide sum = Wide::Zero();
  for (std::size_t i = 0; i < multiplied.size(); ++i)
    sum += multiplied[i].cast<long double>() * (long double)(weights[i]);
  return sum;
}

// Posed vertices, then stretched normals where the row has any.
std::vector<Vec> multiplied_by(const CageCoordinates& coordinates, const std::vector<Vec>& posed, Stretch stretch) {
  std::vector<Vec> all;
  for (const CoordinateBlock& block : coordinates.blocks()) {
    if (block.reproduces == Reproduces::Vertices) all.insert(all.end(), posed.begin(), posed.end());
    else if (block.reproduces == Reproduces::TurnedVertices)
      for (const Vec& v : posed) all.emplace_back(-v[1], v[0], 0);
    else std::ranges::copy(stretched_normals(stretch, coordinates.elements(), posed), std::back_inserter(all));
  }
  return all;
}

Vec direction(std::mt19937& random, int dimension) {
  std::normal_distribution<double> normal;
  Vec v = Vec::Zero();
  for (int k = 0; k < dimension; ++k) v[k] = normal(random);
  return v.normalized();
}

// The vertices moved by `moved`, along the change of the place at rest, to the side of the sign of their weights'
// change: the worst pose where rows multiply vertices only.
std::vector<Vec> worst_pose(const CageCoordinates& coordinates, const std::vector<double>& changes, double moved,
                            std::mt19937& random) {
  const std::vector<Vec>& rest = coordinates.elements().vertices();
  Vec along = image(changes, rest).cast<double>();
  if (!(along.norm() > 0)) along = direction(random, coordinates.dimension());
  along.normalize();
  std::vector<Vec> posed = rest;
  for (std::size_t v = 0; v < posed.size(); ++v) posed[v] += (changes[v] < 0 ? -moved : moved) * along;
  return posed;
}

std::vector<Vec> random_pose(const std::vector<Vec>& rest, double moved, int dimension, std::mt19937& random) {
  std::vector<Vec> posed = rest;
  for (Vec& v : posed) v += moved * direction(random, dimension);
  return posed;
}

// How far the row's point is off under the worst of these poses.
double worst_found(const CageCoordinates& coordinates, const std::vector<double>& before,
                   const std::vector<double>& after, double moved, std::mt19937& random) {
  const std::vector<double> changes = changes_of(before, after);
  double worst = 0;
  for (int pose = 0; pose < 6; ++pose) {
    const std::vector<Vec>& rest = coordinates.elements().vertices();
    const std::vector<Vec> posed = pose == 0   ? worst_pose(coordinates, changes, moved, random)
                                   : pose == 1 ? rest
                                               : random_pose(rest, moved, coordinates.dimension(), random);
    for (const Stretch stretch : {Stretch::Rms, Stretch::Mean, Stretch::Area, Stretch::Unit}) {
      const std::vector<Vec> multiplied = multiplied_by(coordinates, posed, stretch);
      worst = std::max(worst, static_cast<double>((image(after, multiplied) - image(before, multiplied)).norm()));
    }
  }
  return worst;
}

struct Ratios {
  double least = 1;  // of the worst that is found over the bound
  std::size_t kept = 0, all = 0;
};

Ratios ratios(const CageCoordinates& coordinates, const std::vector<Vec>& points, double size, double tolerance,
              double budget, WeightFormat format) {
  std::mt19937 random(5);
  const double moved = budget * size;
  const SparseWeights weights(pose_reach(coordinates, moved, size), tolerance * size, format);
  Ratios found;
  for (const std::vector<double>& row : rows_of(coordinates, points)) {
    const SparseRow sparse = weights.row(row);
    EXPECT_TRUE(sparse.finite);
    EXPECT_TRUE(std::ranges::is_sorted(sparse.columns));
    found.kept += sparse.columns.size();
    found.all += row.size();
    const double off = worst_found(coordinates, row, dense(sparse, row.size()), moved, random);
    EXPECT_LE(off, sparse.bound + 1e-17 * size);
    if (!(sparse.bound > 1e-13 * size)) continue;
    found.least = std::min(found.least, off / sparse.bound);
  }
  return found;
}

// Rows that multiply vertices attain the bound: 0.99 of it would be broken.
TEST(SparseWeights, of_vertices_are_off_by_their_bound) {
  std::mt19937 random(3);
  for (const char* name : {"cube", "l-block", "icosphere"}) {
    const Cage cage = embedded_cage(name);
    const std::vector<Vec> points = points_in(cage, 40, random);
    const CageCoordinates coordinates(cage, coordinate_kind_named("mean_value"), CoordinateOptions{});
    for (const double tolerance : {1e-1, 1e-3})
      for (const double budget : {1.0, 0.05})
        for (const WeightFormat format : {WeightFormat::Double, WeightFormat::Float, WeightFormat::Half}) {
          const Ratios found = ratios(coordinates, points, cage.size(), tolerance, budget, format);
          EXPECT_GT(found.least, .99) << name << ' ' << tolerance << ' ' << budget;
        }
  }
}

TEST(SparseWeights, of_normals_stay_within_their_bound) {
  std::mt19937 random(4);
  for (const char* name : {"cube", "l-block", "square"}) {
    const Cage cage = embedded_cage(name);
    std::vector<Vec> points = points_in(cage, 30, random);
    for (const char* kind : {"green", "cauchy", "regularised_1_3"}) {
      if (!accepts(coordinate_kind_named(kind), cage)) continue;
      const CageCoordinates coordinates(cage, coordinate_kind_named(kind), CoordinateOptions{});
      for (const double tolerance : {1e-1, 1e-3})
        for (const double budget : {1.0, 0.05}) {
          const Ratios found = ratios(coordinates, points, cage.size(), tolerance, budget, WeightFormat::Float);
          EXPECT_GT(found.least, 1 / 12.) << name << ' ' << kind << ' ' << tolerance << ' ' << budget;
        }
    }
  }
}

// The farthest that a triangle's stretched normal gets from the normal at rest over poses: its stretch is a convex
// function, which rises when each corner goes as far as it may along its gradient; turns are tried by corners that go
// up or down.
double farthest_normal(const CageElements& elements, std::size_t element, double moved, std::mt19937& random) {
  const auto corners = elements.vertices_of(element);
  const std::vector<Vec>& rest = elements.vertices();
  const auto edges = [&](const std::vector<Vec>& v) {
    Eigen::Matrix<double, 3, 2> both;
    both << v[corners[1]] - v[corners[0]], v[corners[2]] - v[corners[0]];
    return both;
  };
  const Eigen::Matrix<double, 3, 2> at_rest = edges(rest);
  const Eigen::Matrix<double, 2, 3> gradients = (at_rest.transpose() * at_rest).inverse() * at_rest.transpose();
  const Vec normal = elements.normals()[element];
  double most = 0;
  const auto look = [&](const std::vector<Vec>& posed) {
    for (const Stretch stretch : {Stretch::Rms, Stretch::Mean, Stretch::Area, Stretch::Unit})
      most = std::max(
          most,
          (stretch_of(stretch, elements, posed, element) * posed_normal(elements, posed, element) - normal).norm());
  };
  for (int start = 0; start < 20; ++start) {
    std::vector<Vec> posed = random_pose(rest, moved, 3, random);
    for (int step = 0; step < 50; ++step) {
      const Eigen::Matrix3d map = edges(posed) * gradients;
      for (int k = 0; k < 3; ++k) {
        const Vec gradient =
            k == 0 ? Vec(-(gradients.row(0) + gradients.row(1)).transpose()) : Vec(gradients.row(k - 1).transpose());
        posed[corners[k]] = rest[corners[k]] + moved * (map * gradient).normalized();
      }
    }
    look(posed);
  }
  for (int up = 0; up < 8; ++up) {
    std::vector<Vec> posed = rest;
    for (int k = 0; k < 3; ++k) posed[corners[k]] += ((up >> k) % 2 == 0 ? moved : -moved) * normal;
    look(posed);
  }
  return most;
}

TEST(SparseWeights, normals_reach_as_far_as_the_worst_poses_take_them) {
  std::mt19937 random(6);
  const Cage sliver = Cage::make("sliver", {{0, 0, 0}, {2, 0, 0}, {1, .02, 0}, {.7, .4, 1}},
                                 {{{0, 2, 1, -1}}, {{0, 1, 3, -1}}, {{1, 2, 3, -1}}, {{2, 0, 3, -1}}}, {});
  for (const Cage& cage : {embedded_cage("cube"), embedded_cage("l-block"), sliver}) {
    const CageCoordinates coordinates(cage, coordinate_kind_named("green"), CoordinateOptions{});
    for (const double budget : {1.0, .1, .001}) {
      const double moved = budget * cage.size();
      const std::vector<PoseReach> reaches = pose_reach(coordinates, moved, cage.size());
      const std::size_t vertices = cage.vertices().size();
      for (std::size_t e = 0; e < coordinates.elements().count(); ++e) {
        const PoseReach& reach = reaches[vertices + e];
        EXPECT_EQ(reach.centre, coordinates.elements().normals()[e]);
        const double found = farthest_normal(coordinates.elements(), e, moved, random);
        EXPECT_LE(found, reach.radius) << cage.name() << ' ' << e << ' ' << budget;
        EXPECT_GT(found, reach.radius / 3) << cage.name() << ' ' << e << ' ' << budget;
      }
    }
  }
}

// A cage far from the origin loses as many weights as one at it, because sums of weights stay.
TEST(SparseWeights, do_not_ask_where_the_origin_is) {
  std::mt19937 random(7);
  const Cage cage = embedded_cage("icosphere");
  std::vector<Vec> points = points_in(cage, 20, random), vertices = cage.vertices();
  const Vec far(1 << 20, -(1 << 19), 1 << 18);
  const auto kept = [&](const Cage& at) {
    const CageCoordinates coordinates(at, coordinate_kind_named("mean_value"), CoordinateOptions{});
    return ratios(coordinates, points, at.size(), 5e-2, 1, WeightFormat::Double);
  };
  const Ratios here = kept(cage);
  for (Vec& v : vertices) v += far;
  for (Vec& p : points) p += far;
  const Ratios there = kept(cage.with(vertices, cage.faces()));
  EXPECT_LT(here.kept, here.all * 9 / 10);
  EXPECT_NEAR(static_cast<double>(there.kept), static_cast<double>(here.kept), .01 * static_cast<double>(here.kept));
}

TEST(SparseWeights, keep_sums_and_signs_and_drop_what_they_can) {
  std::mt19937 random(8);
  const Cage cage = embedded_cage("icosphere");
  const CageCoordinates coordinates(cage, coordinate_kind_named("mean_value"), CoordinateOptions{});
  const std::vector<std::vector<double>> rows = rows_of(coordinates, points_in(cage, 40, random));
  const auto of = [&](double tolerance, WeightFormat format) {
    return SparseWeights(pose_reach(coordinates, cage.size(), cage.size()), tolerance * cage.size(), format);
  };
  for (const std::vector<double>& row : rows) {
    std::size_t before = row.size() + 1;
    for (const double tolerance : {0.0, 1e-4, 1e-3, 1e-2, 1e-1, 1.0}) {
      const SparseRow sparse = of(tolerance, WeightFormat::Double).row(row);
      EXPECT_LE(sparse.bound, tolerance * cage.size());
      EXPECT_LE(sparse.sum_change, 1e-15);
      EXPECT_LE(sparse.columns.size(), before);
      EXPECT_GE(sparse.columns.size(), 1U);
      before = sparse.columns.size();
      if (tolerance == 0) EXPECT_EQ(dense(sparse, row.size()), row);
    }
    const SparseRow half = of(1e-1, WeightFormat::Half).row(row);
    EXPECT_LE(half.sum_change, 1e-3);
    for (std::size_t i = 0; i < half.columns.size(); ++i) {
      EXPECT_GT(half.weights[i] * row[half.columns[i]], 0);
      EXPECT_EQ(rounded_to(WeightFormat::Half, half.weights[i]), half.weights[i]);
    }
    // Rounding to half takes more than this: nothing is dropped then, and the bound says so.
    EXPECT_GT(of(1e-9, WeightFormat::Half).row(row).bound, 1e-9 * cage.size());
  }
}

// Where poses move little, a row may lose more of its weights, because its image of the cage at rest stays.
TEST(SparseWeights, drop_more_where_poses_move_less) {
  std::mt19937 random(9);
  const Cage cage = embedded_cage("icosphere");
  const std::vector<Vec> points = points_in(cage, 20, random);
  for (const char* kind : {"mean_value", "green"}) {
    const CageCoordinates coordinates(cage, coordinate_kind_named(kind), CoordinateOptions{});
    const std::size_t all = points.size() * rows_of(coordinates, points)[0].size();
    std::size_t before = all;
    for (const double budget : {1.0, .1, .01}) {
      const Ratios found = ratios(coordinates, points, cage.size(), 1e-2, budget, WeightFormat::Double);
      EXPECT_LT(found.kept, before) << kind << ' ' << budget;
      before = found.kept;
    }
    EXPECT_LT(before, all * 9 / 10) << kind;
  }
}

TEST(SparseWeights, of_rows_that_are_not_finite_are_one_nan) {
  const SparseWeights weights({{Vec(0, 0, 0), 1, 0}, {Vec(1, 0, 0), 1, 0}}, .1, WeightFormat::Float);
  for (const double bad : {std::nan(""), HUGE_VAL}) {
    const SparseRow row = weights.row(std::vector<double>{.5, bad});
    EXPECT_FALSE(row.finite);
    ASSERT_EQ(row.columns.size(), 1U);
    EXPECT_TRUE(std::isnan(row.weights[0]));
  }
  // Beyond half's range nothing bounds it.
  const SparseWeights half({{Vec(0, 0, 0), 1, 0}, {Vec(1, 0, 0), 1, 0}}, .1, WeightFormat::Half);
  EXPECT_TRUE(std::isinf(half.row(std::vector<double>{1e5, -1e5}).bound));
  // A row of zeros keeps a place, so that each row has one.
  EXPECT_EQ(half.row(std::vector<double>{0, 0}).columns.size(), 1U);
}

TEST(SparseWeights, are_rounded_as_ieee_says) {
  EXPECT_EQ(half_bits(1), 0x3c00);
  EXPECT_EQ(half_bits(-2), 0xc000);
  EXPECT_EQ(half_bits(65504), 0x7bff);
  EXPECT_EQ(half_bits(70000), 0x7c00);
  EXPECT_EQ(half_bits(std::ldexp(1, -24)), 1);
  EXPECT_EQ(half_bits(1e-9), 0);
  EXPECT_EQ(rounded_to(WeightFormat::Half, 1 + std::ldexp(1, -11)), 1);
  EXPECT_EQ(rounded_to(WeightFormat::Half, .1), 0x1.998p-4);
  EXPECT_EQ(rounded_to(WeightFormat::Float, .1), static_cast<double>(.1F));
  EXPECT_EQ(rounded_to(WeightFormat::Double, .1), .1);
}

// Kinds without a bound say why, and no others.
TEST(SparseWeights, are_refused_to_kinds_without_a_bound) {
  for (const char* name : {"cube", "square"}) {
    const Cage cage = embedded_cage(name);
    const std::vector<std::string_view> with = kinds_with_reach(cage.dimension());
    for (const char* kind : {"mean_value", "green"}) EXPECT_EQ(std::ranges::count(with, kind), 1) << kind;
    for (const char* kind : {"somigliana", "biharmonic", "biharmonic_affine", "triharmonic_boundary"})
      EXPECT_EQ(std::ranges::count(with, kind), 0) << kind;
    for (const char* kind : {"somigliana", "biharmonic"}) {
      const CageCoordinates coordinates(cage, coordinate_kind_named(kind), CoordinateOptions{});
      EXPECT_THROW(pose_reach(coordinates, 1, 1), InputError) << kind;
    }
  }
  const std::vector<std::string_view> of_quads = kinds_with_reach(3);
  EXPECT_EQ(std::ranges::count(of_quads, "quad_mean_value"), 1);
  EXPECT_EQ(std::ranges::count(of_quads, "quad_green"), 0);
}

}  // namespace
}  // namespace cageproof::deformation::sparse_weights_test
