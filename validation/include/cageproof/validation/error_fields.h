// SPDX-License-Identifier: MIT
// Fields on slices, of errors and of coordinates themselves: through a cage, or across one element.
#pragma once

#include "cageproof/core/coordinates/coordinates.h"
#include "cageproof/validation/measurement.h"
#include "cageproof/validation/sample.h"

#include <span>

namespace cageproof::validation {

/// A slice of points x points samples.
struct SlicePlan {
  Vec3<double> origin, spacing;
  std::array<int, 3> points;
};

/// The slice through the middle of a cage's box, at right angles to its shortest side, a tenth larger than the box.
SlicePlan slice_through(const Cage& cage, int resolution);

/// A field that is still to be sampled.
struct FieldPlan {
  ImageField field;  ///< grid and arrays, without values
  /// Makes a sampler, which gives one number per array at a point of the grid. Safe from any thread.
  using Sampler = std::function<void(const Vec3<double>& point, std::span<double> values)>;
  std::function<Sampler()> prepare;
};

/// All samples. \param jobs threads; 0: all cores
ImageField sampled(const FieldPlan& plan, int jobs);

/// The field in blocks. \param place in the report, \param title what is shown, \param shown the array that the picture
/// shows
/// \param common cage, scene and compared of its parts
std::unique_ptr<const Measurement> field_measurement(FieldPlan plan, int place, const std::string& title,
                                                     const std::string& shown, FieldPart common = {});
/// An element of each kind that shows its errors well, and a slice of resolution x resolution samples that cuts it: the
/// element and what surrounds it.
struct ElementSlice {
  std::vector<Vec3<double>> corners;
  SlicePlan slice;
};
ElementSlice slice_of(ElementKind kind, int resolution);

/// The corners of a cage's elements of one kind: quads as they are, or the triangles of its triangulation. \throws
/// InputError where the cage has none
std::vector<std::vector<Vec3<double>>> elements_of(const Cage& cage, ElementKind kind, Triangulation rule);

/// Partition of unity and linear reproduction on a slice (arrays of those names, raw errors).
/// \param evaluation empty for each formula's recommended one
/// \param parameters in the order of parameters_of(kind); empty for their defaults
FieldPlan reproduction_field(const std::shared_ptr<const Cage>& cage, const CoordinateKind& kind,
                             const std::string& evaluation, Triangulation rule, int resolution,
                             const std::vector<double>& parameters = {});

/// Relative error of a kind of coordinates against the recommended evaluation in 50 digits on a slice: array `relative
/// error`, the largest over the blocks.
FieldPlan coordinate_error_field(const std::shared_ptr<const Cage>& cage, const CoordinateKind& kind,
                                 const std::string& evaluation, Triangulation rule, int resolution);

/// How far one evaluation of a kind of coordinates is from another, both in double, on a slice: array `difference`, the
/// largest of a coordinate. For errors far above rounding, where a truth in 50 digits would only cost time.
FieldPlan coordinate_difference_field(const std::shared_ptr<const Cage>& cage, const CoordinateKind& kind,
                                      const std::string& evaluation, const std::string& other, Triangulation rule,
                                      int resolution);

/// How far a scheme is from the coordinates that it approximates (CoordinateKind::approximates), inside the cage: array
/// `scheme error`, the largest of a coordinate, in cage sizes. \param parameters as of reproduction_field
/// \throws InputError for a kind that approximates none, or where these are not known well enough in the cage
FieldPlan scheme_error_field(const std::shared_ptr<const Cage>& cage, const CoordinateKind& kind, Triangulation rule,
                             int resolution, const std::vector<double>& parameters = {});

/// One coordinate of a block on a slice, inside the cage: array `<label>_<index>`, linear; of matrices the entry in the
/// first row and column.
/// \param label of the block \param index of the vertex or element
/// `prepare` of the plan throws InputError for a block that the kind does not have, or an index beyond it.
FieldPlan coordinate_field(const std::shared_ptr<const Cage>& cage, const CoordinateKind& kind,
                           const std::string& label, int index, int resolution);

/// Relative error of one formula on a slice, norm-wise over all elements, against its truth's source in 50 digits;
/// arrays `value` (norm over all elements) and `relative error`. \param elements corners of elements of the formula's
/// kind \throws InputError for an element of another kind, or where nothing gives the formula's truth
ImageField formula_error_field(const std::vector<std::vector<Vec3<double>>>& elements, const Formula& formula,
                               const Evaluation& evaluation, int order, const SlicePlan& slice, int jobs);

}  // namespace cageproof::validation
