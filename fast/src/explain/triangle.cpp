// SPDX-License-Identifier: MIT
#include "triangle.h"

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

}  // namespace cageproof::fast::triangle
