// SPDX-License-Identifier: MIT
// VTK's vtkMeanValueCoordinatesInterpolator for `cageproof judge --kind mean_value` (docs/judged.md).
//   c++ -O2 -shared -fPIC -I judge/include $(...) vtk_mean_value.cpp -o vtk_mean_value.so
#include "cageproof_judge.h"

#include <vtkCellArray.h>
#include <vtkMeanValueCoordinatesInterpolator.h>
#include <vtkNew.h>
#include <vtkPoints.h>
#include <vtkVersion.h>

#include <cstring>

extern "C" {

int cageproof_judge_version(void) { return CAGEPROOF_JUDGE_VERSION; }

const char* cageproof_judge_about(void) { return "vtkMeanValueCoordinatesInterpolator, VTK " VTK_VERSION; }

int cageproof_judge_coordinates(const cageproof_judge_cage* cage, const double* vertices, const int* faces,
                                const double* points, double* coordinates) {
  if (std::strcmp(cage->kind, "mean_value") != 0) return CAGEPROOF_JUDGE_DECLINED;
  vtkNew<vtkPoints> corners;
  corners->SetDataTypeToDouble();
  for (std::size_t v = 0; v < cage->vertex_count; ++v) corners->InsertNextPoint(vertices + 3 * v);
  vtkNew<vtkCellArray> triangles;
  for (std::size_t f = 0; f < cage->face_count; ++f) {
    const vtkIdType corner[3] = {faces[3 * f], faces[3 * f + 1], faces[3 * f + 2]};
    triangles->InsertNextCell(3, corner);
  }
  for (std::size_t p = 0; p < cage->count; ++p)
    vtkMeanValueCoordinatesInterpolator::ComputeInterpolationWeights(points + 3 * p, corners, triangles,
                                                                     coordinates + p * cage->coordinates);
  return CAGEPROOF_JUDGE_DONE;
}

}  // extern "C"
