// SPDX-License-Identifier: MIT
// Errors of several evaluations of one kind of coordinates around a cage: scenes, to be seen side by side.
#pragma once

#include "cageproof/core/cage/mesh_io.h"
#include "cageproof/reports/field_scene.h"
#include "cageproof/validation/error_fields.h"

namespace cageproof::validation {

/// The evaluations that a scene compares, on one cage.
struct Comparison {
  std::shared_ptr<const Cage> cage;
  const CoordinateKind* kind;
  std::vector<std::string> evaluations;
  Triangulation rule = Triangulation::Shortest;
};

/// The most informative evaluations of a kind: quadrature of fixed size, the formulas as printed, and the recommended
/// ones, as far as all of the kind's formulas on the cage have them.
std::vector<std::string> telling_evaluations(const CoordinateKind& kind, const Cage& cage);

/// Samples a side of a grid around the cage that costs about so many pairs of element and block in 50 digits, between 6
/// and `most`.
int affordable_side(const Comparison& comparison, double pairs, int most);

/// "<evaluation>: relative error" of each, norm-wise of the worst block, against the recommended evaluation in 50
/// digits; NaN where there is no truth. Then of each block "truth: norm of <block>", and "inside" (1 or 0), which are
/// linear. On a grid of side x side x side samples around the cage, a tenth larger than its box; in the plane one
/// layer. \throws InputError for an evaluation that a formula of the kind does not have
FieldPlan compared_field(const Comparison& comparison, int side);

/// The same on a mesh, at about so many vertices, spread evenly; the others are NaN.
MeshField compared_mesh(const Comparison& comparison, const Mesh& mesh, std::size_t points, int jobs);

/// Both in blocks, as parts of one scene. \param place of the image's field in the report; a mesh's is the next
Measurements scene_measurements(const Comparison& comparison, int side, const std::shared_ptr<const Mesh>& mesh,
                                std::size_t points, int place);

/// The cage as geometry, and the name it has in PartialResult::meshes.
MeshField outline_of(const Cage& cage);
std::string outline_name(const Cage& cage);
/// Found as PartialResult::meshes[outline_name(cage)].
std::unique_ptr<const Measurement> outline_measurement(std::shared_ptr<const Cage> cage);

/// A title and a sentence for a scene of these arrays.
std::string scene_title(const Comparison& comparison);
inline constexpr const char* scene_explanation =
    "Relative error of the worst block of coordinates against 50 digits, sample by sample, on one scale of colours.";

}  // namespace cageproof::validation
