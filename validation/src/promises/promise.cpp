// SPDX-License-Identifier: MIT
#include "cageproof/validation/promise.h"

#include <fmt/format.h>
#include <fnmatch.h>

#include <algorithm>
#include <array>
#include <stdexcept>

namespace cageproof::validation {
namespace {

struct Row {
  std::string_view check, subject, evaluation, scalar, regime;
  int lowest_order, highest_order;
  std::optional<double> bound;
  std::string_view reason;
  bool of_rules = false;  ///< for rules and schemes only: an evaluation that people rely on must have another row
};

constexpr std::optional<double> none = std::nullopt;

// Names of recommended evaluations; `recommended` stands for kinds of coordinates that are not sums over faces.
constexpr std::string_view recommended = "@(hybrid|closed_form|line_form|recommended)";

// Bound for the maps that a deformer keeps exactly: 1e-13 of the size. Figures are divided by 1e-3 times the condition
// of the systems that are solved, where that condition is above 1e3.
constexpr double exact_map = 1e-13;
constexpr std::string_view met_data = "the tolerance of the least squares that meet the data on the boundary";
constexpr std::string_view deformer_reason =
    "exact except for roundings: 1e-16 of the size, times a thousand or times the condition of the systems "
    "solved, which excuses errors down to the seventh digit and no further; for a cage or a pose far from the "
    "origin also four roundings of its coordinates, down to the fifth digit; of images beyond a size off, in "
    "their own size, as they are rounded";
constexpr std::string_view least_energy =
    "steps end where rounding hides the energy's slope; the minimum is then as far off as the root of a rounding";
constexpr std::string_view unit_normals =
    "unit normals do not grow with the cage, products of both stretches grow with its square";

// The evaluation of whole cages at once, and all names that checks of cages may have.
constexpr std::string_view batched = "batched";
constexpr std::string_view of_cages = "@(hybrid|closed_form|line_form|recommended|batched)";

// First match wins. The bound's unit is the check's: for `truth`, roundings times conditioning; see Question::unit.
constexpr std::array table{
    // The gate: the closed form in multiprecision against the integral.
    Row{"integral", "*", "*", "*", "*", 0, 2, 1e-30, "30 digits, wherever the integral reaches them"},
    Row{"enclosure", "*", "*", "*", "*", 0, 2, 1, "the enclosure is a proof: the integral lies in it"},
    Row{"limit", "*", "*", "*", "*", 0, 2, 1e-30,
        "1e-60 sizes inside, what is missing of the limit is r log r over the distance to the next vertex: 1e-17 where "
        "the point is an ulp off one"},
    // An evaluation with a tolerance.
    Row{"stated_error", "*", "*", "*", "*", 0, 2, 1,
        "d digits are a bound of 10^-d on the relative error, and a bound leaves no slack: the truth is good to 30 "
        "digits, "
        "fourteen more than are ever stated in double"},
    // The forms we stand behind.
    Row{"truth", "*", recommended, "double", "*", 0, 2, 64, "backward stable: a few roundings times conditioning"},
    Row{"truth", "*", recommended, "float", "*", 0, 2, 64, "computed in double and rounded"},
    // Digits, whatever the conditioning.
    Row{"digits", "quad.single_layer", "line_form", "double", "aligned", 2, 2, none,
        "some quads with small integer corners have three on a line and fold there; next to the crease, where du dv "
        "is infinitely dense, double gives Hessians only to a rounding of the corners"},
    Row{"digits", "*", recommended, "double", "*", 0, 2, 1e3,
        "thirteen digits: some tens of operations on numbers with one rounding each; sums of terms that cancel ten "
        "times "
        "over keep it too"},
    Row{"truth", "*", "accurate", "double", "*", 0, 2, 256,
        "a relative error of 256 units is also at most 256 conditioned units, because the denominator only grows"},
    Row{"truth", "*", "accurate", "float", "*", 0, 2, 256, "computed in double and rounded"},
    Row{"relative", "*", "accurate", "float", "*", 0, 2, 256, "computed in double and rounded"},
    Row{"relative", "*", "accurate", "double", "*", 0, 2, 256,
        "accepted at a running error bound of 128 units, which is itself rounded; else computed with more digits"},
    // The plain form uses one scalar. This row is for points that are neither near the element nor far.
    Row{"truth", "triangle.mean_value", "plain", "*", "@(generic|offset)", 1, 2, none,
        "each derivative divides once more by the height over the plane, with which the value is small"},
    Row{"truth", "@(segment|triangle).*", "plain", "*", "@(generic|offset)", 0, 2, 1e3,
        "within one size no term is more than some tens of the whole, and a result takes some tens of operations"},
    Row{"truth", "*", "plain", "*", "*", 0, 2, none,
        "uses one scalar and nothing wider; the report states what it loses far away, next to lines and on thin "
        "elements"},
    // Printed forms away from their weak spots, which are the lines of edges, thin triangles, and far away.
    Row{"truth", "segment.*", "published", "float", "offset", 0, 2, none,
        "in float points far from the origin round onto ends, of whose limits [W12] Appendix A says nothing"},
    Row{"truth", "*", "published", "*", "@(generic|offset)", 0, 2, 1e8,
        "half of double's digits, which is enough to tell it from another formula: logarithms and angles cancel by "
        "the square of the distance to an edge's line, which costs six digits at 1e-3, and hardly any of a million "
        "points within one size is nearer; a hundred terms cost two more"},
    Row{"truth", "*", "published", "*", "*", 0, 2, none,
        "as the paper prints it, after the errata: nothing is stabilised"},
    // Rules of fixed size have these errors from ten sizes on, because n points integrate polynomials of degree 2n - 1,
    // and the kernel's expansion about the element has a remainder of (size/distance)^2n.
    Row{"truth", "*", "gauss-4", "double", "far", 0, 2, 1e8,
        "its rate: 10^-8 of the truth at ten sizes, in units of 1e-16", true},
    Row{"truth", "*", "three-quad-75", "double", "far", 0, 2, 1e6,
        "its rate: 10^-10 of the truth at ten sizes, by five points per direction, in units of 1e-16", true},
    Row{"truth", "*", "@(gauss-8|gauss-16|three-quad-300|near-singular-16)", "double", "far", 0, 2, 64,
        "its rate is below rounding at ten sizes: 10^-16 by eight points per direction, and less", true},
    Row{"truth", "segment.*", "near-singular-*", "double", "generic", 2, 2, 1e10,
        "twelve digits of an integrand whose peak exceeds its integral by the square of size over distance; among a "
        "million points within one size hardly any is nearer than 1e-3",
        true},
    Row{"truth", "*", "near-singular-*", "double", "generic", 0, 2, 1e4,
        "made for points next to the element: twelve digits within one size", true},
    // Schemes of order n^-2, by the twist of the quad, whose corner is lifted by less than its size.
    Row{"truth", "quad.mean_value", "riemann-4", "double", "@(generic|far|scaled)", 0, 0, 6.25e-2 * 0x1p53,
        "its order: 1/n^2 of the truth, in units of 2^-53", true},
    Row{"truth", "quad.mean_value", "riemann-7", "double", "@(generic|far|scaled)", 0, 0, 2.05e-2 * 0x1p53,
        "its order: 1/n^2 of the truth, in units of 2^-53", true},
    Row{"truth", "quad.mean_value", "riemann-10", "double", "@(generic|far|scaled)", 0, 0, 1e-2 * 0x1p53,
        "its order: 1/n^2 of the truth, in units of 2^-53", true},
    Row{"truth", "quad.mean_value", "tessellated-5", "double", "@(generic|far|scaled)", 0, 0, 8e-2 * 0x1p53,
        "its order: 2/n^2 of the truth, two triangles per cell, in units of 2^-53", true},
    Row{"truth", "*", "adaptive", "*", "*", 0, 2, none,
        "integrates until its own tolerance is met, and says how many digits it stands behind: stated_error holds it "
        "to that, whatever their number",
        true},
    Row{"truth", "quad.*", "line-*", "*", "*", 0, 2, none,
        "the line form with the number of digits in its name; the report states how many it keeps", true},
    Row{"truth", "quad.*", "@(riemann-*|tessellated-*|midpoint-*)", "*", "*", 0, 2, none,
        "a scheme that approximates the quad by its grid; the report states its error next to the quad, and that of "
        "derivatives",
        true},
    Row{"truth", "*", "@(gauss-*|three-quad-*|near-singular-*)", "*", "*", 0, 2, none,
        "a quadrature rule of fixed size; the report states its error", true},
    Row{"truth", "segment.*", "offset-*", "*", "*", 0, 2, none,
        "the closed form at a point moved off the boundary; the report states the cost of the move", true},
    // Properties: two evaluations, each within the promise of `truth`.
    Row{"subdivision", "*", recommended, "double", "*", 0, 2, 320, "five evaluations within 64 each"},
    Row{"side_relation", "*", recommended, "double", "*", 0, 0, 64, "each layer within 64, in units of both together"},
    Row{"side_relation", "*", "accurate", "double", "*", 0, 0, 256, "each layer within 256"},
    Row{"laplacian", "*", recommended, "double", "*", 0, 2, 192, "three second derivatives within 64 each"},
    Row{"scaling", "*", recommended, "double", "*", 0, 2, 128, "two evaluations within 64 each"},
    Row{"rigid_motion", "*", recommended, "double", "*", 0, 2, 128, "two evaluations within 64 each"},
    Row{"corner_permutation", "*", recommended, "double", "*", 0, 2, 128, "two evaluations within 64 each"},
    Row{"orientation_flip", "*", recommended, "double", "*", 0, 2, 128, "two evaluations within 64 each"},
    Row{"subdivision", "*", "accurate", "double", "*", 0, 2, 1280, "five evaluations within 256 each"},
    Row{"laplacian", "*", "accurate", "double", "*", 0, 2, 768, "three second derivatives within 256 each"},
    Row{"scaling", "*", "accurate", "double", "*", 0, 2, 512, "two evaluations within 256 each"},
    Row{"rigid_motion", "*", "accurate", "double", "*", 0, 2, 512, "two evaluations within 256 each"},
    Row{"corner_permutation", "*", "accurate", "double", "*", 0, 2, 512, "two evaluations within 256 each"},
    Row{"orientation_flip", "*", "accurate", "double", "*", 0, 2, 512, "two evaluations within 256 each"},
    Row{"gradient_by_differences", "*", "*", "mp200", "*", 1, 2, 1e-30,
        "central differences of step 1e-40 sizes are good to 1e-48 at 1e-16 sizes from a singularity; 200 digits "
        "leave room for cancellation far away"},
    Row{"face_jump", "*", "*", "mp100", "*", 0, 0, 1e-30, "two points 1e-40 sizes off the face"},
    // Whether an evaluation gives each triangle's own derivatives.
    Row{"own_derivative", "*", "curl-form", "*", "*", 1, 2, none,
        "P x d/(2|t|) is not the gradient of one triangle's coordinate: only its sums over a closed cage are "
        "gradients"},
    Row{"own_derivative", "*", "*", "double", "*", 1, 2, 1e-9,
        "2e-2 sizes off the cage; a form that is right only in sums misses by its size"},
    Row{"one_ring_sum", "*", "*", "double", "*", 1, 2, 1e-9,
        "2e-2 sizes off the cage, norm-wise over its vertices, in the norms of the terms"},
    Row{"one_ring_sum_small_faces", "*", "*", "double", "*", 1, 2, none,
        "the form as printed loses the square of a distance over the size of a face, and faces here are so small "
        "that fewer than nine digits are left"},
    // Across the hull of a twisted quad.
    Row{"hull_jump", "*", "riemann-*", "*", "*", 1, 1, none,
        "the projection behind it is continuous across the hull, its derivative is not ([T18] Lemma 3.4)"},
    Row{"hull_jump", "*", "*", "*", "*", 0, 1, 1e-6, "limits extrapolated from 2e-6 sizes"},
    // Cages, at points at least 1e-6 of their size away, and on them. Errors of sums are counted in roundings of their
    // terms, as those of elements are in roundings times conditioning: the sides of a thin wall cancel, and what is
    // left of a sum is off by as much as its terms are.
    // Least squares on the boundary, whose tolerances are 1e-10 and 1e-9 of the data.
    Row{"boundary_residual", "*_goursat", "*", "double", "@(square|l-shape)", 0, 0, 1e-10, "the solver's tolerance"},
    Row{"boundary_residual", "*_goursat", "*", "double", "@(square|l-shape)", 1, 1, 1e-9, "the solver's tolerance"},
    Row{"boundary_residual", "*_goursat", "*", "double", "star", 0, 0, 1e-9,
        "its ten corners take all functions that a second of solving allows: 20 exponents each leave 2e-10 of the "
        "data, as found"},
    Row{"boundary_residual", "*_goursat", "*", "double", "star", 1, 1, 1e-7, "as its values, a corner's size 1e-2"},
    Row{"boundary_residual", "*_goursat", "*", "double", "thin-bar", 0, 0, 2e-6,
        "the layers at its ends are as wide as the bar, which degree 160 resolves to six digits; 1.05e-6 as found"},
    Row{"boundary_residual", "*_goursat", "*", "double", "thin-bar", 1, 1, 1e-4, "as its values, over a bar's width"},
    Row{"boundary_residual", "*_goursat", "*", "double", "*", 0, 1, none,
        "one second of solving allows only so many functions; the row states the residual that they reach"},
    // Sums of coordinates solve for the sum of their data; constants and linear functions are in the basis.
    Row{"partition_of_unity", "*_goursat", "*", "double", "@(square|l-shape)", 0, 0, 1e-9 * 0x1p53,
        "ten residuals of 1e-10, in units of 2^-53: a bound by the maximum principle where harmonic; biharmonic "
        "functions have none, and are held to the same"},
    Row{"partition_of_unity", "*_goursat", "*", "double", "star", 0, 0, 1e-9 * 0x1p53,
        "one residual of 1e-9, in units of 2^-53"},
    Row{"partition_of_unity", "*_goursat", "*", "double", "thin-bar", 0, 0, 1e-6 * 0x1p53,
        "its residual, in units of 2^-53"},
    Row{"partition_of_unity", "*_goursat", "*", "double", "*", 0, 2, none,
        "a bound on residuals gives none on derivatives next to the cage, or where residuals are only stated as "
        "found"},
    Row{"linear_reproduction", "*_goursat", "*", "double", "@(square|l-shape|star)", 0, 0, 1e-9 * 0x1p53,
        "as the partition of unity"},
    Row{"linear_reproduction", "*_goursat", "*", "double", "thin-bar", 0, 0, 1e-6 * 0x1p53,
        "as the partition of unity"},
    Row{"linear_reproduction", "*_goursat", "*", "double", "*", 0, 2, none, "as the partition of unity"},
    Row{"limit_from_inside", "*_goursat", "*", "double", "@(square|l-shape|star)", 0, 0, 1e-6,
        "1e-11 sizes inside a corner values differ by that to the power of the corner's first exponent, 0.6 in a "
        "notch"},
    Row{"limit_from_inside", "*_goursat", "*", "double", "*", 0, 2, none,
        "boundary_residual compares the data on the cage with the solutions inside"},
    Row{"cage_scaling", "*_goursat", "*", "double", "*", 0, 0, 0, "by powers of two nothing changes but exponents"},
    Row{"cage_rigid_motion", "*_goursat", "*", "double", "*", 0, 0, none,
        "two solutions, each as far from the truth as its boundary_residual; next to the cage more than beta's size"},
    Row{"cage_laplacian", "harmonic_goursat", "*", "double", "*", 2, 2, 64,
        "each function is harmonic, and its Hessian is written with opposite numbers"},
    Row{"cage_differences", "*_goursat", "*", "*", "*", 1, 2, 1e-30,
        "central differences of step 1e-30 sizes in 100 digits are good to 1e-48 at 1e-6 sizes from the cage"},
    Row{"partition_of_unity", "maximum_entropy", "*", "double", "*", 1, 2, none,
        "the entropy's matrix becomes singular where few vertices carry the weight, and derivatives divide by it"},
    Row{"linear_reproduction", "maximum_entropy", "*", "double", "*", 1, 2, none,
        "the entropy's matrix becomes singular where few vertices carry the weight, and derivatives divide by it"},
    Row{"cage_truth", "maximum_entropy", "*", "double", "*", 1, 2, none,
        "the entropy's matrix becomes singular where few vertices carry the weight, and derivatives divide by it"},
    Row{"partition_of_unity", "spherical_mean_value", "*", "*", "*", 1, 2, none,
        "next to a face the common part of the diverging weights cancels in the quotient rule, and no terms are "
        "known that would count this loss"},
    Row{"linear_reproduction", "spherical_mean_value", "*", "*", "*", 1, 2, none,
        "next to a face the common part of the diverging weights cancels in the quotient rule, and no terms are "
        "known that would count this loss"},
    Row{"cage_truth", "spherical_mean_value", "*", "*", "*", 1, 2, none,
        "next to a face the common part of the diverging weights cancels in the quotient rule, and no terms are "
        "known that would count this loss"},
    Row{"linear_reproduction", "spherical_mean_value", "*", "double", "wedge-*", 0, 0, none,
        "sharing a face's mean vector among corners that are seen nearly in a plane is ill-posed, and no terms are "
        "known that would count this loss"},
    Row{"cage_truth", "spherical_mean_value", "*", "double", "wedge-*", 0, 0, none,
        "sharing a face's mean vector among corners that are seen nearly in a plane is ill-posed, and no terms are "
        "known that would count this loss"},
    Row{"cage_rigid_motion", "spherical_mean_value", "*", "double", "wedge-*", 0, 0, none,
        "sharing a face's mean vector among corners that are seen nearly in a plane is ill-posed, and no terms are "
        "known that would count this loss"},
    Row{"cage_corner_permutation", "spherical_mean_value", "*", "double", "wedge-*", 0, 0, none,
        "sharing a face's mean vector among corners that are seen nearly in a plane is ill-posed, and no terms are "
        "known that would count this loss"},
    Row{"cage_truth", "spherical_mean_value", "*", "double", "crack-*", 0, 0, none,
        "sharing a face's mean vector among corners that are seen nearly in a plane is ill-posed, and no terms are "
        "known that would count this loss"},
    Row{"cage_rigid_motion", "spherical_mean_value", "*", "double", "crack-*", 0, 0, none,
        "sharing a face's mean vector among corners that are seen nearly in a plane is ill-posed, and no terms are "
        "known that would count this loss"},
    Row{"cage_corner_permutation", "spherical_mean_value", "*", "double", "crack-*", 0, 0, none,
        "sharing a face's mean vector among corners that are seen nearly in a plane is ill-posed, and no terms are "
        "known that would count this loss"},
    Row{"scheme_error", "*", "*", "double", "*", 0, 2, none,
        "states the scheme's distance from the functions that it approximates: the Laplacian is singular at corners, "
        "and the scheme takes it for linear on pieces"},
    Row{"boundary_data", "*", "*", "double", "*", 0, 1, none,
        "Eq 7 of [W12] holds only in the limit of many pieces, and for normal derivatives next to corners not even "
        "in the limit"},
    Row{"cage_truth", "@(*_boundary|harmonic|elastic|biharmonic_complex)", recommended, "double", "*", 0, 2, 16384,
        "the condition of the systems that are solved enlarges the roundings of their matrices: 1e2 ... 1e4 with "
        "four pieces per edge, the most in thin bars"},
    Row{"cage_truth", "regularised_*", recommended, "double", "*", 0, 2, 16384,
        "as for other solved kinds: terms count the roundings of columns, and the truth also shows those common to "
        "all, the roundings of matrices times the condition, 1e2 ... 1e4 on cages of a dozen elements, the most in "
        "thin bars"},
    Row{"partition_of_unity", "@(*_boundary|harmonic|elastic|biharmonic_complex)", recommended, "double", "*", 1, 2,
        16384,
        "as for cage_truth: the roundings of the systems' solutions are summed with derivatives that grow next to "
        "the boundary"},
    Row{"linear_reproduction", "@(*_boundary|harmonic|elastic|biharmonic_complex)", recommended, "double", "*", 1, 2,
        16384,
        "as for cage_truth: the roundings of the systems' solutions are summed with derivatives that grow next to "
        "the boundary"},
    Row{"partition_of_unity", "*", of_cages, "double", "*", 0, 2, 64,
        "each term of the sums is good to a few roundings; normalised sums count those of the quotient rule"},
    Row{"linear_reproduction", "*", of_cages, "double", "*", 0, 2, 64, "as the partition of unity"},
    Row{"partition_of_unity", "quad_mean_value", "*", "double", "*", 0, 0, 64, "normalised sums"},
    Row{"linear_reproduction", "quad_mean_value", "@(gauss-*|midpoint-*)", "double", "*", 0, 0, none,
        "a fixed rule misses the mean vector of a near quad"},
    Row{"linear_reproduction", "quad_mean_value", "riemann-*-@(uncorrected|unguarded)", "double", "*", 0, 0, none,
        "counted in the exact weights' terms; without the norm correction, or next to its poles, weights are up to 1e8 "
        "times as large, and so are their roundings"},
    Row{"linear_reproduction", "quad_mean_value", "*", "double", "*", 0, 0, 64,
        "weights that keep a quad's mean vector, Eq 17 of [T18]"},
    Row{"second_route", "spherical_mean_value", "*", "*", "*", 0, 0, 1e-30,
        "30 digits, 1e-14 of one rounding of double: integrals have 57 digits, less those that cancel in a face's "
        "mean vector"},
    Row{"second_route", "positive_mean_value", "*", "*", "*", 0, 0, 2e-2,
        "the route is a cube map of 96 x 96 rays per face: one over their number, at the silhouettes of what hides"},
    Row{"second_route", "maximum_entropy", "*", "*", "*", 0, 0, 1e-30,
        "30 digits: the minimum is accepted at 900 roundings of 50 digits, which its condition next to the hull's "
        "border "
        "enlarges"},
    Row{"second_route", "@(harmonic|elastic|biharmonic_boundary|triharmonic_boundary)", "*", "*", "*", 0, 0, 1e-30,
        "30 digits: the route takes layers 1e-42 inside for their limits, which systems enlarge by their condition, "
        "1e5 "
        "and less"},
    Row{"non_negativity", "*", "*", "double", "*", 0, 0, none,
        "the kind and the cage decide whether coordinates are negative; values within 64 roundings may be zero"},
    Row{"zero_outside", "@(*_boundary|harmonic|elastic|biharmonic_complex)", recommended, "double", "*", 1, 2, 256,
        "as for the partition of unity's derivatives; 104 was found next to the corner of an L, and at most 16 "
        "elsewhere"},
    Row{"zero_outside", "*", of_cages, "double", "*", 0, 2, 64, "as the partition of unity"},
    Row{"limit_from_inside", "*", of_cages, "double", "*", 0, 0, 1e-6,
        "1e-11 sizes inside, coordinates differ by that times their gradient, which small faces and a logarithm "
        "enlarge"},
    Row{"limit_from_inside", "@(*_boundary|harmonic|elastic|biharmonic_complex)", recommended, "double", "*", 1, 2,
        none, "derivatives have a logarithm at the ends of each piece of an edge, which may lie next to the point"},
    Row{"limit_from_inside", "regularised_*", recommended, "double", "*", 1, 2, 1e-8,
        "as for the layers, times the densities, which are up to 1e2 times the data"},
    Row{"limit_from_inside", "*", of_cages, "double", "*", 1, 2, 1e-10,
        "1e-11 sizes inside, derivatives differ by that over a power of the distance to the next edge, which the "
        "figure is multiplied with, times a number of order ten"},
    Row{"cage_scaling", "regularised_weber", recommended, "double",
        "@(cube|icosphere|torus|l-block|twisted-bar|thin-box|spiky-box)", 0, 0, 64,
        "as the partition of unity, norm-wise over a block: in space each of its equations has one unit"},
    Row{"cage_scaling", "regularised_weber", recommended, "double", "*", 0, 0, none,
        "promised on the embedded cages of space; in the plane the layers' logarithm has the unit's"},
    Row{"cage_scaling", "regularised_*", recommended, "double", "*", 0, 0, none,
        "values are weighed against Laplacians or normal derivatives, which change with the unit by other powers: "
        "gamma_d goes with its fourth"},
    Row{"cage_scaling", "*", of_cages, "double", "*", 0, 0, 64, "as the partition of unity, norm-wise over a block"},
    Row{"cage_rigid_motion", "*", of_cages, "double", "*", 0, 0, 64,
        "as the partition of unity, norm-wise over a block"},
    Row{"cage_corner_permutation", "*", of_cages, "double", "*", 0, 0, 64,
        "as the partition of unity, norm-wise over a block"},
    Row{"cage_subdivision", "*", of_cages, "double", "*", 0, 0, 64,
        "as the partition of unity, norm-wise over a block"},
    Row{"cage_differences", "*", recommended, "*", "*", 1, 2, 1e-30,
        "central differences of step 1e-30 sizes in 100 digits are good to 1e-48 at 1e-6 sizes from the cage"},
    Row{"cage_laplacian", "*", of_cages, "double", "*", 2, 2, 64, "as the partition of unity, norm-wise over a block"},
    Row{"cage_truth", "*", batched, "double", "*", 2, 2, none,
        "a moved point changes a Hessian by a third derivative, which terms do not have; cage_block_error has the "
        "promise"},
    Row{"cage_truth", "*", of_cages, "double", "*", 0, 2, 64, "as the partition of unity, norm-wise over a block"},
    Row{"rest_derivative", "*", "*", "double", "*", 0, 0, 1024,
        "an element's slopes are good to 1024 roundings of the largest, times what rounding the input costs: the "
        "sides' "
        "integrals cancel, most in the element's plane"},
    Row{"rest_derivative_transposed", "*", "*", "double", "*", 0, 0, 64,
        "the same slopes are summed in another order: some tens of roundings of the terms"},
    // Whole cages at once, in units of what rounding the cage in its own frame costs.
    Row{"cage_block_error", "@(mean_value|quad_mean_value)", batched, "double", "*", 1, 2, 32,
        "next to the cage, where weights grow like 1/h and w/W stays bounded, derivatives of w/W cancel in the "
        "quotient rule; the unit counts one rounding of each weight's derivatives for that, and oblique thin walls "
        "and flat tetrahedra take 29"},
    Row{"cage_block_error", "quad_@(green|biharmonic)", batched, "double", "*", 1, 2, none,
        "derivatives are sums of elements, which cancel next to an edge where faces go on in one plane"},
    Row{"cage_block_error", "*", batched, "double", "*", 0, 2, 64,
        "a few roundings of the point and the corners in the cage's own frame, wherever the point is"},
    // Deformers, in cage sizes. docs/deform.md says what each method keeps.
    Row{"keeps_scale", "?(quad_)green", "stretch=@(unit|product)", "double", "*", 0, 0, none, unit_normals},
    Row{"keeps_scale", "?(quad_)biharmonic_*", "@(normals=@(unit|product)|neumann=affine)", "double", "*", 0, 0, none,
        unit_normals},
    Row{"keeps_mirror", "@(?(quad_)@(green|somigliana|biharmonic_*)|cauchy)", "*", "double", "*", 0, 0, none,
        "the posed normals of a mirror image point inward"},
    Row{"keeps_mirror", "@(ahap|aaap|tp)", "alignment=nonnegative", "double", "*", 0, 0, none,
        "the posed normals of a mirror image point inward, and no negative stretch turns them"},
    Row{"keeps_mirror", "@(ahap|aaap|tp)", "neumann=affine", "double", "*", 0, 0, none,
        "corner normals are turned by rotations, and a mirror image is none"},
    Row{"keeps_linear", "@(?(quad_)@(green|somigliana|biharmonic_*)|cauchy)", "*", "double", "*", 0, 0, none,
        "posed normals are not the images of normals, unless the map is a similarity"},
    Row{"keeps_linear", "@(ahap|aaap|tp)", "@(alignment=@(hard|soft|nonnegative)|neumann=affine)", "double", "*", 0, 0,
        none, "normal derivatives that are held to the posed normals are not those of the map"},
    Row{"keeps_symmetry_of_quads", "*", "*", "double", "*", 0, 0, none,
        "the triangles that quads are split in are not symmetric"},
    Row{"keeps_offset", "*_goursat", "*", "double", "*", 0, 0, 1e4,
        "1e-9 of the size, as other maps: at 1e3 sizes a rounding is 1e-13 of it"},
    Row{"keeps_offset", "*", "*", "double", "*", 0, 0, 4,
        "images are computed next to the cage, to 1e-13 of its size, which at 1e3 sizes is one rounding, and each "
        "component is rounded once on the way back: 1.7 found"},
    Row{"keeps_rigid", "*_goursat", "*", "double", "*", 0, 0, 1e-9, met_data},
    Row{"keeps_rigid", "*", "*", "double", "*", 0, 0, exact_map, deformer_reason},
    Row{"keeps_scale", "*_goursat", "*", "double", "*", 0, 0, 1e-9, met_data},
    Row{"keeps_scale", "*", "*", "double", "*", 0, 0, exact_map, deformer_reason},
    Row{"keeps_mirror", "*_goursat", "*", "double", "*", 0, 0, 1e-9, met_data},
    Row{"keeps_mirror", "*", "*", "double", "*", 0, 0, exact_map, deformer_reason},
    Row{"keeps_linear", "*_goursat", "*", "double", "*", 0, 0, 1e-9, met_data},
    Row{"keeps_linear", "*", "*", "double", "*", 0, 0, exact_map, deformer_reason},
    Row{"keeps_linear_with_normals", "*_goursat", "*", "double", "*", 0, 0, 1e-9, met_data},
    Row{"keeps_linear_with_normals", "*", "*", "double", "*", 0, 0, exact_map, deformer_reason},
    Row{"keeps_symmetry", "*_goursat", "*", "double", "*", 0, 0, 1e-9, met_data},
    Row{"keeps_symmetry", "*", "*", "double", "*", 0, 0, exact_map, deformer_reason},
    Row{"deformer_truth", "*", "*", "double", "*", 0, 0, exact_map, deformer_reason},
    Row{"deformer_truth", "*", "*", "double", "*", 1, 1, 10 * exact_map,
        "as images; 2e-2 sizes inside, each derivative loses a digit to the cage's nearness"},
    Row{"deformer_truth", "*", "*", "double", "*", 2, 2, 100 * exact_map,
        "as images; 2e-2 sizes inside, each derivative loses a digit to the cage's nearness"},
    Row{"deformer_jacobian", "*", "*", "double", "*", 1, 2, none, "differences in double have few digits"},
    Row{"deformer_jacobian", "*", "*", "*", "*", 1, 2, 1e-25,
        "central differences of step 1e-16 sizes in 50 digits, 2e-2 sizes inside"},
    Row{"pose_derivative", "*", "*", "double", "*", 0, 0, exact_map,
        "as deformer_truth: J is made of what images are made of; differences of step 1e-16 sizes are good to 1e-30"},
    Row{"pose_derivative_in_double", "*", "*", "double", "@(cube|square|l-shape|l-block|twisted-bar)", 0, 0, 1e-9,
        "images' 1e-13 over a step of 1e-4 sizes; differences of fourth order leave out less than that"},
    Row{"pose_derivative_in_double", "*", "*", "double", "*", 0, 0, none,
        "differences in double have few digits, and next to small faces their step is a large one"},
    Row{"pose_derivative_transposed", "*", "*", "double", "*", 0, 0, 1024,
        "1e-13, as images, of the terms of the sum: both directions take the same products in another order; 30 found"},
    Row{"second_route", "variational", "*", "double", "*", 0, 0, 1e-11,
        "as energy_is_flat: roundings times the condition of the rows, 1e4 and less"},
    Row{"second_route", "thickness", "*", "double", "*", 0, 0, 1e-7,
        "steps end where 64 roundings hide the merit's slope, which is then as large as their square root, 8e-8"},
    Row{"second_route", "*", "*", "mp50", "*", 0, 0, 1e-30,
        "30 digits: 50 less those of the squared condition of the systems solved, 1e4 or less"},
    Row{"deformer_by_quadrature", "*", "*", "double", "*", 0, 0, 1e-12,
        "the adaptive rule's tolerance on each coordinate"},
    // Deformers by constraints: energies over those before, or in a unit in which the cage's size is one; images in
    // cage sizes.
    Row{"energy_falls", "*", "*", "double", "*", 0, 0, 1e-12,
        "every half step is a minimum, and no step that raises a merit is taken; the bound is for roundings of sums"},
    Row{"rigid_energy", "thickness", "*", "double", "*", 0, 0, 1e-22,
        "squares of 40 roundings times second derivatives at samples next to edges, 2,400 per size on a drawing of "
        "eight corners"},
    Row{"rigid_energy", "*", "*", "double", "*", 0, 0, 1e-24,
        "a rigid motion has no energy; what is left are squares of the images' errors, 1e-13 or more by the "
        "constraints' condition"},
    Row{"energy_is_flat", "*", "*", "double", "*", 0, 0, 1e-11,
        "a global step solves for the gradient's zero: roundings times the condition of the rows, 1e4 and less"},
    Row{"constrained_unit", "thickness", "*", "double", "*", 0, 0, 1e-8, least_energy},
    Row{"constrained_motion", "thickness", "*", "double", "*", 0, 0, 1e-8, least_energy},
    Row{"constrained_unit", "*", "*", "double", "*", 0, 0, 1e-12, deformer_reason},
    Row{"constrained_motion", "*", "*", "double", "*", 0, 0, 1e-12, deformer_reason},
};

// A glob, which may hold alternatives: @(a|b).
bool is_one_of(std::string_view pattern, std::string_view text) {
  return fnmatch(std::string(pattern).c_str(), std::string(text).c_str(), FNM_EXTMATCH) == 0;
}

const Row* row_of(const PromiseKey& key) {
  const auto found = std::ranges::find_if(table, [&](const Row& row) {
    return matches(row.check, key.check) && is_one_of(row.subject, key.subject) &&
           is_one_of(row.evaluation, key.evaluation) && matches(row.scalar, key.scalar) &&
           is_one_of(row.regime, key.regime) && row.lowest_order <= key.order && key.order <= row.highest_order;
  });
  return found == table.end() ? nullptr : &*found;
}

}  // namespace

std::vector<std::string_view> promised_checks() {
  std::vector<std::string_view> names;
  for (const Row& row : table)
    if (std::ranges::find(names, row.check) == names.end()) names.push_back(row.check);
  return names;
}

bool matches_evaluation(std::string_view pattern, const Evaluation& evaluation) {
  if (matches(pattern, evaluation.name())) return true;
  for (const EvaluationFamily* family : EvaluationRegister::instance().families(evaluation.formula().name))
    if (!family->alias.empty() && family->pattern == evaluation.name() && matches(pattern, family->alias)) return true;
  return false;
}

Promise promise_for(const PromiseKey& key) {
  if (const Row* row = row_of(key)) return {row->bound, row->reason, true};
  return {std::nullopt, "stated as found"};
}

void require_row(const PromiseKey& key, std::optional<Role> role) {
  const bool relied_on =
      role == Role::Recommended || role == Role::ClosedForm || role == Role::Stated || role == Role::Batched;
  const auto known = promised_checks();
  const bool known_check = std::ranges::find(known, key.check) != known.end();
  const Row* row = row_of(key);
  if ((known_check && !relied_on) || (row != nullptr && !(relied_on && row->of_rules))) return;
  throw std::logic_error(fmt::format(
      "the table of promises has no row for the check '{}' of {}, evaluation '{}', in {}, {}, order {}: add "
      "one to validation/src/promises/promise.cpp, with a bound or with the reason why there is none",
      key.check, key.subject, key.evaluation, key.scalar, key.regime, key.order));
}

}  // namespace cageproof::validation
