// SPDX-License-Identifier: MIT
#include "cageproof/core/coordinates/purposes.h"

#include <algorithm>
#include <array>
#include <utility>

namespace cageproof {
namespace {

using KindPurpose = std::pair<std::string_view, std::string_view>;

constexpr std::array kind_purposes{
    KindPurpose{"mean_value", "one number per vertex, quick; meets the posed cage; may be negative in concave cages"},
    KindPurpose{"quad_mean_value", "mean_value of the cage's own quads, whose symmetry stays"},
    KindPurpose{"spherical_mean_value",
                "mean_value in which quads stay whole, by polygons on a sphere about the point"},
    KindPurpose{"maximum_entropy", "one number per vertex, never negative; one iteration per point"},
    KindPurpose{"positive_mean_value",
                "mean_value of what a point sees of the cage, never negative; kinks where faces begin to hide others"},
    KindPurpose{"green", "details keep their angles; takes normals, too; leaves the posed cage"},
    KindPurpose{"quad_green", "green of the cage's own quads, whose symmetry stays"},
    KindPurpose{"cauchy", "green of the plane, as one complex number per vertex"},
    KindPurpose{"biharmonic", "the four layers that biharmonic deformers are made of, for data of one's own"},
    KindPurpose{"biharmonic_affine", "biharmonic with normal derivatives that vary within a face"},
    KindPurpose{"quad_biharmonic", "biharmonic of the cage's own quads"},
    KindPurpose{"somigliana", "elastic bodies: one matrix per vertex and per face, with Poisson's ratio nu"},
    KindPurpose{"quad_somigliana", "somigliana of the cage's own quads"},
    KindPurpose{"regularised_1_3", "smooth, and nearer to the posed cage than green; a system is solved once per cage"},
    KindPurpose{"regularised_1_2", "regularised_1_3 from values and normal derivatives, for comparison"},
    KindPurpose{"regularised_weber", "regularised_1_3 from the Laplacian's own identity, for comparison"},
    KindPurpose{"harmonic", "meets the cage, never negative; a system is solved once per cage"},
    KindPurpose{"elastic", "an elastic body that meets the cage; one matrix per vertex, by nu; solved"},
    KindPurpose{"biharmonic_boundary", "meets values and normal derivatives on the polygon's border; solved"},
    KindPurpose{"biharmonic_complex",
                "biharmonic_boundary with normals stretched as edges are, as one complex number per vertex"},
    KindPurpose{"triharmonic_boundary",
                "meets values, normal derivatives and Laplacians on the polygon's border; solved"},
    KindPurpose{"harmonic_goursat", "the true harmonic coordinates, to measure harmonic with; slow, small polygons"},
    KindPurpose{"biharmonic_goursat", "the true biharmonic coordinates, to measure biharmonic_boundary with; slow"},
};

}  // namespace

std::string_view purpose_of_kind(std::string_view kind) {
  const auto found = std::ranges::find(kind_purposes, kind, &KindPurpose::first);
  return found == kind_purposes.end() ? std::string_view() : found->second;
}

}  // namespace cageproof
