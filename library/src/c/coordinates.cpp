// SPDX-License-Identifier: MIT
#include "../conversions.h"
#include "guard.h"

#include <fmt/format.h>

#include <algorithm>

struct cageproof_coordinates {  // NOLINT(readability-identifier-naming): of the C interface
  cageproof::library::Coordinates coordinates;
};

struct cageproof_deformer {  // NOLINT(readability-identifier-naming): of the C interface
  cageproof::library::Deformer deformer;
};

struct cageproof_bound {  // NOLINT(readability-identifier-naming): of the C interface
  cageproof::library::BoundPoints bound;
};

extern "C" {

using namespace cageproof::library;
using cageproof::InputError;

int cageproof_coordinates_make(const cageproof_cage* cage, const char* kind, const cageproof_option* options,
                               size_t count, cageproof_coordinates** coordinates) {
  return c::guarded([&] {
    c::require_handle(cage, "cage");
    c::require(kind, "kind");
    c::require(coordinates, "coordinates");
    const Options given = c::options_of(options, count);
    if (given.digits != 0) throw InputError("digits: coordinates have all digits only; deformers take the option");
    *coordinates = c::handed_out(new cageproof_coordinates{Coordinates(cage->cage, kind, given)});
  });
}

void cageproof_coordinates_free(cageproof_coordinates* coordinates) { c::free_handle(coordinates); }

int cageproof_coordinates_sizes(const cageproof_coordinates* coordinates, int* dimension, int* max_order, size_t* row,
                                size_t* blocks, size_t* elements) {
  return c::guarded([&] {
    c::require_handle(coordinates, "coordinates");
    const Coordinates& of = coordinates->coordinates;
    if (dimension != nullptr) *dimension = of.dimension();
    if (max_order != nullptr) *max_order = of.max_order();
    if (row != nullptr) *row = of.row();
    if (blocks != nullptr) *blocks = of.blocks().size();
    if (elements != nullptr) *elements = of.elements().size();
  });
}

int cageproof_coordinates_block(const cageproof_coordinates* coordinates, size_t index, cageproof_block* block) {
  return c::guarded([&] {
    c::require_handle(coordinates, "coordinates");
    c::require(block, "block");
    const std::vector<Block>& all = coordinates->coordinates.blocks();
    if (index >= all.size()) throw InputError(fmt::format("block {}: there are {}", index, all.size()));
    const Block& b = all[index];
    *block = {b.label.c_str(),
              b.one_a.c_str(),
              b.reproduces.c_str(),
              b.count,
              static_cast<size_t>(b.rows),
              static_cast<size_t>(b.columns),
              b.offset,
              b.normal_factor};
  });
}

int cageproof_coordinates_elements(const cageproof_coordinates* coordinates, int32_t* corners, size_t corners_size,
                                   int32_t* faces, size_t faces_size, double* normals, size_t normals_size) {
  return c::guarded([&] {
    c::require_handle(coordinates, "coordinates");
    const std::vector<Element>& all = coordinates->coordinates.elements();
    const auto width = static_cast<std::size_t>(coordinates->coordinates.dimension());
    const auto to_corners = c::span_of(corners, corners_size, "corners");
    const auto to_faces = c::span_of(faces, faces_size, "faces");
    const auto to_normals = c::span_of(normals, normals_size, "normals");
    if (!to_corners.empty()) check_size(corners_size, all.size() * 4, "corners");
    if (!to_faces.empty()) check_size(faces_size, all.size(), "faces");
    if (!to_normals.empty()) check_size(normals_size, all.size() * width, "normals");
    std::ranges::fill(to_corners, -1);
    for (std::size_t e = 0; e < all.size(); ++e) {
      if (!to_corners.empty()) std::ranges::copy(all[e].vertices, to_corners.subspan(4 * e).begin());
      if (!to_faces.empty()) to_faces[e] = all[e].face;
      if (!to_normals.empty()) std::ranges::copy(all[e].normal, to_normals.subspan(width * e).begin());
    }
  });
}

int cageproof_coordinates_evaluate(const cageproof_coordinates* coordinates, const double* points, size_t points_size,
                                   double* values, size_t values_size, double* gradients, size_t gradients_size,
                                   double* hessians, size_t hessians_size) {
  return c::guarded([&] {
    c::require_handle(coordinates, "coordinates");
    coordinates->coordinates.evaluate(
        c::span_of(points, points_size, "points"), c::span_of(values, values_size, "values"),
        c::span_of(gradients, gradients_size, "gradients"), c::span_of(hessians, hessians_size, "hessians"));
  });
}

int cageproof_coordinates_apply(const cageproof_coordinates* coordinates, const double* points, size_t points_size,
                                const double* data, size_t data_size, int functions, double* sums, size_t sums_size) {
  return c::guarded([&] {
    c::require_handle(coordinates, "coordinates");
    coordinates->coordinates.apply(c::span_of(points, points_size, "points"), c::span_of(data, data_size, "data"),
                                   functions, c::span_of(sums, sums_size, "sums"));
  });
}

int cageproof_coordinates_jvp(const cageproof_coordinates* coordinates, const double* points, size_t points_size,
                              const double* change, size_t change_size, double* values, size_t values_size) {
  return c::guarded([&] {
    c::require_handle(coordinates, "coordinates");
    coordinates->coordinates.jvp(c::span_of(points, points_size, "points"), c::span_of(change, change_size, "change"),
                                 c::span_of(values, values_size, "values"));
  });
}

int cageproof_coordinates_vjp(const cageproof_coordinates* coordinates, const double* points, size_t points_size,
                              const double* weights, size_t weights_size, double* vertices, size_t vertices_size) {
  return c::guarded([&] {
    c::require_handle(coordinates, "coordinates");
    coordinates->coordinates.vjp(c::span_of(points, points_size, "points"),
                                 c::span_of(weights, weights_size, "weights"),
                                 c::span_of(vertices, vertices_size, "vertices"));
  });
}

int cageproof_deformer_make(const cageproof_cage* rest, const char* method, const cageproof_option* options,
                            size_t count, cageproof_deformer** deformer) {
  return c::guarded([&] {
    c::require_handle(rest, "rest");
    c::require(method, "method");
    c::require(deformer, "deformer");
    *deformer = c::handed_out(new cageproof_deformer{Deformer(rest->cage, method, c::options_of(options, count))});
  });
}

void cageproof_deformer_free(cageproof_deformer* deformer) { c::free_handle(deformer); }

int cageproof_deformer_pose(cageproof_deformer* deformer, const double* vertices, size_t vertices_size) {
  return c::guarded([&] {
    c::require_handle(deformer, "deformer");
    deformer->deformer.pose(c::span_of(vertices, vertices_size, "vertices"));
  });
}

int cageproof_deformer_images(const cageproof_deformer* deformer, const double* points, size_t points_size,
                              double* images, size_t images_size, double* jacobians, size_t jacobians_size) {
  return c::guarded([&] {
    c::require_handle(deformer, "deformer");
    deformer->deformer.images(c::span_of(points, points_size, "points"), c::span_of(images, images_size, "images"),
                              c::span_of(jacobians, jacobians_size, "jacobians"));
  });
}

int cageproof_deformer_bind(const cageproof_deformer* deformer, const double* points, size_t points_size,
                            int with_jacobians, cageproof_bound** bound) {
  return c::guarded([&] {
    c::require_handle(deformer, "deformer");
    c::require(bound, "bound");
    *bound = c::handed_out(
        new cageproof_bound{deformer->deformer.bind(c::span_of(points, points_size, "points"), with_jacobians != 0)});
  });
}

void cageproof_bound_free(cageproof_bound* bound) { c::free_handle(bound); }

int cageproof_bound_images(const cageproof_deformer* deformer, const cageproof_bound* bound, double* images,
                           size_t images_size, double* jacobians, size_t jacobians_size) {
  return c::guarded([&] {
    c::require_handle(deformer, "deformer");
    c::require_handle(bound, "bound");
    deformer->deformer.images(bound->bound, c::span_of(images, images_size, "images"),
                              c::span_of(jacobians, jacobians_size, "jacobians"));
  });
}

int cageproof_deformer_jvp(const cageproof_deformer* deformer, const double* points, size_t points_size,
                           const double* change, size_t change_size, double* images, size_t images_size) {
  return c::guarded([&] {
    c::require_handle(deformer, "deformer");
    deformer->deformer.jvp(c::span_of(points, points_size, "points"), c::span_of(change, change_size, "change"),
                           c::span_of(images, images_size, "images"));
  });
}

int cageproof_deformer_vjp(const cageproof_deformer* deformer, const double* points, size_t points_size,
                           const double* weights, size_t weights_size, double* vertices, size_t vertices_size) {
  return c::guarded([&] {
    c::require_handle(deformer, "deformer");
    deformer->deformer.vjp(c::span_of(points, points_size, "points"), c::span_of(weights, weights_size, "weights"),
                           c::span_of(vertices, vertices_size, "vertices"));
  });
}

int cageproof_bound_jvp(const cageproof_deformer* deformer, const cageproof_bound* bound, const double* change,
                        size_t change_size, double* images, size_t images_size) {
  return c::guarded([&] {
    c::require_handle(deformer, "deformer");
    c::require_handle(bound, "bound");
    deformer->deformer.jvp(bound->bound, c::span_of(change, change_size, "change"),
                           c::span_of(images, images_size, "images"));
  });
}

int cageproof_bound_vjp(const cageproof_deformer* deformer, const cageproof_bound* bound, const double* weights,
                        size_t weights_size, double* vertices, size_t vertices_size) {
  return c::guarded([&] {
    c::require_handle(deformer, "deformer");
    c::require_handle(bound, "bound");
    deformer->deformer.vjp(bound->bound, c::span_of(weights, weights_size, "weights"),
                           c::span_of(vertices, vertices_size, "vertices"));
  });
}
}
