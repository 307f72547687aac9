// SPDX-License-Identifier: MIT
// Checks of products with derivatives by the cage's vertices: all that have them are asked, and wrong ones are found.
#include "cages/rest_products.h"
#include "deformers/deformer_campaign.h"
#include "deformers/pose_products.h"
#include "promises/verdicts.h"

#include "cageproof/core/cage/embedded_cages.h"
#include "cageproof/validation/cage_campaign.h"
#include "cageproof/validation/replay.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace cageproof::validation::vertex_derivatives_test {
namespace {

using namespace deformation;
using Numbers = std::vector<double>;

// A mistake of a derivative.
struct Fault {
  double along = 0;      // the change is so much longer
  double back = 0;       // the first vertex's share is so much larger
  bool missing = false;  // whether there is no derivative at all
};

class WrongDerivative final : public PoseDerivative<double> {
 public:
  WrongDerivative(std::unique_ptr<const PoseDerivative<double>> right, const Fault& fault)
      : right_(std::move(right)), fault_(fault) {}
  std::unique_ptr<const Posed<double>> along(const std::vector<Vec3<double>>& change) const override {
    std::vector<Vec3<double>> other = change;
    other.front() *= 1 + fault_.along;
    return right_->along(other);
  }
  std::vector<Matrix<double>> nothing() const override { return right_->nothing(); }
  void gather(std::span<const CoordinateTable<double>> coordinates, std::size_t points, std::span<const double> weights,
              std::vector<Matrix<double>>& gathered) const override {
    right_->gather(coordinates, points, weights, gathered);
  }
  std::vector<Vec3<double>> back(const std::vector<Matrix<double>>& gathered) const override {
    auto found = right_->back(gathered);
    found.front() *= 1 + fault_.back;
    return found;
  }

 private:
  std::unique_ptr<const PoseDerivative<double>> right_;
  Fault fault_;
};

class WrongDeformer final : public Deformer<double> {
 public:
  WrongDeformer(std::shared_ptr<const Deformer<double>> right, const Fault& fault)
      : right_(std::move(right)), fault_(fault) {}
  const CageCoordinates& coordinates() const override { return right_->coordinates(); }
  std::unique_ptr<const Posed<double>> pose(const Pose<double>& pose) const override { return right_->pose(pose); }
  std::unique_ptr<const PoseDerivative<double>> derivative(const Pose<double>& pose) const override {
    if (fault_.missing) return nullptr;
    return std::make_unique<const WrongDerivative>(right_->derivative(pose), fault_);
  }

 private:
  std::shared_ptr<const Deformer<double>> right_;
  Fault fault_;
};

PoseProducts products_with(const std::shared_ptr<const Cage>& cage, const DeformMethod& method, const Fault& fault) {
  return {cage, method,
          [cage, &method, fault] {
            return std::make_shared<const WrongDeformer>(prepare_deformer<double>(method, *cage, {}), fault);
          },
          [cage, &method] { return prepare_deformer<Mp50>(method, *cage, {}); }};
}

TEST(vertex_derivatives, of_wrong_pose_derivatives_break_promises) {
  for (const auto& [name, point] : {std::pair{"cube", Vec3<double>(.1, .2, -.15)}, {"square", {.3, .6, 0}}})
    for (const char* method : {"green", "mean_value", "biharmonic_1_3"}) {
      const auto cage = std::make_shared<const Cage>(embedded_cage(name));
      const DeformMethod& of = deform_method_named(method);
      const auto with = [&](const Fault& fault) { return products_with(cage, of, fault); };
      EXPECT_TRUE(with({}).exist());
      EXPECT_LT(with({}).error_of_jvp<Mp50>(point), 1e-14) << name << ' ' << method;
      EXPECT_LT(with({}).error_of_jvp<double>(point), 1e-10) << name << ' ' << method;
      EXPECT_LT(with({}).roundings_of_adjoint(point), 64) << name << ' ' << method;
      EXPECT_GT(with({.along = 1e-10}).error_of_jvp<Mp50>(point), 1e-13) << name << ' ' << method;
      EXPECT_GT(with({.along = 1e-6}).error_of_jvp<double>(point), 1e-9) << name << ' ' << method;
      EXPECT_GT(with({.along = 1e-10}).roundings_of_adjoint(point), 1024) << name << ' ' << method;
      EXPECT_GT(with({.back = 1e-10}).roundings_of_adjoint(point), 1024) << name << ' ' << method;
      const double nan = std::nan("");
      EXPECT_TRUE(std::isnan(with({.along = nan}).error_of_jvp<Mp50>(point)));
      EXPECT_TRUE(std::isnan(with({.back = nan}).roundings_of_adjoint(point)));
      EXPECT_FALSE(with({.missing = true}).exist());
      EXPECT_TRUE(std::isnan(with({.missing = true}).error_of_jvp<Mp50>(point)));
    }
}

// Where nothing is asked, nothing is kept; and worst cases are found again, to the bit.
TEST(vertex_derivatives, of_all_pose_derivatives_are_asked) {
  for (const char* name : {"square", "cube"}) {
    const Cage cage = embedded_cage(name);
    // Methods on quads take one second each.
    const auto rows =
        run_deformer_campaign(cage, {.methods = cage.dimension() == 2 ? "*" : "green,mean_value,biharmonic_direct,aaap",
                                     .points = 1,
                                     .few_points = 1});
    for (const ResultRow& row : rows) {
      if (!row.check.starts_with("pose_derivative")) continue;
      EXPECT_EQ(row.verdict, Verdict::Kept) << name << ' ' << row.subject << ' ' << row.check << ' ' << row.max;
      if (cage.dimension() == 3 && row.subject != "green") continue;
      ASSERT_FALSE(row.worst.empty());
      EXPECT_EQ(replay(row, row.worst.front(), Triangulation::Shortest).error, row.max) << row.subject << row.check;
    }
    const auto count = [&](std::string_view method, std::string_view variant, std::string_view check) {
      return std::ranges::count_if(rows, [&](const ResultRow& row) {
        return row.subject == method && row.evaluation == variant && row.check == check && lost_samples(row) == 0;
      });
    };
    for (const DeformMethod& method : deform_methods()) {
      const bool asked = std::ranges::any_of(rows, [&](const ResultRow& row) { return row.subject == method.name; });
      for (const DeformerVariant& variant : variants_of(method)) {
        if (!asked) continue;
        const bool has = method.has_pose_derivative && variant.name != "normals=ahap";
        EXPECT_EQ(count(method.name, variant.name, "pose_derivative") +
                      count(method.name, variant.name, "pose_derivative_in_double"),
                  has)
            << name << ' ' << method.name << ' ' << variant.name;
        EXPECT_EQ(count(method.name, variant.name, "pose_derivative_transposed"), has)
            << name << ' ' << method.name << ' ' << variant.name;
      }
    }
  }
}

TEST(vertex_derivatives, of_green_by_the_rest_cage_are_asked) {
  for (const char* name : {"square", "cube"}) {
    const auto rows = run_cage_campaign(embedded_cage(name), {.kinds = "green", .points = 12});
    for (const char* check : {"rest_derivative", "rest_derivative_transposed"}) {
      std::size_t asked = 0;
      for (const ResultRow& row : rows) {
        if (row.check != check) continue;
        ++asked;
        EXPECT_EQ(row.verdict, Verdict::Kept) << name << ' ' << check << ' ' << row.max;
        ASSERT_FALSE(row.worst.empty());
        EXPECT_EQ(replay(row, row.worst.front(), Triangulation::Shortest).error, row.max) << name << ' ' << check;
      }
      EXPECT_EQ(asked, 2U) << name << ' ' << check << ": inside and outside";
    }
  }
}

double wrong_by = 0;  // of what the stand-ins give

void wrong_jvp(const CageCoordinates& coordinates, std::span<const Vec3<double>> points,
               std::span<const Vec3<double>> change, int threads, std::span<double> values) {
  rest_derivative_of(coordinates.kind()).jvp(coordinates, points, change, threads, values);
  values.back() *= 1 + wrong_by;
}

std::vector<Vec3<double>> wrong_vjp(const CageCoordinates& coordinates, std::span<const Vec3<double>> points,
                                    std::span<const double> weights, int threads) {
  auto found = rest_derivative_of(coordinates.kind()).vjp(coordinates, points, weights, threads);
  found.front() *= 1 + wrong_by;
  return found;
}

TEST(vertex_derivatives, of_wrong_rest_derivatives_break_promises) {
  const RestDerivative right = rest_derivative_of(coordinate_kind_named("green"));
  for (const auto& [name, point] : {std::pair{"cube", Vec3<double>(.1, .2, -.15)}, {"square", {.3, .6, 0}}}) {
    const Cage cage = embedded_cage(name);
    const CageCoordinates coordinates(cage, coordinate_kind_named("green"), "", Triangulation::Shortest);
    ASSERT_TRUE(RestProducts::exist(coordinates));
    const RestProducts kept(coordinates, cage, right);
    EXPECT_LT(kept.error_of_jvp(point).roundings, 64) << name;
    EXPECT_LT(kept.error_of_transposed(point).roundings, 64) << name;
    RestDerivative forward = right, back = right;
    forward.jvp = wrong_jvp;
    back.vjp = wrong_vjp;
    const RestProducts of_jvp(coordinates, cage, forward), of_vjp(coordinates, cage, back);
    wrong_by = 1e-8;
    EXPECT_GT(of_jvp.error_of_jvp(point).roundings, 1024) << name;
    EXPECT_GT(of_jvp.error_of_transposed(point).roundings, 1024) << name;
    EXPECT_GT(of_vjp.error_of_transposed(point).roundings, 1024) << name;
    wrong_by = std::nan("");
    EXPECT_TRUE(std::isnan(of_vjp.error_of_transposed(point).roundings)) << name;
    EXPECT_TRUE(std::isnan(of_jvp.error_of_jvp(point).roundings)) << name;
  }
  const Cage cube = embedded_cage("cube");
  EXPECT_FALSE(RestProducts::exist({cube, coordinate_kind_named("mean_value"), "", Triangulation::Shortest}));
}

}  // namespace
}  // namespace cageproof::validation::vertex_derivatives_test
