// SPDX-License-Identifier: MIT
// The rules against each other, and against numbers from elsewhere.
#include "support.h"

#include "cageproof/core/numbers/scalar_text.h"

namespace cageproof::quadrature_ref {
namespace {

// Polar cells and the unsplit collapsed square share nothing but the kernel.
TEST(Agreement, polar_cells_with_the_collapsed_square) {
  const Sample sample{"", {Vec3<double>(0, 0, 0), Vec3<double>(2, 0, .5), Vec3<double>(.5, 2, 0)}, {.7, .6, 1.9}};
  for (const std::string& formula : kFormulas) {
    const auto square = evaluate<Mp50>(formula, "gauss-72", sample, 2);
    const auto polar = evaluate<Mp50>(formula, "near-singular-48", sample, 2);
    for (int order = 0; order <= 2; ++order)
      EXPECT_LT(log10_error(polar.of(order), square.of(order)), -32) << formula << ' ' << order;
  }
}

TEST(Agreement, three_quads_with_the_collapsed_square) {
  const Sample sample{"", {Vec3<double>(0, 0, 0), Vec3<double>(2, 0, .5), Vec3<double>(.5, 2, 0)}, {1, 1, -4}};
  for (const std::string& formula : kFormulas) {
    const auto square = evaluate<double>(formula, "gauss-32", sample, 2);
    const auto quads = evaluate<double>(formula, "three-quad-1200", sample, 2);
    for (int order = 0; order <= 2; ++order)
      EXPECT_LT(log10_error(quads.of(order), square.of(order)), -14) << formula << ' ' << order;
  }
}

TEST(Agreement, near_singular_with_multiprecision) {
  for (const Sample& sample : regime_samples(3))
    for (const std::string formula : {"triangle.single_layer", "triangle.mean_value"}) {
      const auto fast = evaluate<double>(formula, "near-singular-16", sample, 1);
      const auto truth = evaluate<double>(formula, "multiprecision", sample, 1);
      for (int order = 0; order <= 1; ++order)
        EXPECT_LT(log10_error(fast.of(order), truth.of(order)), -13) << formula << ' ' << sample.regime << ' ' << order;
    }
}

struct Stored {
  const char* formula;
  int corner;
  std::array<const char*, 3> entries;  // value, d/dy, d2/dxdz
};

void expect_stored(const Sample& sample, const std::vector<Stored>& rows) {
  for (const Stored& row : rows) {
    const auto result = evaluate<Mp50>(row.formula, "multiprecision", sample, 2);
    EXPECT_TRUE(result.converged);
    const std::array<int, 3> entry{row.corner, 3 * row.corner + 1, 9 * row.corner + 2};
    for (int order = 0; order <= 2; ++order) {
      Mp50 norm = 0;
      for (const Mp50& x : result.of(order)) norm += abs(x);
      const Mp50 error = abs(Mp50(result.of(order)[entry[order]] - *parse_scalar<Mp50>(row.entries[order])));
      EXPECT_LT(log10_of(Mp50(error / norm)), -30) << row.formula << ' ' << order;
    }
  }
}

// 40 digits from an independent program in mpmath: moments of r^k over signed triangles about the projection of eta,
// Gauss panels in asinh of both polar variables, 60 digits of working precision; mean_value by 130 x 130 Gauss points.
const Triangle<double> kStored{Vec3<double>(0, 0, 0), Vec3<double>(4, 0, 0), Vec3<double>(1, 3, 0)};

TEST(Agreement, stored_generic) {
  expect_stored({"generic", kStored, {2, 1, -1.25}},
                {{"triangle.single_layer",
                  0,
                  {"0.2934051532107039649201085512186256536878", "-0.002613614596004093557363434257251229336208",
                   "-0.02780541682994131333804566889988200355113"}},
                 {"triangle.double_layer",
                  1,
                  {"0.05522975750704151103120042954579285061292", "-0.01043989243774101479644048726583619785036",
                   "0.01595926997017854284717730505118346228529"}},
                 {"triangle.solid_angle",
                  0,
                  {"1.885894279262361561166602479445408648532", "-0.0681781800920551237017833783052950772058",
                   "-0.4255789615256715633748484125902155448679"}},
                 {"triangle.biharmonic_single_layer",
                  0,
                  {"0.4000984857060548945110720260793784920521", "0.001355100479229454078081803741038486887789",
                   "0.01514723664897288256633876906045027840649"}},
                 {"triangle.biharmonic_double_layer",
                  1,
                  {"-0.06345620056390098658757121355706301593873", "0.004766476513284626056170755729665810078279",
                   "-0.002378810798932476398707045395976796801612"}},
                 {"triangle.mean_value",
                  1,
                  {"0.4709469793766131472808913496316230536778", "-0.1081345289804692806875188650986725618124",
                   "0.2305822226766234449149634599047359555946"}}});
}

TEST(Agreement, stored_near_edge) {
  expect_stored({"near-edge", kStored, {1.5, -0x1p-20, 0x1p-20}},
                {{"triangle.single_layer",
                  0,
                  {"0.478872996040034828207036713339434379845", "2.20977855485297231466734712241761664079",
                   "-0.0000000165490169038495743209293876159261474491"}},
                 {"triangle.double_layer",
                  1,
                  {"-0.04687478970569818945791498815807110660195", "-31291.12463473759013066641428897056944884",
                   "-20860.70777879070801780316470732570323872"}},
                 {"triangle.solid_angle",
                  0,
                  {"-1.570794702113965063833543910508219580923", "-1048575.999999204878551016430145238979482",
                   "-0.218062997125040938396047984715213370615"}},
                 {"triangle.biharmonic_single_layer",
                  0,
                  {"0.3307569258015431255361256774328439699069", "-0.1655484583249415074631270287873247532149",
                   "0.00000000774404457322984860479478877084581699623"}},
                 {"triangle.biharmonic_double_layer",
                  1,
                  {"0.00000007804257317069784876416784509185460996403",
                   "0.0000003854735044445123692217983522285277378745", "0.0303075658127795013807274252101487942546"}}});
}

TEST(Agreement, stored_near_face) {
  expect_stored({"near-face", kStored, {1.5, 1, -0x1p-10}},
                {{"triangle.single_layer",
                  0,
                  {"0.6705620388048159898180326894167413421142", "0.006851773042451239054233459567355991267382",
                   "0.00001149960866725901783272667792332048216507"}},
                 {"triangle.double_layer",
                  1,
                  {"0.1457245277450286700994051266136617910108", "-0.04161762693542567062908010902799959959441",
                   "0.1362350378661925902767199160466192725144"}},
                 {"triangle.solid_angle",
                  0,
                  {"6.278389412148236601326395083872763389665", "0.0002170753460052894559777285461963898422283",
                   "-0.1479763397935153511290793576085222124559"}},
                 {"triangle.biharmonic_single_layer",
                  0,
                  {"0.2424685022877178956536977914099405531677", "-0.002579700018285814277485550489685958332753",
                   "-0.000006130387722816302563336676692003537702752"}},
                 {"triangle.biharmonic_double_layer",
                  1,
                  {"-0.0001004253506784249480241326324437207604782", "0.00001414228826090166187795931049381453605971",
                   "0.04596184719744884682962097123512290973082"}}});
}

TEST(Agreement, stored_sliver) {
  expect_stored({"sliver",
                 {Vec3<double>(.5, -.25, 1), Vec3<double>(2.5, .75, 1.5), Vec3<double>(1.5, .2578125, 1.25)},
                 {1.25, .5, 2}},
                {{"triangle.single_layer",
                  0,
                  {"0.0006909225308917291576142345945474980127994", "-0.0001984487485424168597369728745937068797315",
                   "-0.0005833413985397051804157908568952292627615"}},
                 {"triangle.double_layer",
                  1,
                  {"-0.0002140261814735040788513749003423800703624", "0.0001331045005427325655304872231612525607655",
                   "0.0007623163844290586032960183692174973753024"}},
                 {"triangle.solid_angle",
                  0,
                  {"-0.008279808712456876252112694521666687952924", "0.007320782140616466840495461469803208293194",
                   "0.0211700925026865294714499199906021952446"}},
                 {"triangle.biharmonic_single_layer",
                  0,
                  {"0.0003020236794061328228038468177300744238557", "0.00008403375056492602812127809266432577299537",
                   "0.00007256603006765519778903829256268605613419"}},
                 {"triangle.biharmonic_double_layer",
                  1,
                  {"0.00008999782584040660499632270249858673566346", "-0.0000163747884643544247673495250192082519212",
                   "-0.00002721410679112517709218098993857726506"}}});
}

}  // namespace
}  // namespace cageproof::quadrature_ref
