// SPDX-License-Identifier: MIT
#include "cageproof/reports/carried_mesh.h"

#include "cageproof/core/input_error.h"
#include "vtk_poly.h"

#include <fmt/format.h>

#include <vtkAbstractArray.h>
#include <vtkCellData.h>
#include <vtkDataSetAttributes.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkSmartPointer.h>
#include <vtkXMLPolyDataReader.h>

namespace cageproof::reports {
namespace {

bool leave_out_normals(vtkDataSetAttributes& arrays) {
  bool found = false;
  while (vtkAbstractArray* normals = arrays.GetNormals() ? arrays.GetNormals() : arrays.GetAbstractArray("Normals")) {
    for (int i = arrays.GetNumberOfArrays() - 1; i >= 0; --i)
      if (arrays.GetAbstractArray(i) == normals) arrays.RemoveArray(i);
    found = true;
  }
  return found;
}

}  // namespace

CarriedMesh vtp_with_vertices(const std::filesystem::path& file, std::span<const Vec3<double>> vertices,
                              const MeshField& images) {
  vtkNew<vtkXMLPolyDataReader> reader;
  reader->SetFileName(file.c_str());
  reader->Update();
  vtkPolyData& data = *reader->GetOutput();
  if (data.GetNumberOfPoints() != static_cast<vtkIdType>(vertices.size()))
    throw InputError(
        fmt::format("the VTP file has {} vertices, and {} were read", data.GetNumberOfPoints(), vertices.size()));
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  points->SetNumberOfPoints(data.GetNumberOfPoints());
  for (std::size_t i = 0; i < vertices.size(); ++i) points->SetPoint(static_cast<vtkIdType>(i), vertices[i].data());
  data.SetPoints(points);
  CarriedMesh carried;
  const bool of_points = leave_out_normals(*data.GetPointData()), of_cells = leave_out_normals(*data.GetCellData());
  if (of_points || of_cells) carried.left_out.emplace_back("normals");
  const vtkSmartPointer<vtkPolyData> fresh = poly_of(images);
  vtkPointData& added = *fresh->GetPointData();
  for (int i = 0; i < added.GetNumberOfArrays(); ++i) {
    vtkAbstractArray* const array = added.GetAbstractArray(i);
    if (data.GetPointData()->HasArray(array->GetName()))
      carried.replaced.push_back(fmt::format("array {}", array->GetName()));
    data.GetPointData()->AddArray(array);
  }
  carried.text = poly_text(data);
  return carried;
}

}  // namespace cageproof::reports
