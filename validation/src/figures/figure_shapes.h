// SPDX-License-Identifier: MIT
// Cages, poses and meshes of figures, made in code.
#pragma once

#include "cageproof/core/cage/cage.h"
#include "cageproof/core/cage/mesh_io.h"

namespace cageproof::validation {

/// A mesh whose faces have one of two colours, so that a picture shows how they are stretched.
struct TonedMesh {
  Mesh mesh;
  std::vector<char> tones;  ///< a face each
};

/// The surface of a box around the origin, in squares of about `step`, its edges rounded by that radius. Exactly
/// symmetric in each axis.
TonedMesh rounded_box(const Vec3<double>& half, double radius, double step);

/// The rectangle [0, width] x [0, height] of the plane in squares of `step`, its border included. Its middle line along
/// x is drawn: there is an even number of squares across.
TonedMesh grid(double width, double height, double step);

/// A bar of square sections along z: rings (+-1/2, +-1/2, z) at z = -1, -1/2, ... 1, with quads between and at its
/// ends.
Cage bar_cage();

/// Points bent in the plane of x and z to an arc of so many radians; z = -1 to 1 gets `length` times as long at x = 0.
std::vector<Vec3<double>> bent_about_y(std::vector<Vec3<double>> points, double angle, double length = 1);

/// The bar, bent so.
std::vector<Vec3<double>> bent_bar(double angle, double length);

/// The bar twisted by a quarter turn: the embedded cage twisted-bar.
std::vector<Vec3<double>> twisted_bar_pose();

/// The polygon [0, 6] x [0, 2], its edges of length one.
Cage plane_bar();

/// Points of the plane after the bar is bent downwards to an arc of so many radians; its middle line keeps its length.
Vec3<double> bent_in_plane(const Vec3<double>& point, double angle);

}  // namespace cageproof::validation
