// SPDX-License-Identifier: MIT
// Sound mean value coordinates of a cage: the sum of its triangles' weights, over their sum.
#include "sound.h"

#include <vector>

namespace cageproof::zoo {
namespace {

// One face's weights at a point, added; or, on the face, those of its corners only. Whether it is on the face.
bool add_face(const zoo_cage& cage, std::size_t f, const double* point, zoo_on_face on_face, double* weights) {
  const int* const face = cage.faces + 3 * f;
  std::array<double, 9> corners{};
  for (std::size_t k = 0; k < 9; ++k) corners[k] = cage.vertices[3 * static_cast<std::size_t>(face[k / 3]) + k % 3];
  std::array<double, 3> added{};
  const zoo_call call{"triangle.mean_value", corners.data(), nullptr, point, 1, 0, added.data(), nullptr};
  const Place at = place_of(call, 0);
  const bool on = at.in_plane && at.hat[0] >= 0 && at.hat[1] >= 0 && at.hat[2] >= 0;
  if (on) {
    for (std::size_t v = 0; v < cage.vertex_count; ++v) weights[v] = 0;
    added = at.hat;
    if (on_face != nullptr) on_face(corners.data(), point, at.hat.data(), added.data());
  } else {
    zoo_sound(&call);
  }
  for (std::size_t k = 0; k < 3; ++k) weights[face[k]] += added[k];
  return on;
}

}  // namespace
}  // namespace cageproof::zoo

void zoo_mean_value(const zoo_cage* cage, zoo_on_face on_face) {
  using namespace cageproof::zoo;
  for (std::size_t p = 0; p < cage->count; ++p) {
    double* const weights = cage->coordinates + p * cage->vertex_count;
    for (std::size_t v = 0; v < cage->vertex_count; ++v) weights[v] = 0;
    for (std::size_t f = 0; f < cage->face_count; ++f)
      if (add_face(*cage, f, cage->points + 3 * p, on_face, weights)) break;
    double sum = 0;
    for (std::size_t v = 0; v < cage->vertex_count; ++v) sum += weights[v];
    for (std::size_t v = 0; v < cage->vertex_count; ++v) weights[v] /= sum;
  }
}
