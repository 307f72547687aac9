// SPDX-License-Identifier: MIT
// The catalogue of defects. Two rows that explain the same sample: the first is named.
#include "cageproof/judge/verdict.h"

#include "cageproof/core/input_error.h"

#include <fmt/format.h>

#include <array>

namespace cageproof::judge {
namespace {

constexpr std::array kDefects{
    Defect{"writes_past_output", "It writes beyond the end of its output.",
           "memory next to the output changes during a call", "write count times components numbers, and no more",
           "defects.md#writes_past_output"},
    Defect{"non_deterministic", "The same call gives different numbers.",
           "results of repeated calls differ, with nothing changed in between",
           "sum in a fixed order, and read no memory that was never set", "defects.md#non_deterministic"},
    Defect{"appended_output", "It adds to what the output held instead of replacing it.",
           "results differ by as much as the output did before the call",
           "assign; set accumulators to zero inside the function", "defects.md#appended_output"},
    Defect{"wrong_size", "The answer has more or fewer numbers than were asked for.",
           "a second call's answer is longer or shorter", "clear the output first", "defects.md#wrong_size"},
    Defect{"uninitialised_output", "It leaves numbers of its output unset.",
           "results are what the output held before the call", "set the whole output before any early return",
           "defects.md#uninitialised_output"},
    Defect{"reads_past_input", "It reads beyond the end of its input.",
           "results change with the memory behind corners, points or parameters",
           "count corners, not coordinates; wrap indices at the last corner", "defects.md#reads_past_input"},
    Defect{"order_of_calls", "Results depend on which points were asked before.",
           "points in another order, or one by one, give other numbers", "start iterations from the input only",
           "defects.md#order_of_calls"},
    Defect{"state_between_calls", "It keeps data of an earlier element.",
           "an element's result changes after a call with another, or is that of the other",
           "key what is kept by its content, or keep it in an object that belongs to one element",
           "defects.md#state_between_calls"},
    Defect{"differs_between_threads", "Calls at the same time disturb each other.",
           "results of four threads at once differ from those of one", "no static or global buffers",
           "defects.md#differs_between_threads"},
    Defect{"ignored_parameter", "A parameter changes nothing.",
           "results for two values of the parameter are equal, and must not be",
           "pass the parameter through; refuse it where it is not supported", "coordinates.md#the-blocks-of-each-kind"},
    Defect{"quadrature_near", "A fixed quadrature is right far away and wrong near the element.",
           "errors vanish some sizes away, and are large within one size", "take the closed form near the element",
           "benchmarks.md#what-is-measured"},
    Defect{"right_after_normalising", "Values are right only after they are divided by their sum.",
           "theirs is ours times a factor that depends on the point and is the same for all corners",
           "leave no factor of the element out: it does not cancel between elements",
           "defects.md#right_after_normalising"},
    Defect{"sum_made_right", "The sum over the corners is right, and single values are wrong.",
           "each corner's value fails where their sum holds", "test single values as well as the partition of unity",
           "checks.md#checks-of-cages"},
    Defect{"gradient_only_in_sums", "The gradient is right only when it is summed over a closed cage.",
           "one element's gradient fails everywhere, and the sum over a tetrahedron holds",
           "differentiate the element's own value; terms of edges cancel between neighbours only",
           "errata.md#the-curl-form"},
    Defect{"few_digits", "It keeps fewer digits than double has, everywhere.",
           "relative errors are much alike in all regimes, and above what rounding explains",
           "look for constants or variables in single precision, and for tolerances", "errors.md#conditioned-error"},
    Defect{"chord_for_distance", "On a face, chords of the unit sphere stand where distances belong.",
           "points on faces get the weights of chords; inside the cage all is right",
           "take the distances of the corners from the point: there the weights are the barycentric ones",
           "evaluations.md#what-goes-wrong"},
    Defect{"wrong_on_cage", "Points on the cage get wrong coordinates, and points inside right ones.",
           "fails at vertices, edges or faces exactly", "interpolate there: the face's barycentric coordinates",
           "checks.md#checks-of-cages"},
    Defect{"wrong_gradient", "The gradient is not that of the value.", "gradients fail everywhere, and values hold",
           "compare with differences of the value", "checks.md#checks-of-elements"},
    Defect{"absolute_threshold", "The result depends on the unit of length: something is compared with a fixed number.",
           "a wrong result becomes right when all coordinates are multiplied by a power of two",
           "compare with a length of the element, or with nothing: signs can be exact",
           "porting.md#what-to-take-along"},
    Defect{"log_next_to_edge", "log((R + d)/(R - d)) loses its digits next to an edge.",
           "relative errors grow as the distance from an edge falls, and nowhere else",
           "form R - d as the squared distance over R + d, or take 2 atanh(d/R) with R from that",
           "porting.md#what-to-take-along"},
    Defect{"vertex_for_edge", "A point on an edge gets the result of a corner.",
           "on an edge the result equals that at a corner",
           "test the distance from the corner, not from an edge's line", "checks.md#where-a-limit-must-exist"},
    Defect{"plane_branch", "In the plane outside the element the angle is on the wrong branch.",
           "off by a share of the jump, exactly in the plane and nowhere near it",
           "take atan2 of determinant and denominator: its branch is right without a case",
           "evaluations.md#what-goes-wrong"},
    Defect{"zero_on_face", "On the face it gives the mean of both sides.",
           "half of the jump is missing exactly on the face", "give the limit from inside, or say which is meant",
           "errors.md#truth"},
    Defect{"outer_limit_on_face", "On the face it gives the limit from outside.",
           "the whole jump is missing exactly on the face", "give the limit from inside, or say which is meant",
           "errors.md#truth"},
    Defect{"far_cancellation", "Digits cancel far from the element.",
           "conditioned errors grow with a power of the distance",
           "far away take a rule of few points, or a form without cancellation", "porting.md#when-to-switch"},
    Defect{"sliver_cancellation", "Digits cancel on slivers and needles.",
           "conditioned errors grow with a power of one over the aspect",
           "form heights and areas from differences of coordinates, with the shortest edges",
           "evaluations.md#what-goes-wrong"},
    Defect{"plane_cancellation", "Digits cancel near the element's plane, beside the element.",
           "relative errors grow with a power of one over the height, beyond what the input's rounding costs",
           "form the height once, as a product of differences, and keep it as a factor", "errors.md#conditioned-error"},
    Defect{"projected_into_face", "A point near the plane is treated as if it were in the plane.",
           "the result equals that of the point's foot in the plane", "keep the height: it decides values and signs",
           "evaluations.md#what-goes-wrong"},
    Defect{"nan_at_vertex", "It is not finite at a corner, or next to it, where a limit exists.",
           "not finite within 1e-6 sizes of a corner", "leave out the terms whose factor vanishes there",
           "checks.md#where-a-limit-must-exist"},
    Defect{"nan_at_edge", "It is not finite on an edge, or next to it, where a limit exists.",
           "not finite within 1e-6 sizes of an edge", "leave out the terms whose factor vanishes there",
           "checks.md#where-a-limit-must-exist"},
    Defect{"nan_at_face", "It is not finite on the face, or next to it, where a limit exists.",
           "not finite within 1e-6 sizes of the face", "divide by no height; the limit from inside has a closed form",
           "checks.md#where-a-limit-must-exist"},
    Defect{"wrong_values", "It is wrong, by none of the causes that have a name.",
           "a result fails that no row above explains", "look at the input below", "errors.md#regimes"}};

}  // namespace

std::span<const Defect> defects() { return kDefects; }

const Defect& defect_named(std::string_view key) {
  for (const Defect& defect : kDefects)
    if (defect.key == key) return defect;
  throw InputError(fmt::format("no defect is named {}: docs/defects.md lists all", key));
}

}  // namespace cageproof::judge
