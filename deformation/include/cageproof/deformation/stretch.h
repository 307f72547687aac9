// SPDX-License-Identifier: MIT
// How much the elements of a posed cage are stretched, and their normals.
#pragma once

#include "cageproof/core/cage/cage_elements.h"
#include "cageproof/core/numbers/linear.h"
#include "cageproof/deformation/deformer.h"

#include <string_view>
#include <vector>

namespace cageproof::deformation {

/// The factor of the posed unit normal, from the singular values s1 >= s2 of the linear map from the rest element to
/// the posed one: sqrt((s1^2 + s2^2)/2) (Lipman et al. 2008), (s1 + s2)/2, sqrt(s1 s2), one, or s1 s2. Segments take
/// their one singular value, or one. On a bilinear quad the singular values differ from point to point, and their mean
/// with a corner's basis function multiplies the corner's posed normal (quad_normals.h).
enum class Stretch { Rms, Mean, Area, Unit, Product };

/// The names of the first four, in that order: "rms", "mean", "area", "unit".
const std::vector<std::string_view>& stretch_names();

/// The names of all five, of deformers that keep quads; the fifth is "product".
const std::vector<std::string_view>& quad_stretch_names();

/// The rest vertices in another scalar, exactly.
template <Scalar R>
std::vector<Vec3<R>> vertices_in(const CageElements& rest);

/// The vectors that span an element whose vertices are elsewhere: of a segment the edge and the axis across the plane,
/// of a triangle the edges from its first corner. Of a quad its derivatives by u and v, u and v counted from a corner,
/// at (1/3, 1/3): their means over the quad, weighted with the corner's basis function.
template <Scalar R>
std::array<Vec3<R>, 2> tangents_of(const CageElements& rest, const std::vector<Vec3<R>>& vertices, std::size_t element,
                                   int corner = 0);

/// The unit normal of an element whose vertices are elsewhere: across its tangents.
/// \param corner of a quad, next to which the normal is; of no meaning for flat elements
/// \throws InputError for an element without length or area
template <Scalar R>
Vec3<R> posed_normal(const CageElements& rest, const std::vector<Vec3<R>>& vertices, std::size_t element,
                     int corner = 0);

/// The stretch of the linear map that takes an element's tangents to the posed ones.
/// \param corner as of posed_normal
template <Scalar R>
R stretch_of(Stretch stretch, const CageElements& rest, const std::vector<Vec3<R>>& vertices, std::size_t element,
             int corner = 0);

/// One row per normal (Owner::Normal): for a flat element its posed unit normal times its stretch, for a quad's corner
/// the result of quad_normals(). Elements without area are an error that names them, unless the stretch is Area or
/// Product, which take them for zero.
template <Scalar R>
std::vector<Vec3<R>> stretched_normals(Stretch stretch, const CageElements& rest, const std::vector<Vec3<R>>& vertices);

/// The owner of a pose's normal derivative: an element, an element's corner if derivatives are affine, or, if quads are
/// kept, a normal.
Owner normals_owner(const CageCoordinates& coordinates);

/// The owner of normal derivatives in messages, as many: "elements", "corners of elements", "corners of quads, and
/// triangles".
std::string_view plural_of(Owner normals);

/// \param normals what there is a normal derivative for: normals_owner()
/// \throws InputError unless there are as many vertices as the rest cage has, and of other data none, or a row a
/// vertex, element or normal derivative, all finite; names the row
template <Scalar R>
void check_pose(const CageElements& rest, const Pose<R>& pose, Owner normals = Owner::Element);

}  // namespace cageproof::deformation
