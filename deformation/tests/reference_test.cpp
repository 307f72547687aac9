// SPDX-License-Identifier: MIT
// The first points' images of the specification's reference cases, computed elsewhere by other means, and to 32 digits
// and more.
#include "support.h"

#include <gtest/gtest.h>

namespace cageproof::deformation::test::reference_test {
namespace {

struct Reference {
  const char* method;
  std::vector<double> parameters;
  Vec image;
  double tolerance = 1e-11;
};

constexpr double kUnit = 3, kHard = 0, kFree = 2, kLocal = 1;

void expect_all(const Case& c, const std::vector<Reference>& references, int dimension = 3) {
  for (const Reference& r : references) {
    const Images<double> found = deformed(*prepared(c.cage, r.method, r.parameters), c.posed, c.points);
    EXPECT_LT((image(found, 0, dimension) - r.image).norm(), r.tolerance * c.size)
        << c.name << ", " << r.method << ": " << image(found, 0, dimension).transpose();
  }
}

TEST(reference, cube) {
  expect_all(cube(), {{"green", {0}, {0.182381463008, 0.188880038661, -0.124546472243}},
                      {"biharmonic_1_3", {}, {0.148010229594, 0.165534670087, -0.0287427066237}},
                      {"biharmonic_1_3", {1, kUnit, 100, 0}, {0.145357495311, 0.163144780027, -0.0254211604696}},
                      {"biharmonic_1_2", {}, {0.145393018507, 0.160060157005, -0.0460232789478}},
                      {"biharmonic_weber", {}, {0.15948757543, 0.183543528909, -0.0074563194841}},
                      {"aaap", {1, 1, kHard, 1, 1}, {0.167975431618, 0.182677152882, -0.0333409278251}},
                      {"aaap", {1, 1, kFree, 1, 1}, {0.1586648656, 0.180966180407, -0.0591409519931}},
                      {"tp", {1, 1, kHard, 1, 1}, {0.171105333342, 0.183410809827, -0.0343927242445}},
                      {"tp", {1, 1, kFree, 1, 1}, {0.155335189758, 0.176289258756, -0.0620304690894}},
                      {"ahap", {1, 1, kHard, 1, 1}, {0.327146616073, -0.0421471541659, 0.0809253793656}, 1e-9},
                      {"ahap", {1, 1, kFree, 1, 1}, {0.152552227987, 0.170409147441, -0.0639491193774}},
                      {"somigliana", {0, 0.3, 1, 0, 0.5}, {0.148626548083, 0.194585004894, -0.0620376794946}},
                      {"somigliana", {kLocal, 0.3, 1, 0, 0.5}, {0.204436277099, 0.221342867555, -0.244517791121}}});
}

TEST(reference, bar) {
  expect_all(bar(), {{"green", {0}, {0.199046235045, -0.0176763700737, 0.295415823247}},
                     {"biharmonic_1_3", {}, {0.206888788874, -0.0190241395481, 0.307422637079}},
                     {"biharmonic_1_3", {1, kUnit, 100, 0}, {0.211469657048, -0.0164044883271, 0.300623691445}},
                     {"biharmonic_1_2", {}, {0.222435958514, -0.0205607553207, 0.319346116946}},
                     {"biharmonic_weber", {}, {0.213924646242, -0.0187943558548, 0.300596233374}},
                     {"somigliana", {0, 0.3, 1, 0, 0.5}, {0.210716978884, -0.0203343991531, 0.279430688468}},
                     {"somigliana", {kLocal, 0.3, 1, 0, 0.5}, {0.191459179493, 0.000441563165946, 0.275120272947}}});
}

TEST(shared_data, spiky_box) {
  const auto c = spiky_box();
  if (!c) GTEST_SKIP() << "the data are not next to the project";
  expect_all(*c, {{"green", {0}, {0.66831336201, -0.423548257204, 0.872861867237}},
                  {"biharmonic_1_3", {}, {0.665848906828, -0.961407183332, 0.906788420324}},
                  {"biharmonic_1_2", {}, {0.740167512354, -0.898344176285, 0.930053195039}},
                  {"biharmonic_weber", {}, {0.664347179561, -0.961666462086, 0.886809990199}},
                  {"aaap", {1, 1, kHard, 1, 1}, {0.685857236112, -0.906320964314, 0.949477173072}},
                  {"aaap", {1, 1, kFree, 1, 1}, {0.72007890039, -0.799747, 0.868272279761}, 1e-9},
                  {"somigliana", {0, 0.3, 1, 0, 0.5}, {0.64986615018, -0.837571135203, 1.11302646091}},
                  {"somigliana", {kLocal, 0.3, 1, 0, 0.5}, {1.02469779443, 1.27437549133, 0.529233445354}}});
}

TEST(shared_data, fire_hydrant) {
  const auto c = real("FireHydrant", {0});
  if (!c) GTEST_SKIP() << "the data are not next to the project";
  expect_all(*c, {{"green", {0}, {-0.469386674968, 0.74408627766, -0.784463394111}},
                  {"biharmonic_1_3", {}, {-0.494873672829, 0.398526760064, -0.869178352938}},
                  {"tp", {1, 1, kHard, 1, 1}, {-0.478942712226, 0.351116624017, -0.862703971792}},
                  {"tp", {1, 1, kFree, 1, 1}, {-0.493709940093, 0.471504856794, -0.860864}, 1e-9},
                  {"somigliana", {0, 0.3, 1, 0, 0.5}, {-0.436647766054, 0.366383925265, -0.923851220947}},
                  {"somigliana", {kLocal, 0.3, 1, 0, 0.5}, {-0.412353632872, 0.956386744686, -1.20299373598}}});
}

TEST(reference, plane) {
  expect_all(square(),
             {{"green", {0}, {0.302034288952, 0.653140794501, 0}},
              {"somigliana", {0, 0.3, 2, 0, 0.5}, {0.31236927984, 0.659899858974, 0}},
              {"somigliana", {kLocal, 0.3, 2, 0, 0.5}, {0.331715073536, 0.620265643992, 0}}},
             2);
  expect_all(l_shape(),
             {{"green", {0}, {0.538851627597, 0.491162920356, 0}},
              {"somigliana", {0, 0.3, 2, 0, 0.5}, {0.573099665262, 0.501304999712, 0}},
              {"somigliana", {kLocal, 0.3, 2, 0, 0.5}, {0.497154440501, 0.353133953814, 0}}},
             2);
  expect_all(pentagon(),
             {{"green", {0}, {0.994721551195, 0.98566148525, 0}},
              {"somigliana", {0, 0.3, 2, 0, 0.5}, {1.02780275275, 0.996982793131, 0}},
              {"somigliana", {kLocal, 0.3, 2, 0, 0.5}, {0.968101310331, 0.96729768628, 0}}},
             2);
}

// The numbers that the specification prints to twelve digits, in 50 digits.
TEST(reference, cube_in_50_digits) {
  const Case c = cube();
  const auto deformer = prepare_deformer<Mp50>(deform_method_named("biharmonic_1_3"), c.cage, {});
  std::vector<Vec3<Mp50>> posed, points;
  // The pose as decimals say it, not as doubles round it.
  for (const Vec& v : c.cage.vertices()) posed.push_back(convert<Mp50>(v));
  const auto move = [&](int v, const char* x, const char* y, const char* z) {
    posed[v] += Vec3<Mp50>(Mp50(x), Mp50(y), Mp50(z));
  };
  move(7, "0.3", "0.2", "0.4");
  move(0, "-0.1", "0", "-0.2");
  move(3, "0", "-0.3", "0.1");
  points.emplace_back(Mp50("0.1"), Mp50("0.2"), Mp50("-0.15"));
  const Images<Mp50> found = deformed<Mp50>(*deformer, posed, points);
  EXPECT_NEAR(static_cast<double>(found.tensors[0][0]), 0.148010229594, 6e-13);
  EXPECT_NEAR(static_cast<double>(found.tensors[0][1]), 0.165534670087, 6e-13);
  EXPECT_NEAR(static_cast<double>(found.tensors[0][2]), -0.0287427066237, 6e-14);
}

}  // namespace
}  // namespace cageproof::deformation::test::reference_test
