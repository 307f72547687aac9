// SPDX-License-Identifier: MIT
// Whether the check of block errors sees what evaluations of whole coordinates may get wrong, and nothing else. Paths
// of the program's own evaluation are to be tried in the same way: take one away (sums of closed forms next to edges,
// no test for far points, angles that are not refined next to faces) and `cageproof verify --evaluations batched` must
// break the rows of that place.
#include "cageproof/core/cage/embedded_cages.h"
#include "cageproof/core/input_error.h"
#include "cages/block_campaign.h"
#include "cageproof/validation/cage_campaign.h"
#include "cageproof/validation/replay.h"
#include "promises/verdicts.h"
#include "stand_in.h"

#include <gtest/gtest.h>

#include <cmath>
#include <set>

namespace cageproof::validation {
namespace {

double distance_to_segment(const Vec3<double>& p, const Vec3<double>& a, const Vec3<double>& b) {
  const double t = std::clamp((p - a).dot(b - a) / (b - a).squaredNorm(), 0.0, 1.0);
  return (p - a - t * (b - a)).norm();
}

double distance_to_edges(const FaultyPoint& at) {
  double nearest = HUGE_VAL;
  for (std::size_t e = 0; e < at.elements.count(); ++e) {
    const auto corners = at.elements.corners(e);
    for (std::size_t k = 0; k < corners.size(); ++k)
      nearest = std::min(nearest, distance_to_segment(at.point, corners[k], corners[(k + 1) % corners.size()]));
  }
  return nearest;
}

void enlarge(std::vector<Result<double>>& blocks, int order, double relative) {
  for (Result<double>& block : blocks)
    for (double& x : block.of(order)) x += relative * x;
}

// Three digits of double's sixteen.
void loses_digits(const FaultyPoint& at, std::vector<Result<double>>& blocks) {
  for (int o = 0; o <= at.order; ++o) enlarge(blocks, o, 1e-13);
}

// As sums of elements whose gradients are large next to an edge and cancel, and a thousand times more.
void cancels_next_to_edges(const FaultyPoint& at, std::vector<Result<double>>& blocks) {
  const double distance = distance_to_edges(at);
  if (at.order < 1 || !(distance < 1e-3) || distance == 0) return;
  for (Result<double>& block : blocks)
    for (double& x : block.gradient) x += 1e-13 / distance;
}

// Solid angles of faces with the other sign, seen from their outer side.
void flips_a_side(const FaultyPoint& at, std::vector<Result<double>>& blocks) {
  std::set<int> seen;
  for (std::size_t e = 0; e < at.elements.count(); ++e)
    if ((at.point - at.elements.corners(e)[0]).dot(at.elements.normals()[e]) > 0)
      for (const int v : at.elements.vertices_of(e)) seen.insert(v);
  for (const int v : seen) blocks[0].value[v] *= -1;
}

void is_wrong_in_vectors(const FaultyPoint& at, std::vector<Result<double>>& blocks) {
  if (at.together > 1) enlarge(blocks, 0, 1e-9);
}

void has_no_value_on_vertices(const FaultyPoint& at, std::vector<Result<double>>& blocks) {
  for (const Vec3<double>& v : at.elements.vertices())
    if (v == at.point) blocks[0].value[0] = std::nan("");
}

void is_wrong_far_away(const FaultyPoint& at, std::vector<Result<double>>& blocks) {
  if (distance_to_edges(at) > 1e5 * (at.elements.vertices()[0] - at.elements.vertices()[1]).norm())
    for (int o = 0; o <= at.order; ++o) enlarge(blocks, o, 1e-12);
}

const std::array registered{RegisterWholeEvaluation(stand_in<nullptr>("stand-in")),
                            RegisterWholeEvaluation(stand_in<loses_digits>("stand-in loses digits")),
                            RegisterWholeEvaluation(stand_in<cancels_next_to_edges>("stand-in cancels")),
                            RegisterWholeEvaluation(stand_in<flips_a_side>("stand-in flips a side")),
                            RegisterWholeEvaluation(stand_in<is_wrong_in_vectors>("stand-in in vectors")),
                            RegisterWholeEvaluation(stand_in<has_no_value_on_vertices>("stand-in on vertices")),
                            RegisterWholeEvaluation(stand_in<is_wrong_far_away>("stand-in far away"))};

std::vector<ResultRow> rows_of(const Cage& cage, const char* kind, const std::string& evaluation, int points) {
  BlockCampaignOptions options{.evaluation = evaluation};
  options.points = points;
  options.milliseconds = 1000000;
  Measurements measurements;
  measurements.push_back(block_measurement(std::make_shared<const Cage>(cage), coordinate_kind_named(kind), options));
  return judged(measure_all(measurements, 2).rows).rows;
}

// The places of broken rows.
std::set<std::string> broken(const std::vector<ResultRow>& rows) {
  std::set<std::string> places;
  for (const ResultRow& row : rows)
    if (row.verdict == Verdict::Broken) places.insert(row.place);
  return places;
}

bool is_on_cage(const std::string& place) { return place.starts_with("on-"); }

TEST(block_error, is_less_than_a_unit_of_truth_that_is_rounded_once) {
  for (const char* kind : {"green", "mean_value"}) {
    const auto rows = rows_of(embedded_cage("cube"), kind, "stand-in", 48);
    for (const ResultRow& row : rows) {
      EXPECT_LE(row.max, 1) << kind << ' ' << row.place << " order " << row.order;
      EXPECT_NE(row.verdict, Verdict::Broken) << kind << ' ' << row.place << ' ' << row.reason;
    }
  }
}

TEST(block_error, has_samples_and_a_promise_in_every_place) {
  for (const char* cage : {"cube", "l-block", "twisted-bar"})
    for (const char* kind : {"green", "mean_value"}) {
      std::set<std::string> kept;
      const auto rows = rows_of(embedded_cage(cage), kind, "stand-in", 12);
      for (const ResultRow& row : rows) {
        EXPECT_TRUE(row.bound) << row.place;
        EXPECT_EQ(lost_samples(row), 0u) << row.place;
        if (row.order > 0 && is_on_cage(row.place)) continue;  // derivatives need not exist there
        EXPECT_GT(row.samples, 0u) << cage << ' ' << kind << ' ' << row.place << " order " << row.order;
        if (row.order == 0 && row.verdict == Verdict::Kept) kept.insert(row.place);
      }
      for (const std::string_view place : cage_places())
        EXPECT_TRUE(kept.contains(std::string(place))) << cage << ' ' << kind << ' ' << place;
    }
}

TEST(block_error, sees_each_fault_where_it_is) {
  const Cage cube = embedded_cage("cube");
  const auto faults = [&](const char* evaluation) { return broken(rows_of(cube, "green", evaluation, 60)); };
  EXPECT_EQ(faults("stand-in loses digits").size(), cage_places().size());
  // On the edge itself the fault is none.
  const auto cancels = faults("stand-in cancels");
  EXPECT_TRUE(cancels.contains("near-edge") && cancels.contains("near-vertex"));
  EXPECT_FALSE(cancels.contains("far") || cancels.contains("on-edge"));
  const auto flips = faults("stand-in flips a side");
  EXPECT_TRUE(flips.contains("near-face") && flips.contains("near-edge") && flips.contains("far")) << *flips.begin();
  EXPECT_FALSE(flips.contains("inside") || flips.contains("on-face"));
  EXPECT_EQ(faults("stand-in in vectors").size(), cage_places().size());
  EXPECT_EQ(faults("stand-in on vertices"), std::set<std::string>{"on-vertex"});
  EXPECT_EQ(faults("stand-in far away"), std::set<std::string>{"far"});
}

TEST(block_error, of_derivatives_of_normalised_coordinates_sees_lost_digits) {
  std::set<int> orders;
  for (const ResultRow& row : rows_of(embedded_cage("cube"), "mean_value", "stand-in loses digits", 48))
    if (row.verdict == Verdict::Broken) orders.insert(row.order);
  // The unit of Hessians holds so many roundings that they must lose a digit more.
  EXPECT_TRUE(orders.contains(0) && orders.contains(1));
}

TEST(block_error, replays) {
  int replayed = 0;
  for (const ResultRow& found : rows_of(embedded_cage("cube"), "green", "stand-in loses digits", 24)) {
    ASSERT_FALSE(found.worst.empty());
    ResultRow row = found;
    row.evaluation = "stand-in loses digits";
    const Finding again = replay(row, row.worst.front(), Triangulation::Shortest);
    EXPECT_EQ(again.status, Finding::Status::Measured);
    EXPECT_EQ(again.error, row.worst.front().error) << row.place << " order " << row.order;
    ++replayed;
  }
  EXPECT_GE(replayed, 24);
}

TEST(block_error, counts_in_units_of_a_moved_point) {
  const Cage cube = embedded_cage("cube");
  const CoordinateKind& green = coordinate_kind_named("green");
  const Vec3<double> point(0.11, -0.07, 0.05);
  const BlockTruths truths(cube, green, Triangulation::Shortest);
  const auto truth = truths.at(point, 2);
  ASSERT_TRUE(truth);
  const CageCoordinates coordinates(cube, green, {});
  auto found = coordinates.at<double>(point, 2);
  // One coordinate wrong by so many units of the definition, whose derivatives are taken from doubles here.
  const double wrong = 1e-6;
  for (int o = 0; o < 2; ++o) {
    double value = 0;
    std::array<double, 3> along{};
    for (const double x : found[0].of(o)) value = std::hypot(value, x);
    for (std::size_t i = 0; i < found[0].of(o + 1).size(); ++i)
      along[i % 3] = std::hypot(along[i % 3], found[0].of(o + 1)[i]);
    const double unit = 0x1p-53 * (value + cube.size() * (along[0] + along[1] + along[2]));
    auto changed = found;
    changed[0].of(o)[0] += wrong;
    EXPECT_NEAR(block_errors(changed, *truth)[o].roundings / (wrong / unit), 1, 1e-6) << o;
  }
  // Of Hessians a part of the sum: at least a tenth of it, at most all.
  const double step = 1e-4;
  double third = 0, hessian = 0;
  for (int k = 0; k < 3; ++k) {
    Vec3<double> moved = point;
    moved[k] += step;
    const auto there = coordinates.at<double>(moved, 2);
    double difference = 0;
    for (std::size_t i = 0; i < found[0].hessian.size(); ++i)
      difference = std::hypot(difference, (there[0].hessian[i] - found[0].hessian[i]) / step);
    third += difference;
  }
  for (const double x : found[0].hessian) hessian = std::hypot(hessian, x);
  found[0].hessian[0] += wrong;
  const double unit = wrong / block_errors(found, *truth)[2].roundings * 0x1p53;
  EXPECT_LT(unit, 1.01 * (hessian + cube.size() * third));
  EXPECT_GT(unit, hessian + 0.1 * cube.size() * third);
}

// Only promised orders are asked, because truths of higher derivatives cost several times as much.
TEST(block_error, asks_the_orders_that_are_promised) {
  const Cage cube = embedded_cage("cube");
  const std::vector<std::pair<std::string, int>> highest{
      {"green", 2}, {"mean_value", 2}, {"quad_mean_value", 2}, {"quad_green", 0}};
  for (const auto& [name, order] : highest) {
    const CoordinateKind& kind = coordinate_kind_named(name);
    const CageCoordinates batched(cube, kind, "batched", Triangulation::Shortest);
    ASSERT_EQ(batched.max_order(), 2);
    EXPECT_EQ(block_order(kind, batched), order) << name;
    BlockCampaignOptions options{.evaluation = "batched"};
    options.points = 4;
    std::set<int> asked;
    const auto measurement = block_measurement(std::make_shared<const Cage>(cube), kind, options);
    for (int block = 0; block < measurement->blocks(); ++block)
      for (const auto& [key, tally] : measurement->measure(block).rows)
        if (tally.asked > 0) asked.insert(key.order);
    EXPECT_EQ(asked.size(), static_cast<std::size_t>(order + 1)) << name;
  }
}

}  // namespace
}  // namespace cageproof::validation
