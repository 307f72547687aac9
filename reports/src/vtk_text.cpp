// SPDX-License-Identifier: MIT
#include "cageproof/reports/vtk_text.h"

#include "vtk_poly.h"

#include <fmt/format.h>

#include <vtkCellArray.h>
#include <vtkDoubleArray.h>
#include <vtkFieldData.h>
#include <vtkFloatArray.h>
#include <vtkImageData.h>
#include <vtkNew.h>
#include <vtkObjectFactory.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkStringArray.h>
#include <vtkUnsignedCharArray.h>
#include <vtkXMLImageDataWriter.h>
#include <vtkXMLPolyDataWriter.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>
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

// What ParaView colours by: magnitudes go through 17 decades and more, where only a logarithm shows anything.
void add_logarithm(vtkDataSet& data, const ImageField::Array& array) {
  vtkNew<vtkFloatArray> logarithm;
  vtkNew<vtkUnsignedCharArray> mask;
  logarithm->SetName(log10_name(array.name).c_str());
  mask->SetName(mask_name(array.name).c_str());
  for (const double value : array.values) {
    logarithm->InsertNextValue(static_cast<float>(floored_log10(value)));
    mask->InsertNextValue(std::isfinite(value) ? kHasValue : std::isnan(value) ? kNoValue : kNotFinite);
  }
  data.GetPointData()->AddArray(logarithm);
  data.GetPointData()->AddArray(mask);
}

void add_arrays(vtkDataSet& data, const std::vector<ImageField::Array>& arrays, FieldArrays kept) {
  for (const ImageField::Array& array : arrays) {
    vtkNew<FiniteRangeArray> values;
    const std::string name = array.unit.empty() ? array.name : fmt::format("{} [{}]", array.name, array.unit);
    values->SetName(name.c_str());
    values->SetNumberOfComponents(array.components);
    values->SetNumberOfTuples(data.GetNumberOfPoints());
    std::ranges::copy(array.values, values->GetPointer(0));
    data.GetPointData()->AddArray(values);
    if (kept == FieldArrays::WithLogarithms && array.components == 1 && !array.linear) add_logarithm(data, array);
  }
}

void add_facts(vtkDataSet& data, const FieldFacts& facts) {
  for (const auto& [name, text] : facts) {
    vtkNew<vtkStringArray> fact;
    fact->SetName(name.c_str());
    fact->InsertNextValue(text);
    data.GetFieldData()->AddArray(fact);
  }
}

// Into memory, so that the disk is written, and checked, in one place.
template <class Writer, class Data>
std::string text_of(Data& data) {
  vtkNew<Writer> writer;
  writer->SetInputData(&data);
  // The raw bytes, after the text that describes them.
  writer->SetDataModeToAppended();
  writer->EncodeAppendedDataOff();
  writer->SetCompressorTypeToZLib();
  // Level 9 takes five times as long on arrays that are mostly NaN, for files of the same size.
  writer->SetCompressionLevel(6);
  writer->WriteToOutputStringOn();
  if (!writer->Write()) throw std::runtime_error("VTK could not write a field into memory");
  return writer->GetOutputString();
}

}  // namespace

double floored_log10(double value) {
  if (std::isnan(value)) return value;
  if (std::isinf(value)) return std::log10(std::numeric_limits<double>::max());
  return std::max(kLog10Floor, std::log10(std::abs(value)));
}

std::string log10_name(const std::string& array) { return "log10 " + array; }
std::string mask_name(const std::string& array) { return "mask " + array; }

MeshField geometry_of(MeshField cage) {
  std::set<std::array<int, 2>> edges;
  for (const auto& [from, to] : cage.segments) edges.insert({std::min(from, to), std::max(from, to)});
  for (const std::vector<int>& face : cage.faces)
    for (std::size_t k = 0; k < face.size(); ++k) {
      const int from = face[k], to = face[(k + 1) % face.size()];
      edges.insert({std::min(from, to), std::max(from, to)});
    }
  std::erase_if(cage.faces, [](const std::vector<int>& face) { return face.size() < 3; });
  cage.segments.assign(edges.begin(), edges.end());
  return cage;
}

std::string vti_text(const ImageField& field, FieldArrays arrays) {
  vtkNew<vtkImageData> image;
  image->SetDimensions(field.points.data());
  image->SetOrigin(field.origin.data());
  image->SetSpacing(field.spacing.data());
  add_arrays(*image, field.arrays, arrays);
  add_facts(*image, field.facts);
  return text_of<vtkXMLImageDataWriter>(*image);
}

vtkSmartPointer<vtkPolyData> poly_of(const MeshField& field, FieldArrays arrays) {
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
  add_arrays(*mesh, field.arrays, arrays);
  add_facts(*mesh, field.facts);
  return mesh;
}

std::string poly_text(vtkPolyData& data) { return text_of<vtkXMLPolyDataWriter>(data); }

std::string vtp_text(const MeshField& field, FieldArrays arrays) { return poly_text(*poly_of(field, arrays)); }

}  // namespace cageproof::reports
