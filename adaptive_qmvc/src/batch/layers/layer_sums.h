// SPDX-License-Identifier: MIT
// Harmonic and biharmonic layers of all faces for a chunk of points, whatever is near or far.
#pragma once

#include "../geometry.h"
#include "../kernels.h"
#include "../points_by_plan.h"
#include "near_quad.h"

#include "cageproof/core/catalogue/evaluation.h"

#include <array>
#include <optional>
#include <span>
#include <string_view>
#include <vector>

namespace cageproof::adaptive_qmvc::batch {

/// The formulas of what QuadLayers has integrals for.
inline constexpr std::array<std::string_view, 4> kKernels{"double_layer", "single_layer", "biharmonic_double_layer",
                                                          "biharmonic_single_layer"};

/// The constants of a cage's layers.
struct LayerTables {
  /// \param biharmonic whether biharmonic layers are wanted, too
  LayerTables(const Geometry& geometry, const CageElements& elements, bool biharmonic);

  /// Per face: its first number among Owner::Normal, and whether it is a quad.
  std::vector<int> first;
  std::vector<char> is_quad;
  /// For harmonic layers, and for biharmonic ones where they are wanted, the factors that make the caller's double
  /// layers of integrals in the geometry's unit, and those of single layers, by Owner::Normal, with the area element.
  struct Factors {
    double double_layer;
    std::vector<double> single_layer;
  };
  std::vector<Factors> factors;
  std::vector<double> area;  ///< of faces that are triangles: twice their area, in the geometry's unit

  /// The number of blocks. Each of `factors` has two: a double layer per vertex, and a single layer per normal.
  std::size_t blocks() const { return 2 * factors.size(); }
};

/// Memory for one chunk of points after the other. What it finds of a point does not depend on the others.
class LayerSums {
 public:
  /// How many points are best taken at a time.
  static std::size_t chunk_size(const Geometry& geometry, const LayerTables& tables);

  /// \param geometry sound \param with of an instruction set that the machine has. All are kept as references.
  LayerSums(const Geometry& geometry, const CageElements& elements, const LayerTables& tables,
            const Kernels& with = kernels());

  /// Coordinates of at most chunk_size() points. Lists those of which nothing is computed: on the cage, and at the ends
  /// of double's range.
  void run(std::span<const Vec3<double>> points);
  const std::vector<int>& left() const { return left_; }
  /// Stores the coordinates of points first .. first + count - 1, each point's in a row: all blocks one after the
  /// other. What is stored for those that are left means nothing.
  void put(std::size_t first, std::size_t count, double* rows, std::size_t stride) const;

 private:
  void take(std::span<const Vec3<double>> points);
  void add_from_afar(std::size_t face);
  void add_alone(std::size_t face, int point);
  bool add_by_evaluations(std::size_t face, const Vec3<double>& point, QuadLayers& layers) const;
  LayerColumns columns(std::size_t layers, std::size_t face);

  const Geometry& geometry_;
  const CageElements& elements_;
  const LayerTables& tables_;
  const Kernels& kernels_;
  const Plans& plans_;
  PointsByPlan sorted_;
  NearQuadLayers near_;
  std::array<std::vector<Evaluation>, element_kinds.size()> evaluations_;  // as QuadLayers
  std::vector<double> at_, distances_;
  std::array<std::vector<double>, 2> double_layer_, single_layer_;
  std::vector<char> is_left_;
  std::vector<int> left_;
  std::vector<std::array<Vec3<double>, 4>> corner_;  // of faces, in the geometry's unit
  Chunk chunk_{};
  int points_ = 0;
};

}  // namespace cageproof::adaptive_qmvc::batch
