// SPDX-License-Identifier: MIT
// Compiles every plain closed form where nothing is to be had but the standard library and Eigen: forbidden/ has, for
// every header that a plain form is not to take, one that is an error, and floats that become doubles are errors too.
#include "cageproof/closed_form/segment/affine_single_layer.h"
#include "cageproof/closed_form/segment/biharmonic_double_layer.h"
#include "cageproof/closed_form/segment/biharmonic_single_layer.h"
#include "cageproof/closed_form/segment/double_layer.h"
#include "cageproof/closed_form/segment/engine/plain.h"
#include "cageproof/closed_form/segment/kelvin_displacement.h"
#include "cageproof/closed_form/segment/kelvin_traction.h"
#include "cageproof/closed_form/segment/mean_value.h"
#include "cageproof/closed_form/segment/polyharmonic_double_layer.h"
#include "cageproof/closed_form/segment/polyharmonic_single_layer.h"
#include "cageproof/closed_form/segment/single_layer.h"
#include "cageproof/closed_form/segment/winding_angle.h"
#include "cageproof/closed_form/triangle/affine_single_layer.h"
#include "cageproof/closed_form/triangle/biharmonic_double_layer.h"
#include "cageproof/closed_form/triangle/biharmonic_single_layer.h"
#include "cageproof/closed_form/triangle/double_layer.h"
#include "cageproof/closed_form/triangle/engine/plain.h"
#include "cageproof/closed_form/triangle/kelvin_displacement.h"
#include "cageproof/closed_form/triangle/kelvin_traction.h"
#include "cageproof/closed_form/triangle/mean_value.h"
#include "cageproof/closed_form/triangle/single_layer.h"
#include "cageproof/closed_form/triangle/solid_angle.h"

namespace cageproof::closed_form {

#define CAGEPROOF_PLAIN(Formula)                                                                     \
  template Jet<float, segment::Formula::components, 2> segment::plain<segment::Formula, 2, float>(   \
      const Segment<float>&, const Vec3<float>&, std::span<const float>, bool);                      \
  template Jet<double, segment::Formula::components, 2> segment::plain<segment::Formula, 2, double>( \
      const Segment<double>&, const Vec3<double>&, std::span<const double>, bool);
CAGEPROOF_PLAIN(AffineSingleLayer)
CAGEPROOF_PLAIN(BiharmonicDoubleLayer)
CAGEPROOF_PLAIN(BiharmonicSingleLayer)
CAGEPROOF_PLAIN(DoubleLayer)
CAGEPROOF_PLAIN(KelvinDisplacement)
CAGEPROOF_PLAIN(KelvinTraction)
CAGEPROOF_PLAIN(MeanValue)
CAGEPROOF_PLAIN(PolyharmonicDoubleLayer)
CAGEPROOF_PLAIN(PolyharmonicSingleLayer)
CAGEPROOF_PLAIN(SingleLayer)
CAGEPROOF_PLAIN(WindingAngle)
#undef CAGEPROOF_PLAIN

#define CAGEPROOF_PLAIN(Formula)                                                                     \
  template Jet<float, triangle::Formula::components> triangle::plain<triangle::Formula, 2, float>(   \
      const Triangle<float>&, const Vec3<float>&, std::span<const float>, bool);                     \
  template Jet<double, triangle::Formula::components> triangle::plain<triangle::Formula, 2, double>( \
      const Triangle<double>&, const Vec3<double>&, std::span<const double>, bool);
CAGEPROOF_PLAIN(AffineSingleLayer)
CAGEPROOF_PLAIN(BiharmonicDoubleLayer)
CAGEPROOF_PLAIN(BiharmonicSingleLayer)
CAGEPROOF_PLAIN(DoubleLayer)
CAGEPROOF_PLAIN(KelvinDisplacement)
CAGEPROOF_PLAIN(KelvinTraction)
CAGEPROOF_PLAIN(MeanValue)
CAGEPROOF_PLAIN(SingleLayer)
CAGEPROOF_PLAIN(SolidAngle)
#undef CAGEPROOF_PLAIN

}  // namespace cageproof::closed_form
