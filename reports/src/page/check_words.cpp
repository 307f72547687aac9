// SPDX-License-Identifier: MIT
#include "check_words.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <utility>

namespace cageproof::reports {
namespace {

using Words = std::pair<std::string_view, std::string_view>;

constexpr std::array kWords{
    Words{"truth", "the result and the truth"},
    Words{"relative", "the result and the truth: relative error, norm-wise"},
    Words{"digits", "the result and the truth: relative error, whatever the conditioning"},
    Words{"integral", "the closed form in multiprecision and the integral in the definition"},
    Words{"limit", "the closed form on the element and the limit from inside"},
    Words{"enclosure", "the closed form in multiprecision and a rigorous enclosure of the integral"},
    Words{"stated_error", "the error that an evaluation states itself and its real one"},
    Words{"scaling", "results of the input and of the input in another unit of length"},
    Words{"rigid_motion", "results of the input and of the input turned"},
    Words{"corner_permutation", "results from one corner on and from the next one on"},
    Words{"orientation_flip", "results of the element and of the element reversed"},
    Words{"laplacian", "the trace of the Hessian and what it must be"},
    Words{"subdivision", "the element and the sum of its four parts"},
    Words{"side_relation", "a double layer's moments and integrals along the element's sides"},
    Words{"hull_jump", "both sides of a twisted quad's hull, across which weights are continuous"},
    Words{"gradient_by_differences", "derivatives and differences of the order below"},
    Words{"face_jump", "the step across a face and the one that the kernel has"},
    Words{"partition_of_unity", "the sum of the vertices' coordinates and one"},
    Words{"zero_outside", "the sum of the vertices' coordinates outside and zero"},
    Words{"linear_reproduction", "the vertices, weighted by their coordinates, and the point"},
    Words{"non_negativity", "how far below zero the least coordinate of a vertex is"},
    Words{"limit_from_inside", "coordinates on the cage and just inside of it"},
    Words{"cage_scaling", "coordinates in the cage and in the cage in another unit of length"},
    Words{"cage_rigid_motion", "coordinates in the cage and in the cage turned"},
    Words{"cage_corner_permutation", "coordinates with faces from one corner on and from the next one on"},
    Words{"cage_subdivision", "coordinates in the cage and in the cage with each face split in four"},
    Words{"cage_differences", "derivatives and differences of the order below"},
    Words{"cage_laplacian", "the traces of the coordinates' Hessians and what they must be"},
    Words{"boundary_residual", "coordinates next to the edges and the data that they were solved for"},
    Words{"second_route", "values and those from the definition by code that shares nothing with the first"},
    Words{"scheme_error", "a scheme's coordinates and those that it approximates"},
    Words{"boundary_data", "coordinates on the cage and the data that they are to have there"},
    Words{"cage_truth", "all coordinates of a kind and the closed form in 50 digits"},
    Words{"rest_derivative", "products with derivatives by the cage's vertices and differences of coordinates"},
    Words{"rest_derivative_transposed", "products with derivatives by the cage's vertices in both directions"},
    Words{"cage_block_error",
          "all coordinates of a block (those of the vertices, or of the faces) and the closed form in 50 digits, in "
          "units of what rounding the cage and the point costs a block"},
    Words{"own_derivative", "each triangle's derivatives and the truth of that triangle"},
    Words{"one_ring_sum", "a vertex's derivatives, summed over its triangles, and the truth of the sum"},
    Words{"one_ring_sum_small_faces", "the same in a cage with faces below some 3e-4 of its size"},
    Words{"keeps_rigid", "images under a shift, a turn and the identity and those of the map itself"},
    Words{"keeps_scale", "images under a uniform scale and those of the map itself"},
    Words{"keeps_mirror", "images under a reversed axis and those of the map itself"},
    Words{"keeps_linear", "images under a linear map and those of the map itself"},
    Words{"keeps_linear_with_normals", "the same where the pose's normals are the map's"},
    Words{"keeps_offset", "images of the cage far from the origin and at it"},
    Words{"keeps_symmetry", "images of mirrored points and mirrored images, under a symmetric pose"},
    Words{"keeps_symmetry_of_quads", "the same where the quads are symmetric and the triangles they are split in not"},
    Words{"deformer_truth", "images and derivatives in double and in 50 digits"},
    Words{"deformer_jacobian", "derivatives of images and differences of images"},
    Words{"pose_derivative", "products with derivatives by posed vertices and differences of images"},
    Words{"pose_derivative_in_double", "the same with differences in double"},
    Words{"pose_derivative_transposed", "products with derivatives by posed vertices in both directions"},
    Words{"deformer_by_quadrature", "images and those made by adaptive quadrature"},
    Words{"energy_falls", "the energy after each step and before it"},
    Words{"rigid_energy", "the energy that rigidly moved targets leave and none"},
    Words{"energy_is_flat", "the energy's gradient after the first step and before it"},
    Words{"constrained_unit", "images in one unit of length and in another"},
    Words{"constrained_motion", "images of what is turned and shifted and those of the rest, turned and shifted"},
};

}  // namespace

std::string_view words_of_check(std::string_view check) {
  const auto* found = std::ranges::find(kWords, check, &Words::first);
  return found == kWords.end() ? std::string_view() : found->second;
}

std::string breakable(std::string_view name) {
  std::string html;
  for (const char c : name) {
    switch (c) {
      case '<': html += "&lt;"; break;
      case '>': html += "&gt;"; break;
      case '&': html += "&amp;"; break;
      case '"': html += "&quot;"; break;
      case '\'': html += "&apos;"; break;
      case '_':
      case '.': html += fmt::format("{}<wbr>", c); break;
      default: html += c;
    }
  }
  return html;
}

}  // namespace cageproof::reports
