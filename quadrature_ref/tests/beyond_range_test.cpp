// SPDX-License-Identifier: MIT
// Entries within range beside such as leave it: the norm of all of them says nothing of these.
#include "rules/beyond_range.h"
#include "support.h"

namespace cageproof::quadrature_ref {
namespace {

struct Case {
  std::string formula;
  std::vector<Vec3<double>> corners;
  Vec3<double> point;
  int order = 2;
  std::vector<double> parameters = {};
};

template <Scalar R>
Result<R> found_by(const std::string& evaluation, const Case& c) {
  std::vector<Vec3<R>> corners;
  corners.reserve(c.corners.size());
  for (const Vec3<double>& corner : c.corners) corners.push_back(convert<R>(corner));
  const std::vector<R> parameters(c.parameters.begin(), c.parameters.end());
  Result<R> result;
  (*EvaluationRegister::instance().find(c.formula, evaluation))(
      Query<R>{corners, convert<R>(c.point), c.order, parameters}, result);
  return result;
}

// Above an edge or a side, at a billionth of its length and less: derivatives across it leave the range.
std::vector<Case> cases(double unit, double distance) {
  const auto at = [&](double x, double y, double z) { return Vec3<double>(x * unit, y * unit, z * unit); };
  const std::vector<Vec3<double>> segment{at(0, 0, 0), at(3, 1, 0)}, triangle{at(0, 0, 0), at(3, 1, 0), at(1, 2, 1)},
      quad{at(0, 0, 0), at(2, 0, 0), at(2, 2, .5), at(0, 2, 0)};
  const Vec3<double> above = Vec3<double>(0, 0, distance), at_end = Vec3<double>(distance, -2 * distance, 0);
  return {{"segment.kelvin_traction", segment, at_end, 2, {1, .25}},
          {"triangle.double_layer", triangle, above},
          {"quad.solid_angle", quad, at(1, 0, 0) + above, 1}};
}

// Stated digits hold for the entries within range; entries beyond it are infinite with their sign.
template <Scalar R>
void expect_entries(const std::string& evaluation, const Case& c, const Result<Mp50>& truth) {
  int beside = 0;
  const auto found = found_by<R>(evaluation, c);
  EXPECT_GT(found.stated_digits, 3) << c.formula << ' ' << evaluation;
  for (int o = 0; o <= c.order; ++o) {
    Mp50 error = 0, size = 0;
    int beyond = 0, within = 0;
    for (std::size_t i = 0; i < truth.of(o).size(); ++i) {
      const Mp50& expected = truth.of(o)[i];
      const R entry = found.of(o)[i];
      if (abs(expected) > std::numeric_limits<R>::max()) {
        ++beyond;
        EXPECT_EQ(entry, std::copysign(std::numeric_limits<R>::infinity(), expected > 0 ? R(1) : R(-1)))
            << c.formula << ' ' << evaluation << " order " << o << " entry " << i;
      } else {
        ++within;
        ASSERT_TRUE(std::isfinite(entry)) << c.formula << ' ' << evaluation << " order " << o << " entry " << i;
        error += (expected - entry) * (expected - entry);
        size += expected * expected;
      }
    }
    beside += beyond > 0 && within > 0;
    if (size == 0) continue;
    // A result is rounded after the multiprecision evaluation stated its digits.
    const double rounding = 4 * static_cast<double>(unit_roundoff<R>());
    EXPECT_LE(static_cast<double>(Mp50(sqrt(Mp50(error / size)))), std::pow(10, -found.stated_digits) + rounding)
        << c.formula << ' ' << evaluation << " order " << o;
  }
  EXPECT_GT(beside, 0) << c.formula << ": a case that does not try it";
}

template <Scalar R>
void expect_both(const Case& c) {
  const auto truth = found_by<Mp50>("multiprecision", c);
  ASSERT_TRUE(truth.converged) << c.formula;
  for (const char* evaluation : {"adaptive", "multiprecision"}) expect_entries<R>(evaluation, c, truth);
}

TEST(BeyondRange, entries_within_it_keep_what_is_stated) {
  for (const Case& c : cases(0x1p-990, 0x1p-1034)) expect_both<double>(c);
  for (const Case& c : cases(0x1p-110, 0x1p-140))
    if (c.corners.size() < 4) expect_both<float>(c);  // a quad takes seconds
}

// Entries of 1, 1e-5 and 1e-12, of which the first leaves the range.
TEST(BeyondRange, digits_left) {
  const double infinity = std::numeric_limits<double>::infinity();
  const std::vector<double> sums{1, 1e-5, 1e-12};
  const EntrySpread none = entry_spread(sums, sums);
  EXPECT_FALSE(none.leaves_range());
  EXPECT_EQ(none.digits_left(.5), .5);
  EXPECT_EQ(none.digits_for(11), 11);
  const EntrySpread one = entry_spread(sums, std::vector<double>{infinity, 1e-5, 1e-12});
  EXPECT_NEAR(one.digits_left(11), 6, 1e-6);
  EXPECT_NEAR(one.digits_for(11), 16, 1e-6);
  // The second one's sign takes five digits.
  const EntrySpread two = entry_spread(sums, std::vector<double>{infinity, infinity, 1e-12});
  EXPECT_EQ(two.digits_left(5.5), 0);
  EXPECT_NEAR(two.digits_left(16), 4, 1e-6);
  EXPECT_NEAR(two.digits_for(3), 15, 1e-6);
  const EntrySpread all = entry_spread(sums, std::vector<double>{infinity, infinity, infinity});
  EXPECT_EQ(all.digits_left(11), 0);
  EXPECT_EQ(all.digits_left(14), 14);
  // Sums that left the range say nothing.
  EXPECT_EQ(entry_spread(std::vector<double>{infinity, 1}, std::vector<double>{infinity, 1}).digits_left(15), 0);
}

}  // namespace
}  // namespace cageproof::quadrature_ref
