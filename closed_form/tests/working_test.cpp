// SPDX-License-Identifier: MIT
// Fifty digits are computed in more: they must all be there, also where fifty would cancel, and parameters must arrive.
#include "cageproof/core/catalogue/evaluation.h"

#include <gtest/gtest.h>

namespace cageproof::closed_form::working_test {
namespace {

const std::array<Vec3<double>, 3> kCorners{Vec3<double>(0, 0, 0), Vec3<double>(1, 0, 0), Vec3<double>(0, 1, 0)};
// mu and nu, no decimal fractions of them exact.
const std::array<double, 2> kParameters{0.7, 0.3};

template <Scalar R>
Result<R> evaluated(const Formula& formula, const std::string& evaluation, const Vec3<double>& point, int order) {
  std::vector<Vec3<R>> corners;
  corners.reserve(kCorners.size());
  for (const auto& corner : kCorners) corners.push_back(convert<R>(corner));
  const std::vector<R> parameters(kParameters.begin(),
                                  kParameters.begin() + static_cast<std::ptrdiff_t>(formula.parameters.size()));
  Result<R> result;
  result.reset(formula.components(), 3, order);
  evaluation_named(formula.name, evaluation)(Query<R>{corners, convert<R>(point), order, parameters}, result);
  return result;
}

TEST(Working, fifty_digits_are_all_there_where_fifty_would_cancel) {
  int seen = 0;
  for (const Formula& formula : catalogue()) {
    if (formula.element != ElementKind::Triangle) continue;
    for (const EvaluationFamily* family : EvaluationRegister::instance().families(formula.name)) {
      if (family->role != Role::ClosedForm && family->pattern != "published") continue;
      const int order = std::min(1, family->example().max_order());
      // Generic, 1e4 sizes away, and 1e-12 above the face.
      for (const Vec3<double>& point : {Vec3<double>(0.3, -0.4, 0.7), {3000, 4000, 12000}, {0.25, 0.3, 1e-12}}) {
        const auto narrow = evaluated<Mp50>(formula, family->pattern, point, order);
        const auto wide = evaluated<Mp200>(formula, family->pattern, point, order);
        for (int o = 0; o <= order; ++o) {
          Mp200 error = 0, size = 0;
          for (std::size_t i = 0; i < wide.of(o).size(); ++i) {
            error = std::max(error, Mp200(abs(Mp200(narrow.of(o)[i]) - wide.of(o)[i])));
            size = std::max(size, Mp200(abs(wide.of(o)[i])));
          }
          EXPECT_LE(error, size * Mp200("1e-49")) << formula.name << ' ' << family->pattern << ' ' << o;
          EXPECT_GT(size, 0) << formula.name;
          ++seen;
        }
      }
    }
  }
  EXPECT_GE(seen, 60);
}

}  // namespace
}  // namespace cageproof::closed_form::working_test
