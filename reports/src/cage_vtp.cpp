// SPDX-License-Identifier: MIT
#include "cageproof/reports/cage_vtp.h"

#include "cageproof/reports/vtk_text.h"
#include "vtk_poly.h"

#include <vtkCellArray.h>
#include <vtkCellData.h>
#include <vtkDoubleArray.h>
#include <vtkFieldData.h>
#include <vtkIntArray.h>
#include <vtkNew.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkStringArray.h>

#include <algorithm>

namespace cageproof::reports {
namespace {

vtkNew<vtkDoubleArray> vectors(const std::string& name, const std::vector<Vec3<double>>& rows) {
  vtkNew<vtkDoubleArray> array;
  array->SetName(name.c_str());
  array->SetNumberOfComponents(3);
  for (const Vec3<double>& row : rows) array->InsertNextTuple(row.data());
  return array;
}

vtkNew<vtkDoubleArray> numbers(const std::string& name, const std::vector<double>& values) {
  vtkNew<vtkDoubleArray> array;
  array->SetName(name.c_str());
  for (const double x : values) array->InsertNextValue(x);
  return array;
}

// \param width numbers per row; -1 fills up
vtkNew<vtkIntArray> indices(const std::string& name, const std::vector<std::vector<int>>& rows, std::size_t width) {
  vtkNew<vtkIntArray> array;
  array->SetName(name.c_str());
  array->SetNumberOfComponents(static_cast<int>(width));
  for (const std::vector<int>& row : rows)
    for (std::size_t k = 0; k < width; ++k) array->InsertNextValue(k < row.size() ? row[k] : -1);
  return array;
}

std::vector<std::vector<int>> column(const std::vector<int>& values) {
  std::vector<std::vector<int>> rows;
  rows.reserve(values.size());
  for (const int x : values) rows.push_back({x});
  return rows;
}

std::size_t most_corners(const DescribedCage& cage) {
  std::size_t most = 0;
  for (const auto& element : cage.elements) most = std::max(most, element.size());
  return most;
}

const char* measure_of(const DescribedCage& cage) { return cage.dimension == 2 ? "length" : "area"; }

void add_metadata(vtkPolyData& data, const DescribedCage& cage) {
  vtkNew<vtkStringArray> metadata;
  metadata->SetName(std::string(metadata_array).c_str());
  metadata->InsertNextValue(cage.metadata);
  data.GetFieldData()->AddArray(metadata);
}

}  // namespace

std::string cage_vtp_text(const DescribedCage& cage) {
  vtkNew<vtkPolyData> data;
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  for (const Vec3<double>& vertex : cage.vertices) points->InsertNextPoint(vertex.data());
  data->SetPoints(points);
  vtkNew<vtkCellArray> cells;
  for (const std::vector<int>& element : cage.elements) {
    cells->InsertNextCell(static_cast<int>(element.size()));
    for (const int vertex : element) cells->InsertCellPoint(vertex);
  }
  if (cage.dimension == 2) data->SetLines(cells);
  else data->SetPolys(cells);
  data->GetCellData()->AddArray(vectors("normal", cage.normals));
  data->GetCellData()->AddArray(numbers(measure_of(cage), cage.measures));
  data->GetCellData()->AddArray(indices("face", column(cage.faces), 1));
  add_metadata(*data, cage);
  return poly_text(*data);
}

std::string vtp_text_with_cage(const MeshField& field, const DescribedCage& cage) {
  const auto data = poly_of(field);
  vtkFieldData& facts = *data->GetFieldData();
  facts.AddArray(vectors("cage_vertices", cage.vertices));
  facts.AddArray(indices("elements", cage.elements, most_corners(cage)));
  facts.AddArray(indices("element_faces", column(cage.faces), 1));
  facts.AddArray(vectors("element_normals", cage.normals));
  facts.AddArray(numbers(std::string("element_") + measure_of(cage) + "s", cage.measures));
  add_metadata(*data, cage);
  return poly_text(*data);
}

}  // namespace cageproof::reports
