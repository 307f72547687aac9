// SPDX-License-Identifier: MIT
#include "cageproof/reports/vtk_text.h"

#include "vtk_poly.h"

#include <fmt/format.h>

#include <vtkCellArray.h>
#include <vtkDoubleArray.h>
#include <vtkImageData.h>
#include <vtkNew.h>
#include <vtkObjectFactory.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkXMLImageDataWriter.h>
#include <vtkXMLPolyDataWriter.h>

#include <algorithm>
#include <stdexcept>

namespace cageproof::reports {
namespace {

// VTK's writer stores the range of the vectors' lengths, and its reader takes no infinity or NaN there.
class FiniteRangeArray : public vtkDoubleArray {
 public:
  static FiniteRangeArray* New();
  FiniteRangeArray(const FiniteRangeArray&) = delete;
  FiniteRangeArray& operator=(const FiniteRangeArray&) = delete;

 protected:
  FiniteRangeArray() = default;
  bool ComputeVectorRange(double range[2]) override {
    ComputeFiniteVectorRange(range);
    if (!(range[0] <= range[1])) range[0] = range[1] = 0;
    return true;
  }
};
vtkStandardNewMacro(FiniteRangeArray);

void add_arrays(vtkDataSet& data, const std::vector<ImageField::Array>& arrays) {
  for (const ImageField::Array& array : arrays) {
    vtkNew<FiniteRangeArray> values;
    const std::string name = array.unit.empty() ? array.name : fmt::format("{} [{}]", array.name, array.unit);
    values->SetName(name.c_str());
    values->SetNumberOfComponents(array.components);
    values->SetNumberOfTuples(data.GetNumberOfPoints());
    std::ranges::copy(array.values, values->GetPointer(0));
    data.GetPointData()->AddArray(values);
  }
}

// Into memory, so that the disk is written, and checked, in one place.
template <class Writer, class Data>
std::string text_of(Data& data) {
  vtkNew<Writer> writer;
  writer->SetInputData(&data);
  writer->SetDataModeToBinary();
  writer->WriteToOutputStringOn();
  if (!writer->Write()) throw std::runtime_error("VTK could not write a field into memory");
  return writer->GetOutputString();
}

}  // namespace

std::string vti_text(const ImageField& field) {
  vtkNew<vtkImageData> image;
  image->SetDimensions(field.points.data());
  image->SetOrigin(field.origin.data());
  image->SetSpacing(field.spacing.data());
  add_arrays(*image, field.arrays);
  return text_of<vtkXMLImageDataWriter>(*image);
}

vtkSmartPointer<vtkPolyData> poly_of(const MeshField& field) {
  auto mesh = vtkSmartPointer<vtkPolyData>::New();
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  for (const Vec3<double>& vertex : field.vertices) points->InsertNextPoint(vertex.data());
  mesh->SetPoints(points);
  vtkNew<vtkCellArray> cells;
  for (const std::vector<int>& face : field.faces) {
    cells->InsertNextCell(static_cast<int>(face.size()));
    for (const int vertex : face) cells->InsertCellPoint(vertex);
  }
  if (!field.segments.empty()) {
    vtkNew<vtkCellArray> lines;
    for (const auto& [from, to] : field.segments) {
      lines->InsertNextCell(2);
      lines->InsertCellPoint(from);
      lines->InsertCellPoint(to);
    }
    mesh->SetLines(lines);
  }
  if (field.faces.empty() && field.segments.empty()) {
    for (vtkIdType i = 0; i < points->GetNumberOfPoints(); ++i) cells->InsertNextCell(1, &i);
    mesh->SetVerts(cells);
  } else if (!field.faces.empty()) {
    mesh->SetPolys(cells);
  }
  add_arrays(*mesh, field.arrays);
  return mesh;
}

std::string poly_text(vtkPolyData& data) { return text_of<vtkXMLPolyDataWriter>(data); }

std::string vtp_text(const MeshField& field) { return poly_text(*poly_of(field)); }

}  // namespace cageproof::reports
