// SPDX-License-Identifier: MIT
// The regimes' makers for bilinear quads.
#pragma once

#include "cageproof/core/random_stream.h"
#include "cageproof/validation/sample.h"

namespace cageproof::validation::quad {

void generic(double, RandomStream& random, Sample& sample);
void near_face(double distance, RandomStream& random, Sample& sample);
void near_plane(double distance, RandomStream& random, Sample& sample);
void near_edge(double distance, RandomStream& random, Sample& sample);
void near_line(double distance, RandomStream& random, Sample& sample);
void near_vertex(double distance, RandomStream& random, Sample& sample);
void on_face(double, RandomStream& random, Sample& sample);
void on_edge(double, RandomStream& random, Sample& sample);
void on_vertex(double, RandomStream& random, Sample& sample);
void on_plane(double, RandomStream& random, Sample& sample);
void on_line(double, RandomStream& random, Sample& sample);
void far(double distance, RandomStream& random, Sample& sample);
void sliver(double height, RandomStream& random, Sample& sample);
void needle(double width, RandomStream& random, Sample& sample);
void scaled(double unit, RandomStream& random, Sample& sample);
void offset(double distance, RandomStream& random, Sample& sample);

}  // namespace cageproof::validation::quad
