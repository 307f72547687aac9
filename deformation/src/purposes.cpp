// SPDX-License-Identifier: MIT
#include "cageproof/deformation/purposes.h"

#include <algorithm>
#include <array>
#include <utility>

namespace cageproof::deformation {
namespace {

using MethodPurpose = std::pair<std::string_view, std::string_view>;

constexpr std::array method_purposes{
    MethodPurpose{"mean_value", "a mesh that meets the posed cage; quick; details shear when the cage turns"},
    MethodPurpose{"quad_mean_value", "mean_value of a cage of quads, whose symmetry stays"},
    MethodPurpose{"spherical_mean_value",
                  "mean_value in which quads stay whole, by polygons on a sphere about the point"},
    MethodPurpose{"maximum_entropy",
                  "a mesh that meets the posed cage, no coordinate negative; one iteration per point"},
    MethodPurpose{"harmonic", "a drawing that meets the posed polygon, no coordinate negative"},
    MethodPurpose{"harmonic_goursat", "harmonic without a scheme's errors; slow, small polygons"},
    MethodPurpose{"green", "details keep their angles; the mesh leaves the posed cage"},
    MethodPurpose{"quad_green", "green of a cage of quads, whose symmetry stays"},
    MethodPurpose{"cauchy", "a drawing whose details keep their angles, as green"},
    MethodPurpose{"biharmonic_1_3", "smooth details, nearer to the posed cage than green; solved once per cage"},
    MethodPurpose{"quad_biharmonic_1_3", "biharmonic_1_3 of a cage of quads, whose symmetry stays"},
    MethodPurpose{"biharmonic_1_2", "biharmonic_1_3 from values and normal derivatives, for comparison"},
    MethodPurpose{"biharmonic_weber", "biharmonic_1_3 from the Laplacian's own identity, for comparison"},
    MethodPurpose{"biharmonic_direct", "biharmonic maps with Laplacians of one's own"},
    MethodPurpose{"biharmonic_boundary", "a smooth drawing that follows the posed polygon and its normals"},
    MethodPurpose{"biharmonic_goursat", "biharmonic_boundary that meets posed normals; slow, small polygons"},
    MethodPurpose{"ahap", "biharmonic_1_3 with normals stretched so that Laplacians are least"},
    MethodPurpose{"aaap", "biharmonic_1_3 with normals stretched so that second derivatives are least"},
    MethodPurpose{"tp", "biharmonic_1_3 with normals stretched so that second derivatives along normals are least"},
    MethodPurpose{"somigliana", "an elastic body that bulges or shrinks, by nu and gamma"},
    MethodPurpose{"elastic", "an elastic body that meets the posed cage, for small poses; solved"},
    MethodPurpose{"quad_somigliana", "somigliana of a cage of quads, whose symmetry stays"},
    MethodPurpose{"variational", "no posed cage: points are held, and the map has least energy"},
    MethodPurpose{"thickness", "no posed cage: points of a drawing are held, and its edges bend least"},
};

}  // namespace

std::string_view purpose_of_method(std::string_view method) {
  const auto found = std::ranges::find(method_purposes, method, &MethodPurpose::first);
  return found == method_purposes.end() ? std::string_view() : found->second;
}

}  // namespace cageproof::deformation
