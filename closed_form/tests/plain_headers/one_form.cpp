// SPDX-License-Identifier: MIT
// The example of docs/porting.md.
#include "cageproof/closed_form/triangle/double_layer.h"
#include "cageproof/closed_form/triangle/engine/plain.h"

using namespace cageproof;
std::array<float, 3> weights(const Triangle<float>& t, const Vec3<float>& point) {
  return closed_form::triangle::plain<closed_form::triangle::DoubleLayer, 0>(t, point).value;
}
