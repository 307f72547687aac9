// SPDX-License-Identifier: MIT
// The summands of coordinates that are sums over a cage's elements: elements, their evaluations, and the blocks
// that their parts belong to.
#pragma once

#include "coordinates/normalise.h"
#include "table_rows.h"

#include "cageproof/core/coordinates/coordinates.h"

#include <array>
#include <memory>
#include <span>
#include <string>
#include <vector>

namespace cageproof {

// The evaluations of a kind's blocks on one kind of element; none for kinds of elements that the cage does not have.
using ElementEvaluations = std::vector<Evaluation>;

struct Summands {
  // \throws InputError as CageCoordinates
  Summands(const CoordinateKind& kind, std::shared_ptr<const CageElements> elements, const CoordinateOptions& options);

  bool has_quads() const;

  // Numbers that leave a scalar's range are summed in this one.
  using Wide = Mp200;
  // Whether all evaluations have it.
  bool goes_beyond_range() const;

  // In units of 2^-exponent, exactly.
  template <Scalar R>
  std::span<const Vec3<R>> corners_of(std::size_t e, std::array<Vec3<R>, 4>& storage, int exponent = 0) const {
    const auto vertices = elements->vertices_of(e);
    for (std::size_t k = 0; k < vertices.size(); ++k)
      storage[k] = in_unit(convert<R>(elements->vertices()[vertices[k]]), exponent);
    return std::span(storage).first(vertices.size());
  }

  template <Scalar R>
  BatchOutput<R> output_for(std::size_t b, std::size_t first, CoordinateTable<R>& table) const {
    BatchOutput<R> output{.stride = table.stride,
                          .entries = static_cast<std::size_t>(blocks[b].entries()),
                          .dim = elements->dimension(),
                          .add = true};
    for (std::size_t o = 0; o < 3; ++o)
      if (!table.tensors[o].empty()) output.tensors[o] = table.tensors[o].data() + first * table.stride[o];
    return output;
  }

  // Converts the rows of point p from the unit 2^-exponent to the cage's own.
  template <Scalar R>
  void to_own_unit(std::size_t p, int order, std::span<CoordinateTable<R>> tables, int exponent) const {
    using std::ldexp;
    for (std::size_t b = 0; b < blocks.size(); ++b)
      for (int o = 0; o <= order; ++o)
        for (R& x : row_of(tables[b], p, o)) x = ldexp(x, (o - degrees[b]) * exponent);
  }

  // Finishes a point's sums in the unit 2^-exponent: normals are multiplied by their area elements, weights are divided
  // by their sum.
  template <Scalar R>
  void finish_sums(std::size_t p, int order, std::span<CoordinateTable<R>> tables, int exponent) const {
    if (has_area_elements) times_area_elements_at(p, order, exponent, tables);
    if (!normalised) return;
    std::array<R*, 3> weights{};
    for (int o = 0; o <= order; ++o) weights[o] = row_of(tables[0], p, o).data();
    normalise(weights, blocks[0].size, elements->dimension(), order);
    using std::ldexp;
    for (int o = 1; exponent != 0 && o <= order; ++o)
      for (R& x : row_of(tables[0], p, o)) x = ldexp(x, o * exponent);
  }

  // Quads' formulas leave the area element out. One point's, in the unit 2^-exponent.
  template <Scalar R>
  void times_area_elements_at(std::size_t p, int order, int exponent, std::span<CoordinateTable<R>> tables) const {
    for (std::size_t b = 0; b < blocks.size(); ++b) {
      if (blocks[b].owner != Owner::Normal) continue;
      for (int o = 0; o <= order; ++o) {
        const std::size_t size = tables[b].stride[o] / blocks[b].size;
        const std::span<R> row = row_of(tables[b], p, o);
        for (std::size_t i = 0; i < row.size(); ++i)
          row[i] *= R(elements->area_element_in(exponent, i / size, Owner::Normal));
      }
    }
  }
  template <Scalar R>
  void times_area_elements(std::size_t points, int order, std::span<CoordinateTable<R>> tables) const {
    for (std::size_t p = 0; p < points; ++p) times_area_elements_at(p, order, 0, tables);
  }

  // A function (element, block, Batch::finite_part, result) of the elements' integrals at a point.
  template <Scalar R>
  auto parts_in_range(const Vec3<R>& point, int order, int exponent) const {
    return [this, near = in_unit(point, exponent), order, exponent,
            parameters = std::vector<R>(parameters.begin(), parameters.end())](std::size_t e, std::size_t b,
                                                                               bool finite_part, Result<R>& part) {
      std::array<Vec3<R>, 4> storage;
      evaluations[static_cast<std::size_t>(elements->type(e).kind)][b](
          Query<R>{corners_of(e, storage, exponent), near, order, parameters, finite_part}, part);
    };
  }

  // Cages whose largest coordinate has an exponent of at most this magnitude are summed in their own unit.
  template <Scalar R>
  static constexpr int kComfortable = std::same_as<R, float> ? 40 : 300;

  bool normalised;
  std::shared_ptr<const CageElements> elements;
  int size_exponent;  // of the largest coordinate
  std::vector<double> parameters;
  std::array<ElementEvaluations, element_kinds.size()> evaluations;
  std::vector<CoordinateBlock> blocks;
  std::vector<double> jumps;  // of blocks, at faces
  std::vector<int> degrees;   // of blocks
  bool has_area_elements = false;
  bool homogeneous = true;  // whether no block has a logarithm of the unit
  int max_order = 2;

 private:
  void add_evaluations(const CoordinateKind& kind, ElementKind element, const std::string& name);
};

}  // namespace cageproof
