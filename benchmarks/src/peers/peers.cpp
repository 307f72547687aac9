// SPDX-License-Identifier: MIT
#include "peers.h"

namespace cageproof::benchmarks {

const std::vector<Peer>& peers() {
  static const std::vector<Peer> all{
      {"green", "edges", "Van Oosterom and Strackee 1983; Graglia 1993", 3, green_by_edges},
      {"mean_value", "angles", "Ju, Schaefer and Warren 2005", 3, mean_value_by_angles},
      {"mean_value", "vtk", "VTK's vtkMeanValueCoordinatesInterpolator", 3, mean_value_by_vtk},
      {"green", "edges", "Lipman, Levin and Cohen-Or 2008", 2, plane_green_by_edges},
      {"mean_value", "tangents", "Hormann and Floater 2006", 2, plane_mean_value_by_tangents},
      {"cauchy", "logarithms", "Weber, Ben-Chen and Gotsman 2009", 2, cauchy_by_logarithms},
  };
  return all;
}

}  // namespace cageproof::benchmarks
