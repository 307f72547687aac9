// SPDX-License-Identifier: MIT
#include "whole_cage/questions.h"

#include "cageproof/core/coordinates/coordinates.h"
#include "cageproof/core/numbers/random_stream.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace cageproof::judge {
namespace {

struct Shape {
  std::vector<Vec3<double>> vertices;
  std::vector<Face> faces;
  int dimension = 3;
  /// Vertices of convex parts, which points inside are taken of in turn; empty for convex shapes.
  std::vector<std::vector<std::size_t>> parts = {};
};

std::vector<Face> faces_of(const std::vector<std::vector<int>>& corners) {
  std::vector<Face> faces(corners.size());
  for (std::size_t f = 0; f < faces.size(); ++f) std::ranges::copy(corners[f], faces[f].vertices.begin());
  return faces;
}

const std::vector<Shape>& shapes_in_space() {
  static const std::vector<Shape> all{
      {{{0, 0, 0}, {4, 0, 0}, {0, 4, 0}, {0, 0, 4}}, faces_of({{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {2, 0, 3}})},
      {{{4, 0, 0}, {-4, 0, 0}, {0, 4, 0}, {0, -4, 0}, {0, 0, 4}, {0, 0, -4}},
       faces_of({{0, 2, 4}, {2, 1, 4}, {1, 3, 4}, {3, 0, 4}, {2, 0, 5}, {1, 2, 5}, {3, 1, 5}, {0, 3, 5}})},
      {{{0, 0, 0}, {12, 0, 0}, {0, 4, 0}, {1, 1, 4}}, faces_of({{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {2, 0, 3}})}};
  return all;
}

// A block, a frustum, a wedge with two triangles, and an L-shaped block, within which faces are seen from behind. All
// quads are planar.
const std::vector<Shape>& shapes_of_quads() {
  const std::vector<std::vector<int>> box{{0, 3, 2, 1}, {4, 5, 6, 7}, {0, 1, 5, 4},
                                          {1, 2, 6, 5}, {2, 3, 7, 6}, {3, 0, 4, 7}};
  static const std::vector<Shape> all{
      {{{0, 0, 0}, {4, 0, 0}, {4, 8, 0}, {0, 8, 0}, {0, 0, 4}, {4, 0, 4}, {4, 8, 4}, {0, 8, 4}}, faces_of(box)},
      {{{0, 0, 0}, {8, 0, 0}, {8, 8, 0}, {0, 8, 0}, {2, 2, 4}, {6, 2, 4}, {6, 6, 4}, {2, 6, 4}}, faces_of(box)},
      {{{0, 0, 0}, {4, 0, 0}, {0, 4, 0}, {0, 0, 8}, {4, 0, 8}, {0, 4, 8}},
       faces_of({{0, 2, 1}, {3, 4, 5}, {0, 1, 4, 3}, {1, 2, 5, 4}, {2, 0, 3, 5}})},
      {{{0, 0, 0},
        {4, 0, 0},
        {8, 0, 0},
        {8, 4, 0},
        {4, 4, 0},
        {4, 8, 0},
        {0, 8, 0},
        {0, 4, 0},
        {0, 0, 4},
        {4, 0, 4},
        {8, 0, 4},
        {8, 4, 4},
        {4, 4, 4},
        {4, 8, 4},
        {0, 8, 4},
        {0, 4, 4}},
       faces_of({{7, 4, 1, 0},
                 {4, 3, 2, 1},
                 {6, 5, 4, 7},
                 {8, 9, 12, 15},
                 {9, 10, 11, 12},
                 {15, 12, 13, 14},
                 {0, 1, 9, 8},
                 {1, 2, 10, 9},
                 {2, 3, 11, 10},
                 {3, 4, 12, 11},
                 {4, 5, 13, 12},
                 {5, 6, 14, 13},
                 {6, 7, 15, 14},
                 {7, 0, 8, 15}}),
       3,
       {{1, 2, 3, 4, 9, 10, 11, 12}, {4, 5, 6, 7, 12, 13, 14, 15}}}};
  return all;
}

// Two triangles, and an arrowhead, which its diagonal between vertices 0 and 2 halves.
const std::vector<Shape>& shapes_in_plane() {
  static const std::vector<Shape> all{{{{0, 0, 0}, {4, 0, 0}, {0, 4, 0}}, faces_of({{0, 1}, {1, 2}, {2, 0}}), 2},
                                      {{{0, 0, 0}, {4, -4, 0}, {1, 0, 0}, {4, 4, 0}},
                                       faces_of({{0, 1}, {1, 2}, {2, 3}, {3, 0}}),
                                       2,
                                       {{0, 1, 2}, {0, 2, 3}}},
                                      {{{0, 0, 0}, {12, 0, 0}, {1, 4, 0}}, faces_of({{0, 1}, {1, 2}, {2, 0}}), 2}};
  return all;
}

const std::vector<Shape>& shapes(int dimension) { return dimension == 2 ? shapes_in_plane() : shapes_in_space(); }

CageRequest question_of(const Shape& shape, const Vec3<double>& point) {
  return {shape.vertices, shape.faces, {point}, shape.dimension};
}

Vec3<double> inside(const Shape& shape, std::uint64_t index) {
  RandomStream random(3, "whole cage", index);
  Vec3<double> point = Vec3<double>::Zero();
  double sum = 0;
  std::vector<std::size_t> all(shape.vertices.size());
  std::iota(all.begin(), all.end(), std::size_t{0});
  for (const std::size_t v : shape.parts.empty() ? all : shape.parts[index % shape.parts.size()]) {
    const double weight = random.uniform(0.1, 1);
    point += weight * shape.vertices[v];
    sum += weight;
  }
  return point / sum;
}

// Barycentric coordinates in sixteenths of points within a face, on an edge, and at a corner; and of points on a
// segment.
constexpr std::array<std::array<int, 3>, 4> kOnFaces{{{4, 5, 7}, {11, 3, 2}, {12, 4, 0}, {0, 16, 0}}};
constexpr std::array<std::array<int, 3>, 4> kOnSegments{{{4, 12, 0}, {11, 5, 0}, {15, 1, 0}, {0, 16, 0}}};

CageSample on_face(const Shape& shape, int face, const std::array<int, 3>& weights) {
  Vec3<double> point = Vec3<double>::Zero();
  std::vector<double> truth(shape.vertices.size(), 0.0);
  for (std::size_t k = 0; k < static_cast<std::size_t>(shape.dimension); ++k) {
    const auto v = static_cast<std::size_t>(shape.faces[static_cast<std::size_t>(face)].vertices[k]);
    point += weights[k] / 16.0 * shape.vertices[v];
    truth[v] = weights[k] / 16.0;
  }
  return {question_of(shape, point), truth, face};
}

void scale(CageRequest& question, double unit) {
  for (auto& vertex : question.vertices) vertex *= unit;
  question.points[0] *= unit;
}

}  // namespace

Cage CageRequest::cage() const {
  return dimension == 2 ? Cage::make_polygon("judged", vertices, faces) : Cage::make("judged", vertices, faces);
}

std::vector<double> truth_of(const CageRequest& q, std::string_view kind, std::vector<std::size_t>* sizes) {
  const CoordinateKind& row = coordinate_kind_named(kind);
  const CageCoordinates coordinates(q.cage(), row, CoordinateOptions{row.is_sum() ? "closed_form" : ""});
  std::vector<double> values;
  for (const auto& block : coordinates.at<double>(q.points[0], 0)) {
    values.insert(values.end(), block.value.begin(), block.value.end());
    if (sizes != nullptr) sizes->push_back(block.value.size());
  }
  return values;
}

std::vector<CageSample> cage_samples(std::string_view kind, double unit, int dimension) {
  std::vector<CageSample> samples;
  std::uint64_t index = 0;
  const CoordinateKind& row = coordinate_kind_named(kind);
  const bool interpolates = row.normalised;
  for (const Shape& shape : row.keeps_quads ? shapes_of_quads() : shapes(dimension)) {
    for (int i = 0; i < 6; ++i) {
      CageSample sample{question_of(shape, inside(shape, index++)), {}};
      // Each block has its own power of the unit, in the plane with a logarithm of it.
      scale(sample.question, unit);
      sample.truth = truth_of(sample.question, kind, &sample.sizes);
      samples.push_back(std::move(sample));
    }
    // Coordinates that interpolate are the barycentric ones on a triangle and on edges, whatever the cage.
    for (int face = 0; interpolates && face < static_cast<int>(shape.faces.size()); face += 2)
      for (const auto& weights : dimension == 2 ? kOnSegments : kOnFaces) {
        if (weights[2] != 0 && shape.faces[static_cast<std::size_t>(face)].size() > 3) continue;
        samples.push_back(on_face(shape, face, weights));
        scale(samples.back().question, unit);
      }
  }
  return samples;
}

std::array<CageRequest, 2> alike_cages(int dimension) {
  const Shape& shape = shapes(dimension)[0];
  const Vec3<double> point(1, 1, dimension == 2 ? 0 : 0.5);
  CageRequest moved = question_of(shape, point);
  if (dimension == 2) moved.vertices[2] = {1, 6, 0};
  else moved.vertices[3] = {1, 0, 6};
  return {question_of(shape, point), moved};
}

std::array<double, 3> chord_weights(const CageSample& sample) {
  const auto& face = sample.question.faces[static_cast<std::size_t>(sample.face)].vertices;
  std::array<Vec3<double>, 3> unit;
  for (std::size_t k = 0; k < 3; ++k)
    unit[k] = (sample.question.vertices[static_cast<std::size_t>(face[k])] - sample.question.points[0]).normalized();
  std::array<double, 3> chord{}, weights{};
  for (std::size_t k = 0; k < 3; ++k) chord[k] = (unit[(k + 1) % 3] - unit[(k + 2) % 3]).norm();
  double sum = 0;
  for (std::size_t k = 0; k < 3; ++k) {
    weights[k] = std::sin(2 * std::asin(std::min(1.0, chord[k] / 2))) * chord[(k + 1) % 3] * chord[(k + 2) % 3];
    sum += weights[k];
  }
  for (double& w : weights) w /= sum;
  return weights;
}

}  // namespace cageproof::judge
