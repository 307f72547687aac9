// SPDX-License-Identifier: MIT
#include "cageproof/reports/mesh_thinning.h"

#include <vtkCellArray.h>
#include <vtkQuadricDecimation.h>
#include <vtkIdList.h>
#include <vtkNew.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkTriangleFilter.h>

namespace cageproof::reports {

Mesh thinned(const Mesh& mesh, std::size_t vertices) {
  if (mesh.vertices.size() <= vertices || mesh.faces.empty()) return mesh;
  vtkNew<vtkPolyData> data;
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  for (const Vec3<double>& vertex : mesh.vertices) points->InsertNextPoint(vertex.data());
  vtkNew<vtkCellArray> faces;
  for (const auto& face : mesh.faces) {
    faces->InsertNextCell(static_cast<int>(face.size()));
    for (const int v : face) faces->InsertCellPoint(v);
  }
  data->SetPoints(points);
  data->SetPolys(faces);
  vtkNew<vtkTriangleFilter> triangles;
  triangles->SetInputData(data);
  vtkNew<vtkQuadricDecimation> decimate;
  decimate->SetInputConnection(triangles->GetOutputPort());
  decimate->VolumePreservationOn();
  decimate->SetTargetReduction(1 - static_cast<double>(vertices) / static_cast<double>(mesh.vertices.size()));
  decimate->Update();
  vtkPolyData& thin = *decimate->GetOutput();
  Mesh found;
  for (vtkIdType p = 0; p < thin.GetNumberOfPoints(); ++p) {
    Vec3<double> point;
    thin.GetPoint(p, point.data());
    found.vertices.push_back(point);
  }
  vtkNew<vtkIdList> corners;
  for (vtkIdType f = 0; f < thin.GetNumberOfCells(); ++f) {
    thin.GetCellPoints(f, corners);
    std::vector<int> face;
    for (vtkIdType k = 0; k < corners->GetNumberOfIds(); ++k) face.push_back(static_cast<int>(corners->GetId(k)));
    found.faces.push_back(std::move(face));
  }
  return found;
}

}  // namespace cageproof::reports
