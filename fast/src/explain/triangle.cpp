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

std::string description_of(Route route, const Panels& panels, bool is_kept) {
  if (route == Route::Panels) {
    int points = 0;
    for (const Panel& panel : panels) points += panel.across * panel.along;
    return "far form in double, " + std::to_string(points) + " Gauss points on " + std::to_string(panels.size()) +
           (panels.size() == 1 ? " panel" : " panels") +
           (is_kept ? "" : ", summed one by one here and in vectors there");
  }
  if (route == Route::Near) return "near form in double";
  if (route == Route::Tracked) return "near form in double, within the bound of its error";
  if (route == Route::Border) return "closed form with its limits, since the point is on the border";
  return is_kept ? "near form in double, within the bound of its error, as the closed form takes it"
                 : "near form in more digits, since in double the bound of its error was too large";
}

namespace {

const RegisterExplainer explainers[] = {
    {"triangle.single_layer", "hybrid", &explain_form<SingleLayer>},
    {"triangle.double_layer", "hybrid", &explain_form<DoubleLayer>},
    {"triangle.solid_angle", "hybrid", &explain_form<SolidAngle>},
    {"triangle.biharmonic_single_layer", "hybrid", &explain_form<BiharmonicSingleLayer>},
    {"triangle.biharmonic_double_layer", "hybrid", &explain_form<BiharmonicDoubleLayer>},
    {"triangle.affine_single_layer", "hybrid", &explain_form<AffineSingleLayer>},
    {"triangle.kelvin_displacement", "hybrid", &explain_form<KelvinDisplacement>},
    {"triangle.kelvin_traction", "hybrid", &explain_form<KelvinTraction>},
    {"triangle.mean_value", "hybrid", &explain_form<MeanValue>},
};

}  // namespace
}  // namespace cageproof::fast::triangle
