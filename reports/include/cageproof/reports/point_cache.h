// SPDX-License-Identifier: MIT
// Point caches: the places of one mesh's vertices in many frames, in one file, as modelling programs read them.
#pragma once

#include "cageproof/core/numbers/vector.h"

#include <string>
#include <vector>

namespace cageproof::reports {

struct CacheFrame {
  std::string name;                    ///< for messages: the file that the frame is made from
  std::vector<Vec3<double>> vertices;  ///< in the mesh's order
};

struct PointCache {
  std::string bytes;
  bool rounded = false;  ///< whether single precision holds some place only rounded
};

/// PC2, little endian: 32 bytes of header, then the frames in single precision. The first frame is number 1, and
/// frames follow at one sample per frame.
/// \pre there is a frame
/// \throws InputError naming the frame, where one has another number of vertices than the first, or a place beyond
/// single precision; and for more frames or vertices than 31 bits count
PointCache pc2_of(const std::vector<CacheFrame>& frames);

/// MDD, big endian: the numbers of frames and of vertices, the frames' times in seconds, then the frames in single
/// precision.
/// \param rate frames per second, from time 0 on; positive \pre there is a frame \throws InputError as pc2_of
PointCache mdd_of(const std::vector<CacheFrame>& frames, double rate);

}  // namespace cageproof::reports
