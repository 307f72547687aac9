// SPDX-License-Identifier: MIT
// The options of `deform` that ask for strain and stress, and the table that they make.
#pragma once

#include "command_line.h"
#include "coordinate_table.h"

#include "cageproof/core/coordinates/coordinates.h"
#include "cageproof/deformation/deformer.h"
#include "cageproof/deformation/stress.h"

#include <nlohmann/json.hpp>

#include <limits>
#include <optional>
#include <string>
#include <vector>

namespace cageproof::cli {

/// The options as the user gave them: empty, or NaN, where they are not given.
struct StressArguments {
  std::string file, normals;
  double shear_modulus = std::numeric_limits<double>::quiet_NaN();
  double poisson_ratio = std::numeric_limits<double>::quiet_NaN();

  bool asked() const { return !file.empty(); }
};

/// Adds the options.
void add_stress(Command& command, StressArguments& a);

/// \param method its name in messages \param known its parameters, one of which may be `nu`
/// \throws InputError for Poisson's ratio given twice or not at all, and for one whose stress is infinite or of no
/// material
void check_stress(const StressArguments& a, std::string_view method, const std::vector<KindParameter>& known);

/// The material of a map. \param parameters of the method, in the order of `known` \pre check_stress
deformation::Material material_of(const StressArguments& a, const std::vector<KindParameter>& known,
                                  const std::vector<double>& parameters);

/// The rows of --normals, as long as one: none where none are given.
/// \throws InputError unless there is one per point, of a length that is finite and not zero
std::vector<Vec3<double>> unit_normals(const StressArguments& a, std::size_t points, int dimension);

/// One row per point: `strain_xx`, `_yy`, `_zz`, `_xy`, in space `_yz`, `_xz`; `stress_xx` and so on; `von_mises`; with
/// normals `traction_x` and so on. NaN where the Jacobian has no limit.
/// \param images with Jacobians \param normals of length one, one per point, or none
CoordinateColumns stress_columns(const deformation::Images<double>& images, int dimension,
                                 const deformation::Material& material, const std::vector<Vec3<double>>& normals);

/// The report's member: the material, and the largest of the finite von Mises stresses (null where there is none).
nlohmann::ordered_json stress_json(const CoordinateColumns& table, const deformation::Material& material);

}  // namespace cageproof::cli
