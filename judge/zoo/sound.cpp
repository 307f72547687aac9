// SPDX-License-Identifier: MIT
// The sound forms of the formulas that the zoo has: closed forms in double.
#include "zoo.h"

#include "cageproof/closed_form/segment/double_layer.h"
#include "cageproof/closed_form/segment/engine/plain.h"
#include "cageproof/closed_form/segment/mean_value.h"
#include "cageproof/closed_form/segment/single_layer.h"
#include "cageproof/closed_form/triangle/double_layer.h"
#include "cageproof/closed_form/triangle/engine/plain.h"
#include "cageproof/closed_form/triangle/kelvin_displacement.h"
#include "cageproof/closed_form/triangle/kelvin_traction.h"
#include "cageproof/closed_form/triangle/mean_value.h"
#include "cageproof/closed_form/triangle/single_layer.h"
#include "cageproof/closed_form/triangle/solid_angle.h"

#include <string_view>

namespace cageproof::zoo {
namespace {

Vec3<double> vector_at(const double* x) { return {x[0], x[1], x[2]}; }

template <class Jet>
void store(const Jet& jet, const zoo_call& call, std::size_t p) {
  const std::size_t components = jet.value.size(), dim = static_cast<std::size_t>(jet.gradient[0].size());
  for (std::size_t c = 0; c < components; ++c) {
    call.values[p * components + c] = jet.value[c];
    for (std::size_t i = 0; i < dim && call.order > 0; ++i)
      call.gradients[(p * components + c) * dim + i] = jet.gradient[c][static_cast<Eigen::Index>(i)];
  }
}

template <class F>
void on_triangle(const zoo_call& call) {
  const Triangle<double> t{vector_at(call.corners), vector_at(call.corners + 3), vector_at(call.corners + 6)};
  const std::span<const double> parameters(call.parameters, F::parameter_count);
  for (std::size_t p = 0; p < call.count; ++p)
    store(closed_form::triangle::plain<F, 1, double>(t, vector_at(call.points + 3 * p), parameters), call, p);
}

template <class F>
void on_segment(const zoo_call& call) {
  const Segment<double> s{vector_at(call.corners), vector_at(call.corners + 3)};
  for (std::size_t p = 0; p < call.count; ++p)
    store(closed_form::segment::plain<F, 1, double>(s, vector_at(call.points + 3 * p)), call, p);
}

struct Member {
  std::string_view formula;
  int components;
  void (*sound)(const zoo_call&);
};

constexpr std::array kMembers{
    Member{"triangle.solid_angle", 1, on_triangle<closed_form::triangle::SolidAngle>},
    Member{"triangle.single_layer", 1, on_triangle<closed_form::triangle::SingleLayer>},
    Member{"triangle.double_layer", 3, on_triangle<closed_form::triangle::DoubleLayer>},
    Member{"triangle.mean_value", 3, on_triangle<closed_form::triangle::MeanValue>},
    Member{"triangle.kelvin_displacement", 9, on_triangle<closed_form::triangle::KelvinDisplacement>},
    Member{"triangle.kelvin_traction", 27, on_triangle<closed_form::triangle::KelvinTraction>},
    Member{"segment.single_layer", 1, on_segment<closed_form::segment::SingleLayer>},
    Member{"segment.double_layer", 2, on_segment<closed_form::segment::DoubleLayer>},
    Member{"segment.mean_value", 2, on_segment<closed_form::segment::MeanValue>}};

const Member* find(std::string_view formula) {
  for (const Member& member : kMembers)
    if (member.formula == formula) return &member;
  return nullptr;
}

}  // namespace
}  // namespace cageproof::zoo

int zoo_components(const char* formula) {
  const auto* member = cageproof::zoo::find(formula);
  return member == nullptr ? 0 : member->components;
}

int zoo_dimension(const char* formula) { return std::string_view(formula).starts_with("segment") ? 2 : 3; }

void zoo_sound(const zoo_call* call) {
  if (const auto* member = cageproof::zoo::find(call->formula)) member->sound(*call);
}
