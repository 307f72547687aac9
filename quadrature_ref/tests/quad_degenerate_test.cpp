// SPDX-License-Identifier: MIT
// The integral over quads above corners where their parameters do not cover the surface one to one: doubled, straight
// and reflex ones. The rules that agree there must be right, and those that would take long must say so.
#include "support.h"

namespace cageproof::quadrature_ref {
namespace {

using Vec = Vec3<double>;

// From the definition in 100 digits by mpmath, not by this project's code: along v = const by antiderivatives (atan2
// and rational terms), across by Gauss-Legendre with 24 points on panels halved until halves agree to 36 digits.
struct Case {
  const char* name;
  std::array<Vec, 4> corners;
  Vec point;
  std::array<const char*, 4> value;
};

const std::vector<Case>& cases() {
  static const std::vector<Case> all{
      {"doubled",
       {{Vec(1, 0, 0), Vec(0, 1, 0), Vec(0, 0, 0), Vec(0, 0, 0)}},
       {0, 0, 0x1p-27},
       {"-0.785398153820485694085108659674462303", "-0.785398153820485694085108659674462303",
        "-52707177.7478909779480602741218664057", "-52707177.7478909779480602741218664057"}},
      {"close above a reflex corner",
       {{Vec(0, 0, 0), Vec(2, -1, 0), Vec(0, 1, 0), Vec(-2, -1, 0)}},
       {0, 0, 0x1p-30},
       {"813985279.375135596913121506929435769", "-749613205.104297349212892872584133059",
        "-1499226411.6135576423666784297572485", "-749613205.104297349212892872584133059"}},
      {"straight",
       {{Vec(-1, 0, 0), Vec(0, 0, 0), Vec(1, 0, 0), Vec(0, 1, 0)}},
       {0, 0, 0x1p-20},
       {"-1361.16829442930861914401643185526156", "-1644375.42178010010527219636941291652",
        "-1361.16829442930861914401643185526156", "-1.57079387509246704592873924441873886"}},
      {"beside a reflex corner",
       {{Vec(2, 2, 0), Vec(-1, 1, 0), Vec(0, 0, 0), Vec(1, -1, 0)}},
       {0x1p-51, 0, 0x1p-45},
       {"-0.561530185893740867327465664161846275", "-4750653.21567027959124671219091022124",
        "-55878060851642.703662813398768954587", "-4750653.22807770364674053505646538154"}},
      {"above a reflex corner",
       {{Vec(0, 0, 0), Vec(2, -1, 0), Vec(0, 1, 0), Vec(-2, -1, 0)}},
       {0, 0, 0x1p-10},
       {"774.860681448101627403061253907712383", "-714.181479533312226563215356987243093",
        "-1429.76554462884116077889081253980099", "-714.181479533312226563215356987243093"}},
  };
  return all;
}

Result<Mp50> integral(const Case& c, int order) {
  std::vector<Vec3<Mp50>> q;
  q.reserve(c.corners.size());
  for (const Vec& corner : c.corners) q.push_back(convert<Mp50>(corner));
  Result<Mp50> result;
  const auto evaluation = EvaluationRegister::instance().find("quad.mean_value", "multiprecision");
  (*evaluation)(Query<Mp50>{q, convert<Mp50>(c.point), order}, result);
  return result;
}

double log10_error(const Case& c, const Result<Mp50>& found) {
  Mp50 error = 0, size = 0;
  for (int k = 0; k < 4; ++k) {
    const Mp50 exact(c.value[k]);
    error += (found.value[k] - exact) * (found.value[k] - exact);
    size += exact * exact;
  }
  return error == 0 ? -50 : static_cast<double>(Mp50(log10(Mp50(error / size)) / 2));
}

TEST(Quad, multiprecision_keeps_its_word_and_ends_above_degenerate_corners) {
  for (const Case& c : cases())
    for (const int order : {0, 2}) {
      const Result<Mp50> found = integral(c, order);
      // Each point costs some microseconds in 50 digits, and three times that with derivatives: it ends in time.
      EXPECT_LT(found.nodes * (1 + order), 3600000) << c.name << ' ' << order;
      if (found.stated_digits == 0) {
        EXPECT_FALSE(found.converged) << c.name;
        continue;
      }
      // The truths have 34 digits.
      EXPECT_LT(log10_error(c, found), -std::min(found.stated_digits, 34.0)) << c.name << ' ' << order;
      EXPECT_EQ(found.converged, found.stated_digits >= 30) << c.name;
    }
}

// A doubled corner asks for many cells, not for too many.
TEST(Quad, multiprecision_resolves_a_doubled_corner) { EXPECT_TRUE(integral(cases()[0], 0).converged); }

}  // namespace
}  // namespace cageproof::quadrature_ref
