// SPDX-License-Identifier: MIT
#include "../conversions.h"
#include "guard.h"

#include <fmt/format.h>

#include <algorithm>

namespace {

using namespace cageproof::library;
using cageproof::InputError;

// A vertex that is not there is named where the cage is checked, as the C++ interface names it.
Cage cage_of(int dimension, std::span<const double> vertices, std::span<const int32_t> corners,
             std::span<const int32_t> sizes) {
  if (dimension != 2 && dimension != 3) throw InputError(fmt::format("cage: a dimension of {}, not 2 or 3", dimension));
  cageproof::library::check_multiple(vertices.size(), static_cast<std::size_t>(dimension), "vertices");
  Cage cage{{vertices.begin(), vertices.end()}, {}, dimension};
  std::size_t first = 0;
  for (std::size_t f = 0; f < sizes.size(); ++f) {
    const int32_t size = sizes[f];
    if (size < 0 || static_cast<std::size_t>(size) > corners.size() - first)
      throw InputError(
          fmt::format("faces: {} corners are too few for face {} (faces counted from 0)", corners.size(), f));
    const auto own = corners.subspan(first, static_cast<std::size_t>(size));
    cage.faces.emplace_back(own.begin(), own.end());
    first += own.size();
  }
  if (first != corners.size())
    throw InputError(fmt::format("faces: {} corners, and sizes that add up to {}", corners.size(), first));
  return cage;
}

std::size_t corners_in(const Cage& cage) {
  std::size_t sum = 0;
  for (const auto& face : cage.faces) sum += face.size();
  return sum;
}

}  // namespace

extern "C" {

int cageproof_cage_make(int dimension, const double* vertices, size_t vertices_size, const int32_t* corners,
                        size_t corners_size, const int32_t* sizes, size_t faces, cageproof_cage** cage) {
  return c::guarded([&] {
    c::require(cage, "cage");
    *cage = c::handed_out(
        new cageproof_cage{cage_of(dimension, c::span_of(vertices, vertices_size, "vertices"),
                                   c::span_of(corners, corners_size, "corners"), c::span_of(sizes, faces, "sizes"))});
  });
}

int cageproof_cage_read(const char* file, cageproof_cage** cage) {
  return c::guarded([&] {
    c::require(file, "file");
    c::require(cage, "cage");
    *cage = c::handed_out(new cageproof_cage{read_obj(file)});
  });
}

int cageproof_cage_embedded(const char* name, cageproof_cage** cage) {
  return c::guarded([&] {
    c::require(name, "name");
    c::require(cage, "cage");
    *cage = c::handed_out(new cageproof_cage{embedded_cage(name)});
  });
}

void cageproof_cage_free(cageproof_cage* cage) { c::free_handle(cage); }

int cageproof_cage_check(const cageproof_cage* cage, const cageproof_option* options, size_t count) {
  return c::guarded([&] {
    c::require_handle(cage, "cage");
    c::require_names(c::span_of(options, count, "options"), {"flip_inward", "allow_invalid_quads"});
    checked_cage(cage->cage, c::options_of(options, count));
  });
}

int cageproof_cage_sizes(const cageproof_cage* cage, int* dimension, size_t* vertices, size_t* corners, size_t* faces) {
  return c::guarded([&] {
    c::require_handle(cage, "cage");
    if (dimension != nullptr) *dimension = cage->cage.dimension;
    if (vertices != nullptr) *vertices = cage->cage.vertices.size();
    if (corners != nullptr) *corners = corners_in(cage->cage);
    if (faces != nullptr) *faces = cage->cage.faces.size();
  });
}

int cageproof_cage_copy(const cageproof_cage* cage, double* vertices, size_t vertices_size, int32_t* corners,
                        size_t corners_size, int32_t* sizes, size_t faces) {
  return c::guarded([&] {
    c::require_handle(cage, "cage");
    const Cage& from = cage->cage;
    check_size(vertices_size, from.vertices.size(), "vertices");
    check_size(corners_size, corners_in(from), "corners");
    check_size(faces, from.faces.size(), "sizes");
    std::ranges::copy(from.vertices, c::span_of(vertices, vertices_size, "vertices").begin());
    auto corner = c::span_of(corners, corners_size, "corners").begin();
    auto size = c::span_of(sizes, faces, "sizes").begin();
    for (const auto& face : from.faces) {
      corner = std::ranges::copy(face, corner).out;
      *size++ = static_cast<int32_t>(face.size());
    }
  });
}

const char* cageproof_cage_warning(const cageproof_cage* cage, size_t index) {
  const char* found = nullptr;
  c::guarded([&] {
    c::require_handle(cage, "cage");
    if (index < cage->cage.warnings.size()) found = cage->cage.warnings[index].c_str();
  });
  return found;
}
}
