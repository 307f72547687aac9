// SPDX-License-Identifier: MIT
// Single and double layers of all faces for a chunk of points, whatever is near or far.
#pragma once

#include "../geometry.h"
#include "../kernels.h"
#include "../points_by_plan.h"
#include "near_quad.h"

#include "cageproof/core/catalogue/evaluation.h"

#include <array>
#include <optional>
#include <span>
#include <vector>

namespace cageproof::adaptive_qmvc::batch {

/// The constants of a cage's layers.
struct LayerTables {
  LayerTables(const Geometry& geometry, const CageElements& elements);

  /// Per face: its first number among Owner::Normal, and whether it is a quad.
  std::vector<int> first;
  std::vector<char> is_quad;
  /// The factors of single layers in the geometry's unit, by Owner::Normal: the area element over 4 pi, in the caller's
  /// unit.
  std::vector<double> factor;
  std::vector<double> area;  ///< of faces that are triangles: twice their area, in the geometry's unit
};

/// Memory for one chunk of points after the other. What it finds of a point does not depend on the others.
class LayerSums {
 public:
  /// How many points are best taken at a time.
  static std::size_t chunk_size(const Geometry& geometry);

  /// \param geometry sound \param with of an instruction set that the machine has. All are kept as references.
  LayerSums(const Geometry& geometry, const CageElements& elements, const LayerTables& tables,
            const Kernels& with = kernels());

  /// Coordinates of at most chunk_size() points. Lists those of which nothing is computed: on the cage, and at the ends
  /// of double's range.
  void run(std::span<const Vec3<double>> points);
  const std::vector<int>& left() const { return left_; }
  /// Stores the coordinates of points first .. first + count - 1: a double layer a vertex, and a single layer a normal,
  /// each point's in a row. What is stored for those that are left means nothing.
  struct Rows {
    double* first;
    std::size_t stride;
  };
  void put(std::size_t first, std::size_t count, Rows double_layer, Rows single_layer) const;

 private:
  void take(std::span<const Vec3<double>> points);
  void add_from_afar(std::size_t face);
  void add_alone(std::size_t face, int point);
  bool add_by_evaluations(std::size_t face, const Vec3<double>& point, QuadLayers& layers) const;

  const Geometry& geometry_;
  const CageElements& elements_;
  const LayerTables& tables_;
  const Kernels& kernels_;
  const Plans& plans_;
  PointsByPlan sorted_;
  NearQuadLayers near_;
  std::array<std::vector<Evaluation>, element_kinds.size()> evaluations_;  // double, single
  std::vector<double> at_, double_layer_, single_layer_, distances_;
  std::vector<char> is_left_;
  std::vector<int> left_;
  std::vector<std::array<Vec3<double>, 4>> corner_;  // of faces, in the geometry's unit
  Chunk chunk_{};
  int points_ = 0;
};

}  // namespace cageproof::adaptive_qmvc::batch
