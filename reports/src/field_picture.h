// SPDX-License-Identifier: MIT
// Pictures of fields. A slice becomes a heat map, a mesh becomes coloured points seen from two sides.
#pragma once

#include "colours.h"
#include "gnuplot.h"

namespace cageproof::reports {

/// The slice (of a volume the middle one along z) with axes and a colour bar.
Picture image_picture(const ImageField& field, const Colours& colours, const std::string& title, std::string file,
                      const MeshField* outline = nullptr);

/// The vertices seen from the front (along -z, y up) and from the side (along -x), near ones over far ones.
Picture mesh_picture(const MeshField& field, const Colours& colours, const std::string& title, std::string file);

}  // namespace cageproof::reports
