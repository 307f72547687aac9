// SPDX-License-Identifier: MIT
// A series of VTK files as one, which ParaView shows over time.
#pragma once

#include <string>
#include <vector>

namespace cageproof::reports {

struct TimeStep {
  double time;
  std::string file;  ///< from the folder of the .pvd on
};

/// The text of a .pvd file. \throws InputError for names that XML cannot hold: with control characters, or not UTF-8
std::string pvd_text(const std::vector<TimeStep>& steps);

}  // namespace cageproof::reports
