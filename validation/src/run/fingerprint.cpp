// SPDX-License-Identifier: MIT
#include "run/fingerprint.h"

#include "cageproof/core/cage/embedded_cages.h"

#include <fmt/format.h>

#include <algorithm>
#include <bit>

namespace cageproof::validation {

void Fingerprint::add(const std::vector<Vec3<double>>& points) {
  add(points.size());
  for (const auto& p : points)
    for (int c = 0; c < 3; ++c) add(std::bit_cast<std::uint64_t>(p[c]));
}

void Fingerprint::add(std::string_view text) {
  add(text.size());
  for (const char c : text) add(static_cast<std::uint64_t>(static_cast<unsigned char>(c)));
}

std::string Fingerprint::text() const { return fmt::format("{:016x}", hash_); }

std::string fingerprint_of(const Cage& cage) {
  Fingerprint print;
  print.add(cage.vertices());
  for (const Face& face : cage.faces())
    for (const int v : face.vertices) print.add(static_cast<std::uint64_t>(v) + 1);
  return print.text();
}

std::string drawn_by(const Cage& cage) {
  for (const auto& names : {embedded_cage_names(), extreme_cage_names()})
    if (std::ranges::find(names, cage.name()) != names.end()) return cage.name();
  return fingerprint_of(cage);
}

std::string fingerprint_of(const Mesh& mesh) {
  Fingerprint print;
  print.add(mesh.vertices);
  for (const auto& face : mesh.faces) {
    print.add(face.size());
    for (const int v : face) print.add(static_cast<std::uint64_t>(v));
  }
  return print.text();
}

}  // namespace cageproof::validation
