// SPDX-License-Identifier: MIT
// A mesh with its arrays as VTK's own object, for those who add to it before it is written.
#pragma once

#include "cageproof/core/results/run_result.h"
#include "cageproof/reports/vtk_text.h"

#include <vtkPolyData.h>
#include <vtkSmartPointer.h>

#include <string>

namespace cageproof::reports {

/// The mesh that vtp_text writes.
vtkSmartPointer<vtkPolyData> poly_of(const MeshField& field, FieldArrays arrays = FieldArrays::Alone);

/// The text of a .vtp file, as vtp_text.
std::string poly_text(vtkPolyData& data);

}  // namespace cageproof::reports
