// SPDX-License-Identifier: MIT
#include "triangle.h"

#include "cageproof/closed_form/triangle/affine_single_layer.h"
#include "cageproof/closed_form/triangle/biharmonic_double_layer.h"
#include "cageproof/closed_form/triangle/biharmonic_single_layer.h"
#include "cageproof/closed_form/triangle/double_layer.h"
#include "cageproof/closed_form/triangle/kelvin_displacement.h"
#include "cageproof/closed_form/triangle/kelvin_traction.h"
#include "cageproof/closed_form/triangle/mean_value.h"
#include "cageproof/closed_form/triangle/single_layer.h"
#include "cageproof/closed_form/triangle/solid_angle.h"

namespace cageproof::fast::triangle {
namespace {

const RegisterExplainer explainers[] = {
    {"triangle.single_layer", &explain_form<SingleLayer>},
    {"triangle.double_layer", &explain_form<DoubleLayer>},
    {"triangle.solid_angle", &explain_form<SolidAngle>},
    {"triangle.biharmonic_single_layer", &explain_form<BiharmonicSingleLayer>},
    {"triangle.biharmonic_double_layer", &explain_form<BiharmonicDoubleLayer>},
    {"triangle.affine_single_layer", &explain_form<AffineSingleLayer>},
    {"triangle.kelvin_displacement", &explain_form<KelvinDisplacement>},
    {"triangle.kelvin_traction", &explain_form<KelvinTraction>},
    {"triangle.mean_value", &explain_form<MeanValue>},
};

}  // namespace
}  // namespace cageproof::fast::triangle
