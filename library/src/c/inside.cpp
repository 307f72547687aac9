// SPDX-License-Identifier: MIT
#include "../conversions.h"
#include "guard.h"

#include "cageproof/core/cage/point_places.h"

#include <fmt/format.h>

#include <algorithm>

struct cageproof_inside {  // NOLINT(readability-identifier-naming): of the C interface
  cageproof::PointPlaces places;
  int dimension;
};

namespace cageproof::library::c {
namespace {

PointPlaces places_of(const Cage& cage, bool any_mesh, std::span<const cageproof_option> given) {
  require_names(given, {"triangulation", "flip_inward", "keep_quads"});
  bool keep_quads = false;
  std::vector<cageproof_option> others;
  for (const cageproof_option& option : given) {
    require(option.value, option.name);
    if (std::string_view(option.name) != "keep_quads") others.push_back(option);
    else if (const std::string_view value = option.value; value == "0" || value == "1") keep_quads = value == "1";
    else throw InputError(fmt::format("option keep_quads: '{}' is neither 0 nor 1", value));
  }
  const Options options = options_of(others.data(), others.size());
  if (!any_mesh) return {checked_cage(cage, options), keep_quads, triangulation_of(options)};
  if (keep_quads || options.flip_inward)
    throw InputError("any_mesh takes meshes as they are: leave out keep_quads and flip_inward");
  if (cage.dimension != 3) throw InputError(fmt::format("{}: any mesh lies in space, not in the plane", cage.name));
  return {vectors_of(cage.vertices, 3, "vertices"), cage.faces};
}

}  // namespace
}  // namespace cageproof::library::c

extern "C" {

using namespace cageproof::library;
using cageproof::InputError;

int cageproof_inside_make(const cageproof_cage* cage, int any_mesh, const cageproof_option* options, size_t count,
                          cageproof_inside** inside) {
  return c::guarded([&] {
    c::require_handle(cage, "cage");
    c::require(inside, "inside");
    *inside = c::handed_out(new cageproof_inside{
        c::places_of(cage->cage, any_mesh != 0, c::span_of(options, count, "options")), cage->cage.dimension});
  });
}

void cageproof_inside_free(cageproof_inside* inside) { c::free_handle(inside); }

int cageproof_inside_points(const cageproof_inside* inside, const double* points, size_t points_size, int threads,
                            int32_t* places, size_t places_size, int32_t* faces, size_t faces_size, double* windings,
                            size_t windings_size, double* bounds, size_t bounds_size) {
  return c::guarded([&] {
    c::require_handle(inside, "inside");
    if (threads < 0) throw InputError(fmt::format("threads: {} is less than 0", threads));
    const auto at = vectors_of(c::span_of(points, points_size, "points"), inside->dimension, "points");
    const auto to_places = c::span_of(places, places_size, "places"), to_faces = c::span_of(faces, faces_size, "faces");
    const auto to_windings = c::span_of(windings, windings_size, "windings"),
               to_bounds = c::span_of(bounds, bounds_size, "bounds");
    if (!to_places.empty()) check_size(places_size, at.size(), "places");
    if (!to_faces.empty()) check_size(faces_size, at.size(), "faces");
    if (!to_windings.empty()) check_size(windings_size, at.size(), "windings");
    if (!to_bounds.empty()) check_size(bounds_size, at.size(), "bounds");
    for_blocks(at.size(), threads, [&](std::size_t first, std::size_t block) {
      for (std::size_t p = first; p < first + block; ++p) {
        const cageproof::PointPlace found = inside->places.at(at[p]);
        if (!to_places.empty()) to_places[p] = static_cast<int32_t>(found.place);
        if (!to_faces.empty()) to_faces[p] = found.face;
        if (!to_windings.empty()) to_windings[p] = found.winding;
        if (!to_bounds.empty()) to_bounds[p] = found.bound;
      }
    });
  });
}
}
