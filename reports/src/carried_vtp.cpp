// SPDX-License-Identifier: MIT
// VTP files with their vertices elsewhere: VTK reads them whole, and writes them with other points.
#include "cageproof/reports/carried_mesh.h"

#include "cageproof/core/input_error.h"
#include "vtk_poly.h"

#include <fmt/format.h>

#include <vtkCellData.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkXMLPolyDataReader.h>

namespace cageproof::reports {
namespace {

// Takes away what depends on places; whether there was any.
bool take_normals(vtkDataSetAttributes& attributes) {
  const int before = attributes.GetNumberOfArrays();
  if (vtkDataArray* const active = attributes.GetNormals()) {
    const char* const name = active->GetName();
    if (name != nullptr) attributes.RemoveArray(name);
    else attributes.SetNormals(nullptr);
  }
  attributes.RemoveArray("Normals");
  return attributes.GetNumberOfArrays() != before;
}

}  // namespace

CarriedMesh vtp_with_vertices(std::string_view text, const MeshField& moved) {
  vtkNew<vtkXMLPolyDataReader> reader;
  reader->ReadFromInputStringOn();
  reader->SetInputString(std::string(text));
  reader->Update();
  vtkPolyData& data = *reader->GetOutput();
  const auto count = static_cast<std::size_t>(data.GetNumberOfPoints());
  if (count != moved.vertices.size())
    throw InputError(fmt::format("the VTP file has {} vertices, and {} were read", count, moved.vertices.size()));
  CarriedMesh carried;
  const bool of_points = take_normals(*data.GetPointData()), of_cells = take_normals(*data.GetCellData());
  if (of_points || of_cells) carried.left_out.emplace_back("normals");
  const auto with = poly_of(moved);
  data.SetPoints(with->GetPoints());
  // What the map says of the points stands beside what the file did, and in place of arrays of the same name.
  for (int i = 0; i < with->GetPointData()->GetNumberOfArrays(); ++i)
    data.GetPointData()->AddArray(with->GetPointData()->GetAbstractArray(i));
  carried.text = poly_text(data);
  return carried;
}

}  // namespace cageproof::reports
