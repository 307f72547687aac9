// SPDX-License-Identifier: MIT
// How much the elements of a posed cage are stretched, and their normals.
#pragma once

#include "cageproof/core/cage_elements.h"
#include "cageproof/core/linear.h"
#include "cageproof/deformation/deformer.h"

#include <string_view>
#include <vector>

namespace cageproof::deformation {

/// What multiplies the posed unit normal, of the singular values s1 >= s2 of the linear map from the rest element to
/// the posed one: sqrt((s1^2 + s2^2)/2) (Lipman et al. 2008), (s1 + s2)/2, sqrt(s1 s2), or one. Of segments the one
/// singular value, or one.
enum class Stretch { Rms, Mean, Area, Unit };

/// Their names, in that order: "rms", "mean", "area", "unit".
const std::vector<std::string_view>& stretch_names();

/// The rest vertices in another scalar, exactly.
template <Scalar R>
std::vector<Vec3<R>> vertices_in(const CageElements& rest);

/// The unit normal of an element whose vertices are elsewhere.
/// \param owner names the posed cage in messages \throws InputError for an element without length or area
template <Scalar R>
Vec3<R> posed_normal(const CageElements& rest, const std::vector<Vec3<R>>& vertices, std::size_t element);

template <Scalar R>
R stretch_of(Stretch stretch, const CageElements& rest, const std::vector<Vec3<R>>& vertices, std::size_t element);

/// A row an element: its posed unit normal times its stretch. Elements without area are an error, unless the stretch is
/// Area, which takes them for zero.
template <Scalar R>
std::vector<Vec3<R>> stretched_normals(Stretch stretch, const CageElements& rest, const std::vector<Vec3<R>>& vertices);

/// What poses have a normal derivative for: an element, or a corner of one where they are affine.
Owner normals_owner(const CageCoordinates& coordinates);

/// \param normals what there is a normal derivative for: an element, or a corner of one
/// \throws InputError unless there are as many vertices as the rest cage has, and of other data none, or a row a
/// vertex, element or corner, all finite; names the row
template <Scalar R>
void check_pose(const CageElements& rest, const Pose<R>& pose, Owner normals = Owner::Element);

}  // namespace cageproof::deformation
