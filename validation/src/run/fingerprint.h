// SPDX-License-Identifier: MIT
// Tells inputs apart that have the same name.
#pragma once

#include "cageproof/core/cage/mesh_io.h"

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace cageproof::validation {

/// FNV-1a of numbers and texts.
class Fingerprint {
 public:
  void add(std::uint64_t word) {
    hash_ = (hash_ ^ word) * 1099511628211U;
    hash_ ^= hash_ >> 32;
  }
  void add(const std::vector<Vec3<double>>& points);
  void add(std::string_view text);
  /// Sixteen hexadecimal digits.
  std::string text() const;

 private:
  std::uint64_t hash_ = 14695981039346656037U;
};

/// Fingerprint of the vertices, bit for bit, and of the faces, in their order.
std::string fingerprint_of(const Cage& cage);
std::string fingerprint_of(const Mesh& mesh);

/// The name that a cage's samples are drawn by: its own where it is embedded, else its fingerprint, so that a file is
/// judged alike wherever it lies.
std::string drawn_by(const Cage& cage);

}  // namespace cageproof::validation
